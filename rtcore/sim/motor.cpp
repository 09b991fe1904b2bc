// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/motor.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::sim {

namespace {

/// Where the spring saturates; more than what pulses may be off an even motion.
constexpr double kRoom_ratio = 0.125;  ///< of the slip
constexpr double kLeastRoom_pulses = 2.0;
constexpr double kMoment_ratio = 0.125;  ///< of the time in which acceleration leads off by the room

std::int64_t ns_of(double time_s) noexcept {
    return static_cast<std::int64_t>(time_s * static_cast<double>(kNsPerS));
}

}  // namespace

Motor::Motor(const MotorConfig& config, std::int64_t start_pulses) noexcept
    : config_(config),
      spring_s_(std::sqrt(2.0 * config.slip_pulses / config.accel_pps2) / 4.0),
      room_pulses_(std::max(kRoom_ratio * config.slip_pulses, kLeastRoom_pulses)),
      moment_ns_(ns_of(kMoment_ratio * std::sqrt(room_pulses_ / config.accel_pps2))),
      lead_ns_(ns_of(2.0 * std::sqrt(room_pulses_ / config.accel_pps2))),
      settle_ns_(ns_of(std::min(8.0 * spring_s_, 2.0 / config.start_stop_pps))),
      field_pulses_(start_pulses),
      rotor_pulses_(static_cast<double>(start_pulses)) {}

Motor::Outcome Motor::pulse(int sign, std::int64_t time_ns) noexcept {
    // Without a pulse for this long the rotor has swung out and stands; settle() judges how far it ran past
    // its field, not one long step of follow(). Any slow pulse can start it again.
    if (!at_rest_ && time_ns - last_ns_ > settle_ns_) settle();
    follow(sign, time_ns);
    if (out_of_step_) {
        if (std::abs(field_pps_) > config_.start_stop_pps) return Outcome::lost;
        out_of_step_ = false;
    }
    if (moment_count_ == 0) remember(time_ns - lead_ns_);
    field_pulses_ += sign;
    remember(time_ns);
    const double lag_pulses = std::abs(static_cast<double>(field_pulses_) - rotor_pulses_);
    if (lag_pulses <= config_.slip_pulses || take_up_another_motion()) return Outcome::followed;
    fall_out_of_step(rotor_pulses_);
    return Outcome::fell_out_of_step;
}

void Motor::follow(int sign, std::int64_t time_ns) noexcept {
    const double dt_s = seconds_from_ns(time_ns - last_ns_);
    last_ns_ = time_ns;
    if (at_rest_ || dt_s <= 0.0) {
        at_rest_ = false;
        return;
    }
    const double pulse = sign;
    // Pulses no faster than start-stop are followed one by one; others are seen through the rotor's inertia.
    const double slow_pps = config_.start_stop_pps;
    const bool is_slow = 1.0 <= slow_pps * dt_s && std::abs(field_pps_) <= slow_pps;
    if (!speed_known_ || is_slow) {
        field_pps_ = pulse / dt_s;
        speed_known_ = true;
    } else {
        field_pps_ += (pulse - field_pps_ * dt_s) / (spring_s_ / 2.0 + dt_s);
    }
    if (out_of_step_) return;

    // The field jumps a pulse at this edge: half-way is where an even motion would be now.
    const double aim_pulses = static_cast<double>(field_pulses_) + 0.5 * pulse;
    double wanted_pps;
    if (is_slow) {
        wanted_pps = (aim_pulses - rotor_pulses_) / dt_s;
    } else {
        const double spring_s = std::max(spring_s_, 2.0 * dt_s);
        const double lag_pulses = aim_pulses - (rotor_pulses_ + rotor_pps_ * dt_s);
        const double wanted_pps2 =
            lag_pulses / (spring_s * spring_s) + 2.0 * (field_pps_ - rotor_pps_) / spring_s;
        wanted_pps = rotor_pps_ + wanted_pps2 * dt_s;
    }

    const double gain_pps = config_.accel_pps2 * dt_s;
    double lowest_pps = rotor_pps_ - gain_pps;
    double highest_pps = rotor_pps_ + gain_pps;
    // Anything between the two start-stop speeds is free, once the rotor has come down to them.
    if (lowest_pps < config_.start_stop_pps) lowest_pps = std::min(lowest_pps, -config_.start_stop_pps);
    if (highest_pps > -config_.start_stop_pps) highest_pps = std::max(highest_pps, config_.start_stop_pps);
    lowest_pps = std::max(lowest_pps, -config_.speed_pps);
    highest_pps = std::min(highest_pps, config_.speed_pps);

    const double next_pps = std::clamp(wanted_pps, lowest_pps, highest_pps);
    const bool is_jump = std::abs(next_pps - rotor_pps_) > gain_pps;
    rotor_pulses_ += (is_jump ? next_pps : 0.5 * (rotor_pps_ + next_pps)) * dt_s;
    rotor_pps_ = next_pps;
}

