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
    const MachineState left = state_;
    state_ = state;
    publisher_.ask(clock_.tick());
    if (starves_into(state)) return;
    if (program_.is_on()) tell_program_of(left, state);
    if (state == MachineState::ready || state == MachineState::off || state == MachineState::alarm) {
        program_.end();
        motion_.rest_behind(0);
    }
    if (state == MachineState::off || state == MachineState::alarm) pulses_.make_safe();
    // An axis that was homed alone holds its position while the others are homed.
    const std::uint32_t held_axes = std::uint32_t{homed_.mask()} & config_.switched_axes;
    if (state == MachineState::off && held_axes != 0) pulses_.set_enables(held_axes, clock_.tick());
    if (state == MachineState::ready) pulses_.set_enables(HomedAxes::kAll, clock_.tick());
    // A replay begins with such a rest.
    const std::int64_t gaps = state == MachineState::ready ? recorded_gaps(pulses_.gaps_left()) : 0;
    reporter_.report(RecordKind::state_change, static_cast<std::uint16_t>(state), kNoAxis, gaps);
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
            if (program_.is_on()) return program_of_records_done();
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
    if (alarm_.awaited() != AlarmCause::none) {
        // It slowed down as its motors can: each stands where it was counted to, until its drive is off.
        HomedAxes known = homed_;
        known.lose(config_.switched_axes);
        raise_alarm(alarm_.awaited(), kNoAxis);
        homed_ = known;
        return;
    }
    if (state_ == MachineState::moving) {
        end_move(move_.ended());
        return;
    }
    if (state_ == MachineState::holding && lifts_on_hold()) {
        motion_.lift();
        return;
    }
    apply(MachineEvent::at_rest);
    if (state_ != MachineState::stopping) return;
    if (motion_.homing_axis() != kNoAxis) limits_.exempt_axis(motion_.homing_axis(), inputs_.accepted());
    if (homed_.has_heads()) {
        request_plan(PlanKind::finish);
    } else {
        end_after_stop();
    }
}

void Cycle::go_on_with_motion() noexcept {
    if (!executes()) {
        if (program_.is_starved()) go_on_when_fed();
        return;
    }
    const Motion::Progress progress = motion_.step(clock_.tick());
    // On its way it is supplied, as was seen in the step in which that began.
    if (progress == Executor::kNothing && motion_.is_under_way()) return;
    after_step(progress);
    if (carves_program()) watch_supply();
}

void Cycle::end_move(MoveEnd end) noexcept {
    drop_plan();
    move_.end(end);
    apply(MachineEvent::move_done);
}

void Cycle::end_after_stop() noexcept {
    drop_plan();
    pulses_.end_switches();
    if (!program_.is_on()) job_.end(clock_.tick());
    apply(homed_.has_all() ? MachineEvent::stopped : MachineEvent::stopped_unhomed);
}

void Cycle::stop() noexcept {
    const MachineState before = state_;
    apply(MachineEvent::stop);
    // Nothing moves, but the spindle may turn.
    if (state_ == MachineState::ready) pulses_.end_switches();
    if (state_ == before) return;
    move_.end(MoveEnd::none);
    program_.wait_for(ProgramHold::none);
    if (state_ == MachineState::stopping) {
        motion_.slow_down();
    } else {
        drop_plan();
    }
}

void Cycle::drop_plan() noexcept {
    note_program_line();
    motion_.drop();
    alarm_.forget_awaited();
}

void Cycle::request_plan(PlanKind kind, std::uint8_t axis, const MotionOrder* order) noexcept {
    alarm_.forget_awaited();
    note_program_line();
    PlanRequest request{};
    request.kind = kind;
    request.axis = axis;
    request.homed_mask = homed_.mask();
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        request.tripped_mask = static_cast<std::uint8_t>(request.tripped_mask |
                                                         static_cast<unsigned>(inputs_.is_tripped(k)) << k);
    }
    job_.show_in(request);
    request.program = program_.status().program;
    request.is_single = program_.status().is_single;
    if (order != nullptr) request.order = *order;
    const bool is_carving = kind == PlanKind::carve || kind == PlanKind::program;
    const bool is_dry = kind == PlanKind::carve && job_.is_dry();
    const std::uint32_t still_axes = is_dry ? HomedAxes::kHeadsMask : 0;
    if (!motion_.ask(request, feed_ratio(is_carving), still_axes)) {
        raise_alarm(AlarmCause::plan_starved, kNoAxis);
    }
}

void Cycle::assume_homed(const std::array<std::int64_t, kAxisCount>& position_pulses, SignalWord levels,
                         const GapsLeft& left_pulses) noexcept {
    if (levels != 0) pulses_.assume_directions(levels, left_pulses);
    for (std::size_t k = 0; k < kAxisCount; ++k) pulses_.set_position(k, position_pulses[k]);
    homed_.add_all();
    apply(MachineEvent::home);
    apply(MachineEvent::home_done);
    outlet_.note_new_position();
}

}  // namespace psicarve::cycle
