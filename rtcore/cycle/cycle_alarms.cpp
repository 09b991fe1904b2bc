// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/cycle.hpp"

namespace psicarve::cycle {

void Cycle::fail_controlled(AlarmCause cause) noexcept {
    const bool can_slow_down = executes() && state_ != MachineState::backing_off;
    if (!can_slow_down) {
        raise_alarm(cause, kNoAxis);
        return;
    }
    alarm_.await_rest(cause);
    move_.forget_lease();
    apply(MachineEvent::stop);
    motion_.slow_down();
}

void Cycle::raise_alarm(AlarmCause cause, std::uint8_t axis, std::int64_t expected_pulses,
                        std::int64_t seen_pulses) noexcept {
    if (state_ == MachineState::alarm) return;
    // A rotor without current may be turned by hand or by weight, and nothing counts that.
    homed_.lose(moving_axes() | config_.switched_axes);
    if (axis < kAxisCount && (cause == AlarmCause::steps_lost || cause == AlarmCause::home_failed)) {
        homed_.lose(1U << axis);
    }
    move_.end(MoveEnd::none);
    drop_plan();
    alarm_.raise(cause, axis);
    const bool affects_layers = cause == AlarmCause::steps_lost && runs_job(state_) && !program_.is_on();
    reporter_.report_alarm(cause, axis, expected_pulses, seen_pulses,
                           affects_layers ? job_.affected(motion_.progress().layer()) : JobRun::Affected{});
    apply(MachineEvent::fail);
    outlet_.rest_charge_pump();
    // Pulses and inputs have a timer of their own in the other schedule, which writes what it finds.
    if (!config_.has_two_timers() && outlet_.has_change()) outlet_.write();
}

// Those that have stepped so recently that their rotor may still turn, and those on their way.
std::uint32_t Cycle::moving_axes() const noexcept {
    const std::uint32_t on_their_way = state_ == MachineState::held ? 0 : motion_.axes_on_their_way();
    return motion_.coasting().axes(clock_.tick()) | on_their_way;
}

void Cycle::check_gap(std::int64_t gap_ticks) noexcept {
    const std::uint8_t axis = motion_.coasting().axis_lost_in(gap_ticks, clock_.tick());
    if (axis != kNoAxis) raise_alarm(AlarmCause::tick_gap, axis);
}

// The port was not ours meanwhile (the guard had it, or the computer slept): nothing is slowed down any more,
// and what stands on the pins is not what was written.
void Cycle::come_back(std::uint32_t lost_axes) noexcept {
    port_->forget_written();
    homed_.lose(lost_axes);
    raise_alarm(AlarmCause::tick_gap, kNoAxis);
    write_port();
}

Refusal Cycle::reset_alarm() noexcept {
    if (state_ != MachineState::alarm) return Refusal::not_in_this_state;
    if (!port_->is_healthy()) {
        if (!port_->take_up_again()) return Refusal::port_failed;
        // Who knows what its lines did meanwhile.
        homed_.lose_all();
    }
    if (cause_remains()) return Refusal::still_tripped;
    alarm_.reset();
    apply(homed_.has_all() ? MachineEvent::reset_alarm_homed : MachineEvent::reset_alarm_unhomed);
    return Refusal::none;
}

Refusal Cycle::back_off(std::uint8_t axis) noexcept {
    if (state_ != MachineState::alarm) return Refusal::not_in_this_state;
    if (axis >= kAxisCount || axis == index_of(Axis::psi) || !config_.axes[axis].has_sensor) {
        return Refusal::no_sensor;
    }
    if (!port_->is_healthy()) return Refusal::port_reset_first;
    if (!inputs_.is_tripped(axis)) return Refusal::sensor_not_tripped;
    if ((inputs_.raw() & kEstopBit) != 0) return Refusal::still_tripped;
    homed_.lose(1U << axis);
    limits_.exempt(inputs_.accepted() | inputs_.raw());
    apply(MachineEvent::back_off);
    request_plan(PlanKind::back_off, axis);
    return Refusal::none;
}

}  // namespace psicarve::cycle
