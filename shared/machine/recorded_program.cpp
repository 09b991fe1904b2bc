// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/machine/recorded_program.hpp"

#include "shared/machine/command.hpp"

namespace psicarve {
namespace {

void take_switch(ProgramStatus& program, const FlightRecord& record) noexcept {
    if (record.kind != RecordKind::command || record.answer != static_cast<std::uint32_t>(AnswerKind::done))
        return;
    const std::uint8_t is_on = record.value != 0 ? 1 : 0;
    if (record.code == static_cast<std::uint16_t>(CommandKind::single)) program.is_single = is_on;
    if (record.code == static_cast<std::uint16_t>(CommandKind::optional_stop))
        program.stops_at_optional = is_on;
}

}  // namespace

std::string_view name_of(ProgramEvent event) noexcept {
    switch (event) {
        case ProgramEvent::begun:
            return "begun";
        case ProgramEvent::line:
            return "line";
        case ProgramEvent::held:
            return "held";
        case ProgramEvent::resumed:
            return "resumed";
        case ProgramEvent::stopping:
            return "stopping";
        case ProgramEvent::ended:
            return "ended";
    }
    return "unknown";
}

std::string_view name_of(ProgramEnding ending) noexcept {
    switch (ending) {
        case ProgramEnding::done:
            return "done";
        case ProgramEnding::stopped:
            return "stopped";
        case ProgramEnding::alarm:
            return "alarm";
    }
    return "unknown";
}

void take_record(ProgramStatus& program, const FlightRecord& record) noexcept {
    if (record.kind == RecordKind::alarm) {
        program.is_running = 0;
        program.hold = ProgramHold::none;
    }
    take_switch(program, record);
    if (record.kind != RecordKind::program || (record.code & 0xFFU) >= kProgramEventCount) return;
    const ProgramEvent event = program_event_of(record);
    const std::uint8_t detail = program_detail_of(record);
    if (event == ProgramEvent::begun) {
        program = ProgramStatus{};
        program.program = static_cast<std::uint64_t>(record.value);
        program.is_running = 1;
        program.is_single = (detail & kProgramIsSingle) != 0 ? 1 : 0;
        program.stops_at_optional = (detail & kProgramStopsAtOptional) != 0 ? 1 : 0;
        return;
    }
    program.line = static_cast<std::uint64_t>(record.value);
    program.sequence = record.answer;
    program.hold = ProgramHold::none;
    program.is_running = event == ProgramEvent::ended ? 0 : 1;
    if (event == ProgramEvent::held && detail < kProgramHoldCount)
        program.hold = static_cast<ProgramHold>(detail);
    program.starvations += recorded_starvations(record);
    if (event == ProgramEvent::ended)
        program.is_done = detail == static_cast<std::uint8_t>(ProgramEnding::done) ? 1 : 0;
}

ProgramStatus recorded_program(std::span<const FlightRecord> records) noexcept {
    ProgramStatus program{};
    for (const FlightRecord& record : records) take_record(program, record);
    return program;
}

ProgramStatus recorded_program(std::span<const FlightRecord> records, const CoreStatus* status) noexcept {
    ProgramStatus program = recorded_program(records);
    const bool is_moving = status != nullptr && status->state != MachineState::held;
    if (is_moving && program.hold == ProgramHold::starved) program.hold = ProgramHold::none;
    return program;
}

}  // namespace psicarve
