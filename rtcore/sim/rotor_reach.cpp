// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/rotor_reach.hpp"

#include <algorithm>
#include <cmath>

namespace psicarve::sim {

namespace {

using State = RotorReach::State;

/// Twice the area of a triangle, positive when it turns left.
double turn(const State& a, const State& b, const State& c) noexcept {
    return (b.pulses - a.pulses) * (c.pps - a.pps) - (b.pps - a.pps) * (c.pulses - a.pulses);
}

using Room = RotorReach::Room;

constexpr Room kNowhere{1.0, 0.0};

Room joined(Room a, Room b) noexcept {
    if (a.low > a.high) return b;
    if (b.low > b.high) return a;
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace

RotorReach::RotorReach(const MotorConfig& config) noexcept
    : config_(config), slow_pps_(std::min(config.start_stop_pps, config.speed_pps)) {}

void RotorReach::start_at_rest(Room room) noexcept {
    slow_ = room;
    up_.size = down_.size = 0;
}

void RotorReach::start_anywhere(Room room) noexcept {
    start_at_rest(room);
    up_.at = {State{room.low, slow_pps_}, State{room.high, slow_pps_}, State{room.high, config_.speed_pps},
              State{room.low, config_.speed_pps}};
    down_.at = {State{room.low, -config_.speed_pps}, State{room.high, -config_.speed_pps},
                State{room.high, -slow_pps_}, State{room.low, -slow_pps_}};
    up_.size = down_.size = 4;
}

void RotorReach::advance(double time_s, Room room) noexcept {
    const Room from_up = advance_branch(up_, 1.0, time_s, room);
    const Room from_down = advance_branch(down_, -1.0, time_s, room);
    if (can_rest()) {
        const double way_pulses = slow_pps_ * time_s;
        slow_ = {std::max(slow_.low - way_pulses, room.low), std::min(slow_.high + way_pulses, room.high)};
    }
    slow_ = joined(slow_, joined(from_up, from_down));
}

// What acceleration can add in a time T lies between two parabolas from -(aT^2/2, aT) to (aT^2/2, aT); their
// middles are +-(aT^2/4, 0).
/// Returns the positions at which it came down to the slow speeds.
RotorReach::Room RotorReach::advance_branch(Corners& branch, double sign, double time_s,
                                            Room room) const noexcept {
    Corners from = branch;
    if (can_rest()) {
        from.add({slow_.low, sign * slow_pps_});
        from.add({slow_.high, sign * slow_pps_});
    }
    const double gain_pps = config_.accel_pps2 * time_s;
    branch.size = 0;
    for (std::size_t i = 0; i < from.size; ++i) {
        const State moved{from.at[i].pulses + from.at[i].pps * time_s, from.at[i].pps};
        for (const double part : {-1.0, 1.0}) {
            branch.add({moved.pulses + part * 0.5 * gain_pps * time_s, moved.pps + part * gain_pps});
            branch.add({moved.pulses + part * 0.25 * gain_pps * time_s, moved.pps});
        }
    }
    branch.take_hull();
    branch.clip(1.0, 0.0, room.high);
    branch.clip(-1.0, 0.0, -room.low);
    branch.clip(0.0, sign, config_.speed_pps);
    branch.clip(0.0, -sign, -slow_pps_);
    branch.reduce();
    Room slowed = kNowhere;
    for (std::size_t i = 0; i < branch.size; ++i) {
        const State& corner = branch.at[i];
        if (sign * corner.pps <= slow_pps_ * (1.0 + 1e-9))
            slowed = joined(slowed, {corner.pulses, corner.pulses});
    }
    return slowed;
}

/// The convex hull of the corners (Andrew's monotone chain).
void RotorReach::Corners::take_hull() noexcept {
    if (size < 3) return;
    const auto end = at.begin() + static_cast<std::ptrdiff_t>(size);
    std::sort(at.begin(), end, [](const State& a, const State& b) {
        return a.pulses != b.pulses ? a.pulses < b.pulses : a.pps < b.pps;
    });
    const Corners from = *this;
    size = 0;
    const auto add_turning = [this](const State& state, std::size_t least) {
        while (size >= least && turn(at[size - 2], at[size - 1], state) <= 0.0) --size;
        add(state);
    };
    for (std::size_t i = 0; i < from.size; ++i) add_turning(from.at[i], 2);
    const std::size_t upper = size + 1;
    for (std::size_t i = from.size - 1; i-- > 0;) add_turning(from.at[i], upper);
    --size;  // the first again
}

/// Drops the corners that stand out least.
void RotorReach::Corners::reduce() noexcept {
    while (size > kCorners) {
        std::size_t least = 0;
        double least_area = -1.0;
        for (std::size_t i = 0; i < size; ++i) {
            const double area = turn(at[(i + size - 1) % size], at[i], at[(i + 1) % size]);
            if (least_area >= 0.0 && area >= least_area) continue;
            least = i;
            least_area = area;
        }
        std::copy(at.begin() + static_cast<std::ptrdiff_t>(least) + 1,
                  at.begin() + static_cast<std::ptrdiff_t>(size),
                  at.begin() + static_cast<std::ptrdiff_t>(least));
        --size;
    }
}

void RotorReach::Corners::clip(double pulses, double pps, double limit) noexcept {
    const Corners from = *this;
    size = 0;
    for (std::size_t i = 0; i < from.size; ++i) {
        const State& here = from.at[i];
        const State& next = from.at[(i + 1) % from.size];
        const double over = pulses * here.pulses + pps * here.pps - limit;
        const double next_over = pulses * next.pulses + pps * next.pps - limit;
        if (over <= 0.0) add(here);
        if ((over < 0.0 && next_over > 0.0) || (over > 0.0 && next_over < 0.0)) {
            const double share = over / (over - next_over);
            add({here.pulses + share * (next.pulses - here.pulses),
                 here.pps + share * (next.pps - here.pps)});
        }
    }
}

RotorReach::State RotorReach::middle() const noexcept {
    const Corners& fast = up_.size >= down_.size ? up_ : down_;
    if (fast.size == 0) return {0.5 * (slow_.low + slow_.high), 0.0};
    State sum{0.0, 0.0};
    for (std::size_t i = 0; i < fast.size; ++i) {
        sum.pulses += fast.at[i].pulses;
        sum.pps += fast.at[i].pps;
    }
    const auto count = static_cast<double>(fast.size);
    return {sum.pulses / count, sum.pps / count};
}

}  // namespace psicarve::sim
