// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/axis_unit.hpp"

#include <algorithm>

namespace psicarve::sim {

AxisUnit::AxisUnit(const AxisConfig& config, const DriverTiming& timing) noexcept
    : config_(config),
      timing_(timing),
      motor_(config.motor, config.start_pulses),
      sensor_(config.sensor, config.pulses_per_turn, config.start_pulses),
      motor_pulses_(config.start_pulses),
      load_pulses_(config.start_pulses) {}

void AxisUnit::set_direction(bool positive, std::int64_t time_ns) noexcept {
    if (last_pulse_counts_ && time_ns - step_rose_ns_ < timing_.dir_hold_ns) lose_last_pulse(lost_dir_hold_);
    direction_ = positive ? 1 : -1;
    direction_changed_ns_ = time_ns;
}

void AxisUnit::set_enabled(bool enabled) noexcept {
    if (!enabled) come_to_rest(motor_.release());
    enabled_ = enabled;
}

void AxisUnit::step_rises(std::int64_t time_ns) noexcept {
    const bool gap_too_short = time_ns - step_fell_ns_ < timing_.step_low_ns;
    step_rose_ns_ = time_ns;
    last_pulse_counts_ = false;
    if (!enabled_) {
        ignored_.add(1);
    } else if (gap_too_short) {
        lost_step_low_.add(1);
    } else if (time_ns - direction_changed_ns_ < timing_.dir_setup_ns) {
        lost_dir_setup_.add(1);
    } else {
        take_pulse(time_ns);
    }
}

void AxisUnit::step_falls(std::int64_t time_ns) noexcept {
    step_fell_ns_ = time_ns;
    if (last_pulse_counts_ && time_ns - step_rose_ns_ < timing_.step_high_ns)
        lose_last_pulse(lost_step_high_);
}

void AxisUnit::take_pulse(std::int64_t time_ns) noexcept {
    const std::int64_t next = motor_.position_pulses() + direction_;
    if (config_.has_ends &&
        (next > config_.high_end_pulses || next < config_.low_end_pulses - config_.backlash_pulses)) {
        lost_at_stop_.add(1);
        if (!at_stop_) crashes_.add(1);
        at_stop_ = true;
        motor_.put(motor_.position_pulses());
        settle_due_ns_ = kForeverNs;
        return;
    }
    at_stop_ = false;
    settle_due_ns_ = time_ns + motor_.settle_ns();
    switch (motor_.pulse(direction_, time_ns)) {
        case Motor::Outcome::followed:
            taken_.add(1);
            last_pulse_counts_ = true;
            last_direction_ = direction_;
            break;
        case Motor::Outcome::fell_out_of_step:
            taken_.add(1);
            note_stall();
            break;
        case Motor::Outcome::lost:
            lost_stalled_.add(1);
            return;
    }
    move_load();
}

void AxisUnit::lose_last_pulse(Counter& why) noexcept {
    last_pulse_counts_ = false;
    why.add(1);
    taken_.add(-1);
    motor_.take_back(last_direction_);
    move_load();
}

void AxisUnit::come_to_rest(bool ran_past) noexcept {
    settle_due_ns_ = kForeverNs;
    if (!ran_past) return;
    note_stall();
    if (config_.has_ends) {
        motor_.put(std::clamp(motor_.position_pulses(), config_.low_end_pulses - config_.backlash_pulses,
                              config_.high_end_pulses));
    }
    move_load();
}

void AxisUnit::slip(std::int64_t pulses) noexcept {
    motor_.put(motor_.position_pulses() + pulses);
    load_pulses_.add(pulses);
    move_load();
}

void AxisUnit::note_stall() noexcept {
    stalls_.add(1);
    slipped_.add(static_cast<std::int64_t>(motor_.slipped_pulses()));
}

void AxisUnit::move_load() noexcept {
    // The carriage rests against the flank that pushes it; turning back first crosses the gap.
    const std::int64_t motor = motor_.position_pulses();
    motor_pulses_.set(motor);
    load_pulses_.set(std::clamp(load_pulses_.get(), motor, motor + config_.backlash_pulses));
}

AxisReport AxisUnit::report() const noexcept {
    return {.position_pulses = load_pulses_.get(),
            .motor_pulses = motor_pulses_.get(),
            .pulses_taken = taken_.count(),
            .pulses_ignored = ignored_.count(),
            .lost_dir_setup = lost_dir_setup_.count(),
            .lost_dir_hold = lost_dir_hold_.count(),
            .lost_step_high = lost_step_high_.count(),
            .lost_step_low = lost_step_low_.count(),
            .stalls = stalls_.count(),
            .pulses_lost_stalled = lost_stalled_.count(),
            .slipped_pulses = slipped_.count(),
            .crashes = crashes_.count(),
            .pulses_lost_at_stop = lost_at_stop_.count(),
            .sensor_changes = sensor_.changes()};
}

}  // namespace psicarve::sim
