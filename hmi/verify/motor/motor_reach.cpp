// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/motor/motor_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace psicarve::verify {

namespace {

constexpr double kJoinError_pulses = 2e-3;
constexpr double kRounding_pulses = 1e-9;
constexpr double kRounding_s = 1e-9;

Range hull(Range a, Range b) {
    if (a.is_empty()) return b;
    if (b.is_empty()) return a;
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace

MotorReach::MotorReach(const MotorLimits& limits) : limits_(limits) {
    limits_.jump_pps = std::min(limits_.jump_pps, limits_.speed_pps);
    step_s_ = limits_.step_s();
}

void MotorReach::start_anywhere(Range room) {
    slow_ = room;
    full_s_ = 0.0;
    is_settled_ = false;
    up_.count = down_.count = 0;
    add(up_, StateSet::box(room, {limits_.jump_pps, limits_.speed_pps}));
    add(down_, StateSet::box(mirrored(room), {limits_.jump_pps, limits_.speed_pps}));
}

void MotorReach::start_slow(Range positions) {
    slow_ = positions;
    full_s_ = 0.0;
    is_settled_ = false;
    up_.count = down_.count = 0;
}

void MotorReach::start_running(const StateSet& states, bool is_upward) {
    start_slow(Range::none());
    add(is_upward ? up_ : down_, states);
}

const StateSet& MotorReach::running(bool is_upward) const noexcept {
    static const StateSet kNone;
    const Branch& branch = is_upward ? up_ : down_;
    return branch.count > 0 ? branch.sets[0] : kNone;
}

void MotorReach::run(double time_s, Range room) {
    while (time_s > 0.0 && !is_settled_ && !is_empty()) {
        const double step_s = std::min({time_s, step_s_, slowed_after_s()});
        step(step_s, room);
        time_s -= step_s;
    }
}

/// When the next set may have come down to the slow speeds. A step ends there: from then on it may turn back.
double MotorReach::slowed_after_s() const noexcept {
    double least_s = step_s_;
    for (const Branch* branch : {&up_, &down_}) {
        for (std::size_t i = 0; i < branch->count; ++i) {
            const double fall_pps = branch->sets[i].slowest() - limits_.jump_pps;
            if (fall_pps > 0.0) least_s = std::min(least_s, fall_pps / limits_.accel_pps2 + kRounding_s);
        }
    }
    return least_s;
}

void MotorReach::step(double time_s, Range room) {
    const Range before = slow_;
    const bool is_held_up = holds_row(up_, before);
    const bool is_held_down = holds_row(down_, mirrored(before));
    const Range fed_up = run_branch(up_, time_s, room.high);
    const Range fed_down = run_branch(down_, time_s, -room.low);
    if (before.is_empty() && fed_up.is_empty() && fed_down.is_empty()) return;
    Range now = hull(fed_up, mirrored(fed_down));
    if (!before.is_empty()) {
        const double way = limits_.jump_pps * time_s;
        now = hull(common({before.low - way, before.high + way}, room), now);
        launch(up_, {before, now, is_held_up}, time_s, room.high);
        launch(down_, {mirrored(before), mirrored(now), is_held_down}, time_s, -room.low);
    }
    slow_ = now;
    const bool is_full = before.low <= room.low && before.high >= room.high;
    full_s_ = is_full ? full_s_ + time_s : 0.0;
    if (is_full && full_s_ * limits_.accel_pps2 >= most_in_room_pps(room) - limits_.jump_pps) settle(room);
}

/// The greatest speed that a motor reaches inside a room from start-stop speed.
double MotorReach::most_in_room_pps(Range room) const noexcept {
    return std::min(limits_.speed_pps, std::sqrt(limits_.jump_pps * limits_.jump_pps +
                                                 2.0 * limits_.accel_pps2 * (room.high - room.low)));
}

// Slow states first fill the room, in steps: the one that fills it does not count yet, and the last may be
// longer than is asked for. Where a step could lead below the room, its rows are not the room itself.
double MotorReach::surely_settled_after_s(Range slow, Range room) const noexcept {
    constexpr double kMargin_pulses = 0.25;  // many times what sets leave out
    constexpr double kMarginSteps = 3.0;
    const bool stays_inside = limits_.jump_pps >= 0.5 * limits_.accel_pps2 * step_s_;
    if (!stays_inside || slow.high - slow.low < 2.0 * kMargin_pulses)
        return std::numeric_limits<double>::infinity();
    const double way = std::max(slow.low - room.low, room.high - slow.high) + kMargin_pulses;
    return way / limits_.jump_pps + (most_in_room_pps(room) - limits_.jump_pps) / limits_.accel_pps2 +
           kMarginSteps * step_s_;
}

/// Whether the newest set has all these positions at the slowest speed.
bool MotorReach::holds_row(const Branch& branch, Range row) const noexcept {
    if (branch.count == 0) return false;
    const StateSet& newest = branch.sets[branch.count - 1];
    if (newest.slowest() > limits_.jump_pps) return false;
    const Range held = newest.slowest_row();
    return held.low <= row.low + kRounding_pulses && held.high >= row.high - kRounding_pulses;
}

/// Positions that came down to the slow speeds.
Range MotorReach::run_branch(Branch& branch, double time_s, double far_wall) {
    Range fed = Range::none();
    for (std::size_t i = 0; i < branch.count; ++i) {
        StateSet& set = branch.sets[i];
        set.run(time_s, limits_.accel_pps2, limits_.speed_pps);
        set.keep_below(far_wall);
        if (!set.is_empty() && set.slowest() <= limits_.jump_pps) {
            set.keep_speeds({limits_.jump_pps, limits_.speed_pps});
            if (!set.is_empty()) fed = hull(fed, set.slowest_row());
        } else {
            set.keep_speeds({limits_.jump_pps, limits_.speed_pps});
        }
    }
    drop_empty(branch);
    return fed;
}

/// The states that left the slow speeds during this step.
void MotorReach::launch(Branch& branch, const Launch& row, double time_s, double far_wall) {
    const Range start{limits_.jump_pps, limits_.jump_pps};
    if (limits_.speed_pps <= limits_.jump_pps) return;
    // Where a set held this row before, it now holds the states that left at the step's begin: only the row
    // is new.
    if (row.is_held && branch.count > 0) {
        StateSet& newest = branch.sets[branch.count - 1];
        const double exact_from = limits_.jump_pps + 0.999 * limits_.accel_pps2 * time_s;
        if (newest.slowest() <= limits_.jump_pps &&
            newest.extend_slowest(row.now, exact_from, kJoinError_pulses))
            return;
    }
    StateSet fresh = StateSet::box(row.from, start);
    fresh.run(time_s, limits_.accel_pps2, limits_.speed_pps);
    fresh.keep_speeds({limits_.jump_pps, limits_.speed_pps});
    // Joined before it is cut: states that turned back near the wall may have done so a little later, off it.
    fresh.join(StateSet::box(row.now, start));
    fresh.keep_below(far_wall);
    add(branch, fresh);
}

void MotorReach::add(Branch& branch, const StateSet& set) {
    if (set.is_empty()) return;
    for (std::size_t i = branch.count; i-- > 0;) {
        if (branch.sets[i].try_join(set, kJoinError_pulses)) return;
    }
    if (branch.count < kMostSets) {
        branch.sets[branch.count++] = set;
        return;
    }
    widest_joint_ = 1.0;
    branch.sets[kMostSets - 1].join(set);
}

void MotorReach::drop_empty(Branch& branch) noexcept {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < branch.count; ++i) {
        if (branch.sets[i].is_empty()) continue;
        if (kept != i) branch.sets[kept] = branch.sets[i];
        ++kept;
    }
    branch.count = kept;
}

void MotorReach::settle(Range room) {
    up_.count = down_.count = 0;
    add(up_, StateSet::rest(room, limits_.jump_pps, limits_.speed_pps, limits_.accel_pps2));
    add(down_, StateSet::rest(mirrored(room), limits_.jump_pps, limits_.speed_pps, limits_.accel_pps2));
    is_settled_ = true;
}

void MotorReach::cut_branch(Branch& branch, Range room) {
    for (std::size_t i = 0; i < branch.count; ++i) {
        branch.sets[i].keep_below(room.high);
        branch.sets[i].keep_above(room.low);
    }
    drop_empty(branch);
    // What a wall cut off may have been all that kept two sets from being convex together.
    if (branch.count > 1 &&
        branch.sets[branch.count - 2].try_join(branch.sets[branch.count - 1], kJoinError_pulses))
        --branch.count;
}

void MotorReach::cut(Range room) {
    slow_ = common(slow_, room);
    cut_branch(up_, room);
    cut_branch(down_, mirrored(room));
    full_s_ = 0.0;
    is_settled_ = false;
}

void MotorReach::jump() {
    const Range slow = slow_;
    const double jump_pps = limits_.jump_pps;
    const auto spread = [&](Branch& branch, Range from) {
        Range fed = Range::none();
        for (std::size_t i = 0; i < branch.count; ++i) {
            StateSet& set = branch.sets[i];
            set.jump(jump_pps);
            StateSet slowed = set;
            slowed.keep_speeds({-limits_.speed_pps, jump_pps});
            if (!slowed.is_empty()) fed = hull(fed, slowed.positions());
            set.keep_speeds({jump_pps, limits_.speed_pps});
        }
        drop_empty(branch);
        add(branch, StateSet::box(from, {jump_pps, std::min(2.0 * jump_pps, limits_.speed_pps)}));
        return fed;
    };
    const Range from_up = spread(up_, slow);
    const Range from_down = mirrored(spread(down_, mirrored(slow)));
    slow_ = hull(slow, hull(from_up, from_down.low > from_down.high ? Range::none() : from_down));
    full_s_ = 0.0;
    is_settled_ = false;
}

}  // namespace psicarve::verify
