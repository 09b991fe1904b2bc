// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/motor/motion_witness.hpp"

#include <algorithm>

#include "shared/base/units.hpp"

namespace psicarve::verify {

void MotionWitness::start_slow(Range positions, std::int64_t time_ns, std::int64_t count) {
    is_slow_ = true;
    is_anywhere_ = false;
    is_whole_ = false;
    slow_ = positions;
    time_ns_ = time_ns;
    count_ = count;
}

void MotionWitness::start_running(const StateSet& states, bool is_whole, bool is_upward, std::int64_t time_ns,
                                  std::int64_t count) {
    is_whole_ = is_whole;
    is_slow_ = false;
    is_upward_ = is_upward;
    running_ = states;
    time_ns_ = time_ns;
    count_ = count;
}

bool MotionWitness::take(const TrainEvent& event) {
    const double time_s = seconds_from_ns(event.time_ns - time_ns_);
    if (!(is_slow_ ? take_slow(event, time_s) : take_running(event, time_s))) return false;
    time_ns_ = event.time_ns;
    count_ = event.count_after(count_);
    return true;
}

bool MotionWitness::take_slow(const TrainEvent& event, double time_s) {
    const double way = limits_.jump_pps * time_s;
    const Range room = room_at(count_);
    slow_ = common({slow_.low - way, slow_.high + way}, room);
    is_anywhere_ = slow_.low <= room.low && slow_.high >= room.high;
    if (event.is_pulse()) slow_ = common(slow_, room_between(count_, event.count_after(count_)));
    return !slow_.is_empty();
}

bool MotionWitness::take_running(const TrainEvent& event, double time_s) {
    const double step_s = limits_.step_s();
    const Range speeds{limits_.jump_pps, limits_.speed_pps};
    while (time_s > 0.0 && !running_.is_empty()) {
        running_.run(std::min(time_s, step_s), limits_.accel_pps2, limits_.speed_pps);
        is_whole_ = is_whole_ && running_.slowest() >= speeds.low;
        running_.keep_speeds(speeds);
        time_s -= step_s;
        running_.keep_below(is_upward_ ? room_at(count_).high : -room_at(count_).low);
    }
    if (running_.is_empty()) return false;
    if (event.kind == TrainEvent::Kind::joint) {
        running_.jump(limits_.jump_pps);
        is_whole_ = is_whole_ && running_.slowest() >= speeds.low;
        running_.keep_speeds(speeds);
        return !running_.is_empty();
    }
    if (!event.is_pulse()) return true;
    const Range edge = room_between(count_, event.count_after(count_));
    const Range room = is_upward_ ? edge : mirrored(edge);
    running_.keep_below(room.high);
    running_.keep_above(room.low);
    return !running_.is_empty();
}

Range MotionWitness::slow_positions() const noexcept {
    if (is_slow_) return slow_;
    if (running_.is_empty() || running_.slowest() > limits_.jump_pps) return Range::none();
    const Range row = running_.slowest_row();
    return common(is_upward_ ? row : mirrored(row), room_at(count_));
}

void MotionWitness::hand_to(MotorReach& reach) const {
    if (is_slow_)
        reach.start_slow(slow_);
    else
        reach.start_running(running_, is_upward_);
}

}  // namespace psicarve::verify
