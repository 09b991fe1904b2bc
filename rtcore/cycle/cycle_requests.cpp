// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/cycle.hpp"
#include "rtcore/cycle/request_effect.hpp"
#include "shared/machine/command.hpp"

namespace psicarve::cycle {

void Cycle::take_request(const Request& request) noexcept {
    reporter_.answer(request, is_overtaken(request) ? Verdict{Refusal::overtaken} : judge(request));
    publisher_.ask(clock_.tick());  // an answer is read after the sample that shows what it led to
}

// Commands may wait for long, and a stop waits for none of them: what was asked for before it would set the
// machine going after it. A stop that the sender knew of comes first, however they got here.
bool Cycle::is_overtaken(const Request& request) noexcept {
    if (request.has_sender == 0 || !sets_going(request)) return false;
    if (stops_.comes_after_one_not_taken(request)) take_stops();
    return stops_.have_overtaken(request);
}

Verdict Cycle::judge(const Request& request) noexcept {
    switch (request.kind) {
        case RequestKind::home:
            return {start_home(request.value)};
        case RequestKind::reset_height:
            return {reset_height()};
        case RequestKind::start:
            return {start_job(layer_range(request.value))};
        case RequestKind::start_interpolation:
            return {start_interpolation()};
        case RequestKind::hold:
            return {hold()};
        case RequestKind::resume:
            return {resume()};
        case RequestKind::reset_alarm:
            return {reset_alarm()};
        case RequestKind::back_off:
            return {back_off(request.axis)};
        case RequestKind::job_loaded:
            return {load_job(request)};
        case RequestKind::jog:
        case RequestKind::jog_on:
        case RequestKind::move:
            return start_move(request);
        case RequestKind::end_jog:
            end_jog(static_cast<MoveEnd>(request.value));
            return {Refusal::none};
        case RequestKind::spindle:
            return {switch_spindle(request.value != 0)};
        case RequestKind::override:
            return {take_override(request.value)};
        case RequestKind::single:
        case RequestKind::optional_stop:
            return {switch_stops(request.kind, request.value != 0)};
        case RequestKind::rapid_override:
            return {take_rapid_override(request.value)};
        case RequestKind::record:
            return {record(request)};
        case RequestKind::test_pin:
            return {try_pin(request)};
        case RequestKind::drives_off:
            return {drives_off()};
        case RequestKind::run_program:
            return {start_program(request)};
        case RequestKind::fail:
            break;
    }
    const auto cause = static_cast<AlarmCause>(request.value);
    if (cause == AlarmCause::tick_gap) {
        come_back(request.axis);
    } else {
        fail_controlled(cause);
    }
    return {Refusal::none};
}

Refusal Cycle::start_home(std::uint64_t axes) noexcept {
    if (!next_state(state_, MachineEvent::home).has_value()) return Refusal::not_in_this_state;
    const auto wanted = axes == 0 ? HomedAxes::kAll : static_cast<std::uint32_t>(axes) & HomedAxes::kAll;
    if (!homed_.may_home(wanted)) return Refusal::heads_not_homed;
    begin_homing(MachineEvent::home, wanted);
    request_plan(PlanKind::home, static_cast<std::uint8_t>(wanted));
    return Refusal::none;
}

Refusal Cycle::reset_height() noexcept {
    if (!next_state(state_, MachineEvent::reset_height).has_value()) return Refusal::not_in_this_state;
    if (!config_.axes[kY].has_sensor) return Refusal::no_sensor;
    begin_homing(MachineEvent::reset_height, 1U << kY);
    request_plan(PlanKind::reset_height);
    return Refusal::none;
}

void Cycle::begin_homing(MachineEvent event, std::uint32_t axes) noexcept {
    homed_.lose(axes);
    limits_.exempt(inputs_.accepted() | inputs_.raw());
    apply(event);
}

Refusal Cycle::start_job(LayerRange layers) noexcept {
    if (state_ == MachineState::off) return Refusal::not_homed;
    if (!next_state(state_, MachineEvent::start).has_value()) return Refusal::not_in_this_state;
    if (const Refusal refusal = job_.judge(layers); refusal != Refusal::none) return refusal;
    if (!homed_.has_all()) return Refusal::not_homed;
    job_.begin(layers, clock_.tick());
    pulses_.clear_emitted();
    motion_.begin_points(job_.points_before());
    outlet_.trace_job(job_.generation());
    apply(MachineEvent::start);
    request_plan(PlanKind::position);
    return Refusal::none;
}

Refusal Cycle::start_interpolation() noexcept {
    return apply(MachineEvent::start_interpolation) ? Refusal::none : Refusal::not_in_this_state;
}

Refusal Cycle::hold() noexcept {
    if (holds_starved_program()) return Refusal::none;
    if (!apply(MachineEvent::hold)) return Refusal::not_in_this_state;
    motion_.hold();
    return Refusal::none;
}

Refusal Cycle::resume() noexcept {
    // Of a program that broke off nothing is left; one that starves goes on when it is fed.
    if (is_for_good(program_.hold())) return Refusal::not_in_this_state;
    if (program_.is_starved()) return Refusal::none;
    if (!apply(MachineEvent::resume)) return Refusal::not_in_this_state;
    program_.go_on();
    motion_.resume();
    return Refusal::none;
}

Refusal Cycle::load_job(const Request& request) noexcept {
    if (state_ != MachineState::off && state_ != MachineState::ready && state_ != MachineState::alarm &&
        state_ != MachineState::homing) {
        return Refusal::not_in_this_state;
    }
    job_.load(request.value, request.points_total, request.points_per_layer, request.runs_back != 0);
    motion_.begin_points(0);
    motion_.set_rapid_ratio(job_.rapid_ratio());
    publisher_.ask(clock_.tick());
    return Refusal::none;
}

// In any state: an override may be set before the start, and stays through alarms until the next job is
// loaded; one above 100 % ends with a program, too.
Refusal Cycle::take_override(std::uint64_t percent) noexcept {
    using S = MachineState;
    constexpr std::uint32_t kCarving =
        state_bit(S::waiting) | state_bit(S::carving) | state_bit(S::holding) | state_bit(S::held);
    if (percent < kLeastOverride_percent || percent > kMostOverride_percent) return Refusal::bad_override;
    job_.set_override(percent);
    motion_.set_feed_ratio(feed_ratio((kCarving >> static_cast<unsigned>(state_) & 1U) != 0));
    publisher_.ask(clock_.tick());
    return Refusal::none;
}

// In any state, and as long as the feed's: nothing but programs has ways that it is for.
Refusal Cycle::take_rapid_override(std::uint64_t percent) noexcept {
    if (percent < kLeastOverride_percent || percent > kFullFeed_percent) return Refusal::bad_rapid_override;
    job_.set_rapid_override(percent);
    motion_.set_rapid_ratio(job_.rapid_ratio());
    publisher_.ask(clock_.tick());
    return Refusal::none;
}

// A recording begins at rest: what it tells from there on is all that moves the machine.
Refusal Cycle::record(const Request& request) noexcept {
    const auto form = static_cast<RecordingForm>(request.value);
    if (form == RecordingForm::none) {
        return outlet_.end_recording(request.lease_token) ? Refusal::none : Refusal::recording;
    }
    if (!outlet_.can_record()) return Refusal::recording;
    if (state_ != MachineState::off && state_ != MachineState::ready) return Refusal::not_in_this_state;
    outlet_.begin_recording(form, request.lease_token);
    return Refusal::none;
}

}  // namespace psicarve::cycle
