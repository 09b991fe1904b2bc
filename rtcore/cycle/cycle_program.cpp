// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/cycle.hpp"

namespace psicarve::cycle {
namespace {

std::uint8_t marks_to_rest_behind(const ProgramStatus& program) noexcept {
    return static_cast<std::uint8_t>((program.is_single != 0 ? kEndsLine : 0) |
                                     (program.stops_at_optional != 0 ? kOptionalStop : 0));
}

}  // namespace

Refusal Cycle::start_program(const Request& request) noexcept {
    if (state_ == MachineState::off) return Refusal::not_homed;
    if (!next_state(state_, MachineEvent::run_program).has_value()) return Refusal::not_in_this_state;
    if (!homed_.has_all()) return Refusal::not_homed;
    program_.begin(request.value, request.axis);
    tell_program(ProgramEvent::begun, program_.switches());
    pulses_.clear_emitted();
    motion_.rest_behind(marks_to_rest_behind(program_.status()));
    apply(MachineEvent::run_program);
    request_plan(PlanKind::program);
    return Refusal::none;
}

Refusal Cycle::switch_stops(RequestKind kind, bool is_on) noexcept {
    if (!program_.is_on()) return Refusal::no_program;
    if (state_ == MachineState::stopping) return Refusal::not_in_this_state;
    if (kind == RequestKind::single) {
        program_.set_single(is_on);
    } else {
        program_.set_optional_stop(is_on);
    }
    motion_.rest_behind(marks_to_rest_behind(program_.status()));
    return Refusal::none;
}

// A hold, a stop or an alarm that was asked for meanwhile goes on from this rest; so does a program whose
// switch is off by now. Where a line ends at an M1 it rests once for both.
void Cycle::line_done() noexcept {
    if (!carves_program() || alarm_.awaited() != AlarmCause::none) return came_to_rest();
    const unsigned why = motion_.rested_marks() & marks_to_rest_behind(program_.status());
    if (why == 0) return motion_.resume();
    halt_program((why & kOptionalStop) != 0 ? ProgramHold::optional : ProgramHold::single);
}

// Once there is nothing to do: it has come to rest by itself, on a point of the program.
void Cycle::watch_supply() noexcept {
    if (!program_.runs_out(motion_.has_run_out())) return;
    if (program_.may_tell_starvations(clock_.tick())) tell_starvations();
    rest_in_program();
}

void Cycle::halt_program(ProgramHold hold) noexcept {
    program_.wait_for(hold);
    rest_in_program();
}

// It stands already: nothing is slowed down, and the heads stay where the program has left them.
void Cycle::rest_in_program() noexcept {
    apply(MachineEvent::hold);
    apply(MachineEvent::at_rest);
}

void Cycle::go_on_when_fed() noexcept {
    if (!motion_.has_block()) return;
    apply(MachineEvent::resume);
    program_.go_on();
}

// A hold that is asked for while a program starves lasts when records come.
bool Cycle::holds_starved_program() noexcept {
    if (state_ != MachineState::held || !program_.is_starved()) return false;
    program_.wait_for(ProgramHold::none);
    tell_program(ProgramEvent::held);
    reporter_.report(RecordKind::state_change, static_cast<std::uint16_t>(state_));
    publisher_.ask(clock_.tick());
    return true;
}

void Cycle::program_of_records_done() noexcept {
    note_program_line();
    program_.note_done();
    job_.end_raised_override();
    pulses_.end_switches();
    drop_plan();
    apply(MachineEvent::program_done);
}

void Cycle::note_program_line() noexcept {
    if (program_.is_on()) program_.note_line(motion_.program_line(), motion_.program_sequence());
}

void Cycle::tell_program(ProgramEvent event, std::uint8_t detail) noexcept {
    if (program_.untold_starvations() > 0) tell_starvations();
    const ProgramStatus program = program_status();
    reporter_.report_program(event, detail, program);
    program_.note_told(program.sequence, clock_.tick());
}

// A writer that is late again and again would push all else out of the recorder.
void Cycle::tell_starvations() noexcept {
    reporter_.report_starvations(program_.untold_starvations(), program_status());
    program_.note_starvations_told(clock_.tick());
}

void Cycle::tell_program_line() noexcept {
    if (!program_.may_be_told(clock_.tick())) return;
    if (!program_.is_told(program_status().sequence)) tell_program(ProgramEvent::line);
}

void Cycle::tell_program_of(MachineState left, MachineState entered) noexcept {
    switch (entered) {
        case MachineState::held:
            return tell_program(ProgramEvent::held, static_cast<std::uint8_t>(program_.hold()));
        case MachineState::carving:
            if (left != MachineState::ready) tell_program(ProgramEvent::resumed);
            return;
        case MachineState::stopping:
            return tell_program(ProgramEvent::stopping);
        case MachineState::ready:
        case MachineState::off:
        case MachineState::alarm:
            return tell_program(ProgramEvent::ended, static_cast<std::uint8_t>(ending_in(entered)));
        default:
            return;
    }
}

ProgramEnding Cycle::ending_in(MachineState entered) const noexcept {
    if (entered == MachineState::alarm) return ProgramEnding::alarm;
    return program_.status().is_done != 0 ? ProgramEnding::done : ProgramEnding::stopped;
}

ProgramStatus Cycle::program_status() const noexcept {
    ProgramRun shown = program_;
    if (program_.is_on()) shown.note_line(motion_.program_line(), motion_.program_sequence());
    return shown.status();
}

}  // namespace psicarve::cycle