/// Comes to rest after the last pulse, with or without the field's hold.
bool Motor::comes_to_rest(bool is_held) noexcept {
    const double excess_pps = std::abs(rotor_pps_) - config_.start_stop_pps;
    double rest_pulses = rotor_pulses_;
    if (!out_of_step_ && excess_pps > 0.0) {
        const double run_out_pulses =
            excess_pps * (excess_pps + 2.0 * config_.start_stop_pps) / (2.0 * config_.accel_pps2);
        rest_pulses += rotor_pps_ > 0.0 ? run_out_pulses : -run_out_pulses;
    }
    bool ran_past = std::abs(rest_pulses - static_cast<double>(field_pulses_)) > config_.slip_pulses;
    if (ran_past && is_held && !out_of_step_) {
        ran_past = !reach_at(last_ns_ + settle_ns_).can_rest();
    }
    if (ran_past) fall_out_of_step(rest_pulses);
    put(field_pulses_);
    return ran_past;
}

void Motor::remember(std::int64_t time_ns) noexcept {
    if (moment_count_ > 0 && time_ns - moments_[(moment_count_ - 1) % kMoments].time_ns < moment_ns_) return;
    moments_[moment_count_++ % kMoments] = {time_ns, field_pulses_};
}

RotorReach::Room Motor::room_at(std::int64_t field_pulses) const noexcept {
    // Relative to the field as it is now, so that the numbers stay small.
    const auto middle = static_cast<double>(field_pulses - field_pulses_);
    return {middle - room_pulses_, middle + room_pulses_};
}

/// All states that the rotor may be in at a time, from the moments kept.
RotorReach Motor::reach_at(std::int64_t time_ns) const noexcept {
    RotorReach reach(config_);
    const std::size_t first = moment_count_ > kMoments ? moment_count_ - kMoments : 0;
    const auto moment = [&](std::size_t i) {
        return i < moment_count_ ? moments_[i % kMoments] : Moment{time_ns, field_pulses_};
    };
    Moment before = moment(first);
    if (first == 0)
        reach.start_at_rest(room_at(before.field_pulses));
    else
        reach.start_anywhere(room_at(before.field_pulses));
    for (std::size_t i = first + 1; i <= moment_count_ && !reach.is_empty(); ++i) {
        const Moment next = moment(i);
        const std::int64_t steps = (next.time_ns - before.time_ns + moment_ns_ - 1) / moment_ns_;
        const RotorReach::Room there = room_at(next.field_pulses);
        const RotorReach::Room here = room_at(before.field_pulses);
        const RotorReach::Room between{std::min(here.low, there.low), std::max(here.high, there.high)};
        const double step_s = seconds_from_ns(next.time_ns - before.time_ns) /
                              static_cast<double>(std::max<std::int64_t>(steps, 1));
        for (std::int64_t step = 1; step <= steps; ++step)
            reach.advance(step_s, step < steps ? between : there);
        before = next;
    }
    return reach;
}

bool Motor::take_up_another_motion() noexcept {
    const RotorReach reach = reach_at(last_ns_);
    if (reach.is_empty()) return false;
    const RotorReach::State state = reach.middle();
    rotor_pulses_ = static_cast<double>(field_pulses_) + state.pulses;
    rotor_pps_ = state.pps;
    return true;
}

void Motor::put(std::int64_t pulses) noexcept {
    field_pulses_ = pulses;
    rotor_pulses_ = static_cast<double>(pulses);
    rotor_pps_ = 0.0;
    field_pps_ = 0.0;
    at_rest_ = true;
    speed_known_ = false;
    out_of_step_ = false;
    moment_count_ = 0;
}

void Motor::fall_out_of_step(double rotor_pulses) noexcept {
    const std::int64_t rotor = round_to_pulse(rotor_pulses);
    slipped_pulses_ = static_cast<std::uint64_t>(std::abs(field_pulses_ - rotor));
    field_pulses_ = rotor;
    rotor_pulses_ = static_cast<double>(rotor);
    rotor_pps_ = 0.0;
    out_of_step_ = true;
    moment_count_ = 0;
}

}  // namespace psicarve::sim
