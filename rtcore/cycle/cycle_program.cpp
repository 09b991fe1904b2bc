// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/cycle.hpp"

namespace psicarve::cycle {

Refusal Cycle::start_program(const Request& request) noexcept {
    if (state_ == MachineState::off) return Refusal::not_homed;
    if (!next_state(state_, MachineEvent::run_program).has_value()) return Refusal::not_in_this_state;
    if (!homed_.has_all()) return Refusal::not_homed;
    program_.begin(request.value, request.axis != 0);
    pulses_.clear_emitted();
    apply(MachineEvent::run_program);
    request_plan(PlanKind::program);
    return Refusal::none;
}

// Once there is nothing to do: it has come to rest by itself, on a point of the program.
void Cycle::watch_supply() noexcept {
    if (program_.runs_out(motion_.has_run_out())) rest_in_program();
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
    program_.go_on();
    apply(MachineEvent::resume);
}

// Whoever asks a starving program to hold wants it to stay so when records come.
bool Cycle::holds_starved_program() noexcept {
    if (state_ != MachineState::held || !program_.is_starved()) return false;
    program_.wait_for(ProgramHold::none);
    publisher_.ask(clock_.tick());
    return true;
}

void Cycle::program_of_records_done() noexcept {
    note_program_line();
    program_.note_done();
    pulses_.end_switches();
    drop_plan();
    apply(MachineEvent::program_done);
}

void Cycle::note_program_line() noexcept {
    if (program_.is_on()) program_.note_line(motion_.program_line(), motion_.program_sequence());
}

ProgramStatus Cycle::program_status() const noexcept {
    ProgramRun shown = program_;
    if (program_.is_on()) shown.note_line(motion_.program_line(), motion_.program_sequence());
    return shown.status();
}

}  // namespace psicarve::cycle
