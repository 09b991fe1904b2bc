// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include "rtcore/cycle/cycle.hpp"

namespace psicarve::cycle {

bool Cycle::apply(MachineEvent event) noexcept {
    const std::optional<MachineState> next = next_state(state_, event);
    if (!next.has_value()) return false;
    if (*next != state_) enter(*next);
    return true;
}

void Cycle::enter(MachineState state) noexcept {
    if (state_ == MachineState::testing) pulses_.force(0);
    state_ = state;
    if (state == MachineState::off || state == MachineState::alarm) pulses_.make_safe();
    // An axis that was homed alone holds its position while the others are homed.
    const std::uint32_t held_axes = std::uint32_t{homed_.mask()} & config_.switched_axes;
    if (state == MachineState::off && held_axes != 0) pulses_.set_enables(held_axes, clock_.tick());
    if (state == MachineState::ready) pulses_.set_enables(HomedAxes::kAll, clock_.tick());
    reporter_.report(RecordKind::state_change, static_cast<std::uint16_t>(state));
    publisher_.ask(clock_.tick());
}

void Cycle::program_done() noexcept {
    using S = MachineState;
    using E = MachineEvent;
    switch (state_) {
        case S::homing:
            apply(homed_.has_all() ? E::home_done : E::home_done_unhomed);
            break;
        case S::moving:
            end_move(MoveEnd::reached);
            break;
        case S::positioning:
            apply(E::positioned);
            // Planned now, so that the first pulse comes at once when interpolation starts.
            request_plan(PlanKind::carve);
            break;
        case S::carving:
            apply(E::last_point_done);
            request_plan(PlanKind::finish);
            break;
        case S::finishing:
            job_.end(clock_.tick());
            apply(E::finished);
            break;
        case S::stopping:
            end_after_stop();
            break;
        case S::backing_off:
            apply(E::back_off_done);
            break;
        case S::off:
        case S::ready:
        case S::waiting:
        case S::holding:
        case S::held:
        case S::alarm:
        case S::testing:
            break;
    }
}

void Cycle::came_to_rest() noexcept {
    if (pending_fail_ != AlarmCause::none) {
        // It slowed down as its motors can: each stands where it was counted to, until its drive is off.
        HomedAxes known = homed_;
        known.lose(config_.switched_axes);
        raise_alarm(pending_fail_, kNoAxis);
        homed_ = known;
        return;
    }
    if (state_ == MachineState::moving) {
        end_move(move_.ended());
        return;
    }
    if (state_ == MachineState::holding && lifts_on_hold()) {
        lift_.lift();
        return;
    }
    apply(MachineEvent::at_rest);
    if (state_ != MachineState::stopping) return;
    if (executor_.homing_axis() != kNoAxis) limits_.exempt_axis(executor_.homing_axis(), inputs_.accepted());
    if (homed_.has_heads()) {
        request_plan(PlanKind::finish);
    } else {
        end_after_stop();
    }
}

void Cycle::go_on_with_motion() noexcept {
    if (!executes()) return;
    if (lift_.is_active()) return step_lift();
    const Executor::Progress progress = executor_.step(clock_.tick());
    if (progress != Executor::kNothing) after_step(progress);
}

void Cycle::step_lift() noexcept {
    switch (lift_.step(clock_.tick())) {
        case HeadLift::Progress::going_on:
            break;
        case HeadLift::Progress::lifted:
            apply(MachineEvent::at_rest);
            break;
        case HeadLift::Progress::back:
            executor_.go_on_after_lift(clock_.tick());
            break;
        case HeadLift::Progress::halted:
            lift_.forget();
            came_to_rest();
            break;
    }
}

void Cycle::slow_down() noexcept {
    executor_.slow_down();
    if (lift_.is_active()) lift_.halt();
}

void Cycle::end_move(MoveEnd end) noexcept {
    drop_plan();
    move_.end(end);
    apply(MachineEvent::move_done);
}

void Cycle::end_after_stop() noexcept {
    drop_plan();
    pulses_.set_spindle(false);
    job_.end(clock_.tick());
    apply(homed_.has_all() ? MachineEvent::stopped : MachineEvent::stopped_unhomed);
}

void Cycle::stop() noexcept {
    const MachineState before = state_;
    apply(MachineEvent::stop);
    // Nothing moves, but the spindle may turn.
    if (state_ == MachineState::ready) pulses_.set_spindle(false);
    if (state_ == before) return;
    move_.end(MoveEnd::none);
    if (state_ == MachineState::stopping) {
        slow_down();
    } else {
        drop_plan();
    }
}

void Cycle::fail_controlled(AlarmCause cause) noexcept {
    const bool can_slow_down = executes() && state_ != MachineState::backing_off;
    if (!can_slow_down) {
        raise_alarm(cause, kNoAxis);
        return;
    }
    pending_fail_ = cause;
    move_.forget_lease();
    apply(MachineEvent::stop);
    slow_down();
}

void Cycle::raise_alarm(AlarmCause cause, std::uint8_t axis, std::int64_t expected_pulses,
                        std::int64_t seen_pulses) noexcept {
    if (state_ == MachineState::alarm) return;
    // A rotor without current may be turned by hand or by weight, and nothing counts that.
    homed_.lose(moving_axes() | config_.switched_axes);
    if (axis < kAxisCount && (cause == AlarmCause::steps_lost || cause == AlarmCause::home_failed)) {
        homed_.lose(1U << axis);
    }
    alarm_cause_ = cause;
    alarm_axis_ = axis;
    move_.end(MoveEnd::none);
    drop_plan();
    const bool affects_layers = cause == AlarmCause::steps_lost && runs_job(state_);
    reporter_.report_alarm(cause, axis, expected_pulses, seen_pulses,
                           affects_layers ? job_.affected(executor_.progress().layer()) : JobRun::Affected{});
    apply(MachineEvent::fail);
    pins_.rest_charge_pump();
    // Pulses and inputs have a timer of their own in the other schedule, which writes what it finds.
    if (!config_.has_two_timers() && pins_.differ_from(pulses_.levels())) {
        pins_.write(pulses_.levels(), clock_.time_ns());
    }
}

// Those that have stepped so recently that their rotor may still turn, and those on their way.
std::uint32_t Cycle::moving_axes() const noexcept {
    const std::uint32_t on_their_way = state_ == MachineState::held ? 0 : executor_.axes_in_motion();
    return coasting_.axes(clock_.tick()) | on_their_way;
}

void Cycle::drop_plan() noexcept {
    ++epoch_;
    executor_.reset(epoch_);
    lift_.forget();
    pending_fail_ = AlarmCause::none;
}

// Override is of the carving; positioning, homing and retraction go as planned.
void Cycle::set_feed(bool is_carving) noexcept {
    executor_.set_feed_ratio(is_carving ? job_.feed_ratio() : 1.0);
}

void Cycle::request_plan(PlanKind kind, std::uint8_t axis, const MotionOrder* order) noexcept {
    drop_plan();
    set_feed(kind == PlanKind::carve);
    executor_.set_still_axes(job_.is_dry() && kind == PlanKind::carve ? HomedAxes::kHeadsMask : 0);
    PlanRequest request{};
    request.epoch = epoch_;
    request.kind = kind;
    request.axis = axis;
    request.homed_mask = homed_.mask();
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        request.tripped_mask = static_cast<std::uint8_t>(request.tripped_mask |
                                                         static_cast<unsigned>(inputs_.is_tripped(k)) << k);
    }
    request.position_pulses = pulses_.positions();
    job_.show_in(request);
    if (order != nullptr) request.order = *order;
    if (!io_->plan_requests.push(request)) raise_alarm(AlarmCause::plan_starved, kNoAxis);
}

void Cycle::assume_homed(const std::array<std::int64_t, kAxisCount>& position_pulses) noexcept {
    for (std::size_t k = 0; k < kAxisCount; ++k) pulses_.set_position(k, position_pulses[k]);
    homed_.add_all();
    apply(MachineEvent::home);
    apply(MachineEvent::home_done);
    tracer_.note_new_position();
}

}  // namespace psicarve::cycle
