// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/motor/train_follower.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "shared/base/units.hpp"

namespace psicarve::verify {

namespace {
constexpr int kLeastPatience = 4;
constexpr int kMostPatience = 256;
// How many events back another witness is tried, those that carried furthest in carvings first: one that left
// the slow speeds too late, or too early, has little room.
constexpr std::array<std::size_t, 14> kTurns{4, 3, 6, 2, 8, 1, 12, 10, 5, 16, 24, 32, 48, 64};
constexpr std::size_t kFarthestTurn = *std::max_element(kTurns.begin(), kTurns.end());
}  // namespace

TrainFollower::TrainFollower(const MotorLimits& limits, std::int64_t begin_ns)
    : reach_(limits), reached_ns_(begin_ns), witness_(reach_.limits()) {
    start_anew(begin_ns);
}

void TrainFollower::start_anew(std::int64_t time_ns) {
    reached_ns_ = time_ns;
    count_ = 0;  // positions stay small, whatever the axis counts
    patience_ = kLeastPatience;
    late_count_ = 0;
    earlier_count_ = 0;
    has_witness_ = false;
    open_window();
    reach_.start_anywhere(room_at(count_));
}

/// All states that are possible after an event.
void TrainFollower::step(const TrainEvent& event) {
    if (event.time_ns > reached_ns_)
        reach_.run(seconds_from_ns(event.time_ns - reached_ns_), room_at(count_));
    reached_ns_ = event.time_ns;
    if (event.kind == TrainEvent::Kind::joint) {
        reach_.jump();
        return;
    }
    if (!event.is_pulse()) return;
    reach_.cut(room_between(count_, event.count_after(count_)));
    count_ = event.count_after(count_);
}

bool TrainFollower::take(const TrainEvent& event) {
    if (has_witness_) {
        const bool has_room = late_count_ < kMostLate || earlier_count_ > 0;
        if (has_room && (witness_.take(event) || turn(event))) {
            keep_late(event);
            return true;
        }
        if (has_room) patience_ = std::min(2 * patience_, kMostPatience);
        catch_up();
    }
    step(event);
    if (reach_.is_empty()) {
        start_anew(event.time_ns);
        return false;
    }
    if (event.is_pulse()) choose_witness();
    return true;
}

/// Tries the witness that suits the way of the last pulses.
void TrainFollower::choose_witness() {
    if (++window_pulses_ < patience_) return;
    const double slow_way = reach_.limits().jump_pps * seconds_from_ns(reached_ns_ - window_ns_);
    const bool is_slow = static_cast<double>(std::abs(count_ - window_count_)) <= slow_way;
    open_window();
    if (is_slow) {
        if (reach_.slow().is_empty()) return;
        witness_.start_slow(reach_.slow(), reached_ns_, count_);
    } else {
        const bool is_upward = !reach_.running(true).is_empty();
        const StateSet& states = reach_.running(is_upward);
        if (states.is_empty()) return;
        witness_.start_running(states, reach_.is_running_only(), is_upward, reached_ns_, count_);
    }
    has_witness_ = true;
    has_turned_ = false;
}

void TrainFollower::open_window() {
    window_pulses_ = 0;
    window_ns_ = reached_ns_;
    window_count_ = count_;
}

TrainFollower::Late TrainFollower::late(const TrainEvent& event, const MotionWitness& witness) const {
    return {event, witness.slow_positions(), witness.count(), witness.is_anywhere()};
}

/// Half of the late events stand between `earlier_` and being forgotten. A witness that turned into the other
/// kind covers only the motions that did so just then; it replaces the others once it is slow and may be
/// anywhere.
void TrainFollower::choose_earlier() {
    constexpr std::size_t kHalf = kMostLate / 2;
    if (earlier_count_ > 0) return;
    if (!has_turned_) {
        if (late_count_ < (witness_.is_whole() ? kFewLate : kHalf)) return;
        earlier_ = witness_;
        earlier_count_ = late_count_;
        return;
    }
    if (late_count_ == kHalf) choose_anywhere();
}

/// Searches the first half alone: later ones stand too near to the end. Requires a motor that was slow for so
/// long that any faster state before has come down to start-stop speed, or left the room: from each speed u
/// above it a motor stops in the time u/a and on the way u^2/2a, which is no longer than the room.
void TrainFollower::choose_anywhere() {
    const double room_pulses = 2.0 * kHalfRoom_pulses;
    const double settled_s = std::sqrt(2.0 * room_pulses / reach_.limits().accel_pps2);
    std::size_t last = kMostLate;  // of an unbroken row of them
    for (std::size_t i = kMostLate / 2; i-- > 0;) {
        if (!late_[i].is_anywhere) {
            last = kMostLate;
            continue;
        }
        if (last == kMostLate) last = i;
        if (seconds_from_ns(late_[last].event.time_ns - late_[i].event.time_ns) < settled_s) continue;
        earlier_ = slow_witness(i);
        earlier_count_ = i + 1;
        return;
    }
}

void TrainFollower::keep_late(const TrainEvent& event) {
    const Late now = late(event, witness_);
    // An axis that stands passes many joints: the first and the last of them suffice.
    const auto is_joint = [this](std::size_t back) {
        return late_[late_count_ - back].event.kind == TrainEvent::Kind::joint;
    };
    if (late_count_ >= earlier_count_ + 2 && event.kind == TrainEvent::Kind::joint && is_joint(1) &&
        is_joint(2)) {
        late_[late_count_ - 1] = now;
        return;
    }
    if (late_count_ == kMostLate) forget_earlier();
    late_[late_count_++] = now;
    choose_earlier();
    // A witness that left no motion out is as good as all states.
    if (earlier_count_ > 0 && earlier_.is_whole()) forget_earlier();
}

/// The witness ended with this event: replaces it by another one, which was no faster than start-stop after
/// some earlier event. Uses only events since `earlier_`, which covers all before it.
bool TrainFollower::turn(const TrainEvent& event) {
    const bool is_slow = witness_.is_slow();
    for (const std::size_t back : kTurns) {
        if (back > late_count_ - earlier_count_) continue;
        const std::size_t index = late_count_ - back;
        if (late_[index].slow.is_empty()) continue;
        if (!is_slow && go_on(slow_witness(index), index, event)) return true;
        if (go_on(running_witness(index, event), index, event)) return true;
    }
    return false;
}

MotionWitness TrainFollower::slow_witness(std::size_t index) const {
    const Late& from = late_[index];
    MotionWitness slow(reach_.limits());
    slow.start_slow(from.slow, from.event.time_ns, from.count);
    return slow;
}

/// A witness that becomes faster than start-stop just then, towards the event.
MotionWitness TrainFollower::running_witness(std::size_t index, const TrainEvent& event) const {
    const Late& from = late_[index];
    const bool is_upward = event.count_after(late_[late_count_ - 1].count) >= from.count;
    const double jump_pps = reach_.limits().jump_pps;
    const Range positions = is_upward ? from.slow : mirrored(from.slow);
    MotionWitness running(reach_.limits());
    running.start_running(StateSet::box(positions, {jump_pps, jump_pps}), false, is_upward,
                          from.event.time_ns, from.count);
    return running;
}

/// Follows a witness from behind late_[index] up to the event. If it lasts that long it becomes the witness.
bool TrainFollower::go_on(MotionWitness witness, std::size_t index, const TrainEvent& event) {
    std::array<Late, kFarthestTurn> again{};
    const std::size_t first = index + 1;
    for (std::size_t i = first; i < late_count_; ++i) {
        if (!witness.take(late_[i].event)) return false;
        again[i - first] = late(late_[i].event, witness);
    }
    if (!witness.take(event)) return false;
    std::copy_n(again.begin(), late_count_ - first, late_.begin() + static_cast<std::ptrdiff_t>(first));
    witness_ = witness;
    has_turned_ = true;
    return true;
}

/// Forgets events that have no effect any more: the witness of that time replaces them.
void TrainFollower::forget_earlier() {
    earlier_.hand_to(reach_);
    reached_ns_ = earlier_.time_ns();
    count_ = earlier_.count();
    std::copy(late_.begin() + static_cast<std::ptrdiff_t>(earlier_count_),
              late_.begin() + static_cast<std::ptrdiff_t>(late_count_), late_.begin());
    late_count_ -= earlier_count_;
    earlier_count_ = 0;
    patience_ = kLeastPatience;
    if (has_turned_ && late_count_ >= kMostLate / 2) choose_anywhere();
}

/// Index of the last late event behind which nothing happened for so long that every state became possible:
/// events before it have no effect, to the last bit. The number of late events where there is none.
std::size_t TrainFollower::last_settled() const {
    for (std::size_t i = late_count_; i-- > 1;) {
        const Late& before = late_[i - 1];
        const double quiet_s = seconds_from_ns(late_[i].event.time_ns - before.event.time_ns);
        if (quiet_s >= reach_.surely_settled_after_s(before.slow, room_at(before.count))) return i - 1;
    }
    return late_count_;
}

void TrainFollower::catch_up() {
    std::size_t first = 0;
    if (const std::size_t settled = last_settled(); settled < late_count_) {
        reached_ns_ = late_[settled].event.time_ns;
        count_ = late_[settled].count;
        reach_.start_anywhere(room_at(count_));
        first = settled + 1;
    }
    has_witness_ = false;
    for (std::size_t i = first; i < late_count_; ++i) step(late_[i].event);
    late_count_ = 0;
    earlier_count_ = 0;
    open_window();
}

bool TrainFollower::wait(std::int64_t time_ns) {
    if (has_witness_) catch_up();
    if (time_ns > reached_ns_) reach_.run(seconds_from_ns(time_ns - reached_ns_), room_at(count_));
    reached_ns_ = time_ns;
    if (!reach_.is_empty()) return true;
    start_anew(time_ns);
    return false;
}

}  // namespace psicarve::verify
