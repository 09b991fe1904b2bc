// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/motor_rule.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "hmi/verify/motor/train_demand.hpp"
#include "shared/base/units.hpp"

namespace psicarve::verify {

namespace {

/// Sets of states are exact to less than this: every reported offence is one.
constexpr double kTolerance_ratio = 1.001;
constexpr std::size_t kHistory = 2048;  ///< pulses that a demand is measured on
constexpr std::size_t kGathered = 512;  ///< of them after the offence
constexpr std::int64_t kGather_ns = 100'000'000;
constexpr SignalWord kLimitMask =
    bit_of(Signal::r1_limit) | bit_of(Signal::r2_limit) | bit_of(Signal::y_limit);

}  // namespace

MotorRule::MotorRule(const Profile& profile, OffenceLog& log) : log_(log) {
    log_.set_judged(3);
    has_joints_ = profile.job.planner == Planner::angle;
    const bool two_timer = profile.tick.schedule == Schedule::two_timer;
    reaction_ns_ = round_to_pulse((two_timer ? profile.tick.io_us : profile.tick.period_us) *
                                  static_cast<double>(kNsPerUs));
    filter_ns_ = round_to_pulse(profile.port.input_filter_us * static_cast<double>(kNsPerUs));
    for (const Axis axis : kAllAxes) {
        const AxisMotion motion = axis_motion(profile, axis);
        Train& train = trains_[index_of(axis)];
        train.limits = {.accel_pps2 = kTolerance_ratio * motion.accel_pps2,
                        .speed_pps = kTolerance_ratio * motion.speed_pps,
                        .jump_pps = motion.start_stop_pps};
        train.pulses_per_unit = motion.pulses_per_unit;
        train.history.resize(kHistory);
    }
}

void MotorRule::begin(std::int64_t period_ns) {
    reaction_ns_ = std::max(reaction_ns_, period_ns);
    for (const Axis axis : kAllAxes) {
        trains_[index_of(axis)].follower = TrainFollower(trains_[index_of(axis)].limits, 0);
        take(axis, {{0, TrainEvent::Kind::pause}, {}});
    }
}

void MotorRule::pulse(Axis axis, bool positive, std::int64_t time_ns, const CarvePlace& place) {
    take(axis, {{time_ns, positive ? TrainEvent::Kind::forward : TrainEvent::Kind::backward}, place});
}

void MotorRule::point_reached(std::int64_t time_ns, const CarvePlace& place) {
    if (!has_joints_) return;
    for (const Axis axis : kAllAxes) take(axis, {{time_ns, TrainEvent::Kind::joint}, place});
}

void MotorRule::take(Axis axis, const Entry& entry) {
    Train& train = trains_[index_of(axis)];
    if (entry.event.time_ns < train.silent_until_ns) return;
    train.history[train.entries++ % kHistory] = entry;
    if (!train.follower.take(entry.event)) found(train, entry);
    if (!train.is_broken) return;
    if (++train.gathered > kGathered || entry.event.time_ns > train.broken_at.event.time_ns + kGather_ns)
        describe(axis);
}

void MotorRule::found(Train& train, const Entry& entry) {
    if (!log_.count(3, entry.event.time_ns) || train.is_broken) return;
    train.is_broken = true;
    train.broken_at = entry;
    train.gathered = 0;
}

void MotorRule::forget(Axis axis, std::int64_t until_ns) {
    Train& train = trains_[index_of(axis)];
    describe(axis);
    train.entries = 0;
    train.silent_until_ns = until_ns;
    train.follower.start_anew(until_ns);
    take(axis, {{until_ns, TrainEvent::Kind::pause}, {}});  // a demand is measured from here on
}

void MotorRule::levels_changed(SignalWord before, SignalWord now, std::int64_t time_ns) {
    const SignalWord rose = now & ~before;
    const bool stops = (rose & bit_of(Signal::estop)) != 0;
    const bool limits = (rose & kLimitMask) != 0;
    for (const Axis axis : kAllAxes) {
        if (limits)
            forget(axis, time_ns + filter_ns_ + reaction_ns_);
        else if (stops)
            forget(axis, time_ns + reaction_ns_);
        else if (((before ^ now) & bit_of(enable_of(axis))) != 0)
            forget(axis, std::max(time_ns, trains_[index_of(axis)].silent_until_ns));
    }
}

void MotorRule::finish(std::int64_t time_ns) {
    for (const Axis axis : kAllAxes) {
        const Train& train = trains_[index_of(axis)];
        const CarvePlace place =
            train.entries > 0 ? train.history[(train.entries - 1) % kHistory].place : CarvePlace{};
        take(axis, {{time_ns, TrainEvent::Kind::pause}, place});
        describe(axis);
    }
}

/// Once enough of the following events are known, reports the demand around the offence.
void MotorRule::describe(Axis axis) {
    Train& train = trains_[index_of(axis)];
    if (!std::exchange(train.is_broken, false)) return;
    const auto& first = log_.result(3).first;
    if (first && first->time_ns <= train.broken_at.event.time_ns) return;
    std::vector<TrainEvent> stretch;
    const std::uint64_t known = std::min<std::uint64_t>(train.entries, kHistory);
    for (std::uint64_t i = train.entries - known; i < train.entries; ++i)
        stretch.push_back(train.history[i % kHistory].event);
    const TrainDemand demand = demand_of(stretch, train.limits);
    const std::string unit = axis == Axis::psi ? "deg" : "mm";
    Offence offence;
    offence.rule = 3;
    offence.fault = demand.is_speed ? "speed" : "acceleration";
    offence.axis = axis;
    offence.time_ns = train.broken_at.event.time_ns;
    offence.measured = demand.needed / train.pulses_per_unit;
    offence.allowed = (demand.is_speed ? train.limits.speed_pps : train.limits.accel_pps2) /
                      (kTolerance_ratio * train.pulses_per_unit);
    offence.unit = unit + (demand.is_speed ? "/s" : "/s2");
    offence.sentence = shown_name(axis) + " asks its motor for more " + offence.fault + " than it has";
    log_.describe(std::move(offence), train.broken_at.place);
}

}  // namespace psicarve::verify
