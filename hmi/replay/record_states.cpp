// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/record_states.hpp"

#include <algorithm>

#include "shared/machine/command.hpp"
#include "shared/machine/recorded_program.hpp"
#include "shared/machine/recorded_start.hpp"

namespace psicarve::replay {
namespace {

constexpr auto kFullFeed = static_cast<std::uint16_t>(kFullFeed_percent);
constexpr std::uint8_t kAllHomed = (1U << kAxisCount) - 1;

/// These states are only reached homed.
bool is_homed(MachineState state) noexcept {
    return state != MachineState::off && state != MachineState::homing && state != MachineState::alarm &&
           state != MachineState::backing_off;
}

bool is_done(const FlightRecord& record) noexcept {
    return record.answer == static_cast<std::uint32_t>(AnswerKind::done);
}

}  // namespace

RecordStates::RecordStates(const std::vector<FlightRecord>& records) {
    At now{0, MachineState::off, AlarmCause::none, kNoAxis, 0, 0, 0, 0, 0, false};
    ProgramStatus program{};
    for (const FlightRecord& record : records) {
        now.tick = record.tick;
        take_record(program, record);
        now.is_program = program.is_running != 0;
        if (is_program_done(record)) now.override_percent = std::min(now.override_percent, kFullFeed);
        if (record.kind == RecordKind::state_change && record.code < kMachineStateCount) {
            now.state = static_cast<MachineState>(record.code);
            if (now.state != MachineState::alarm && now.state != MachineState::backing_off)
                now.cause = AlarmCause::none;
        } else if (record.kind == RecordKind::alarm && record.code < kAlarmCauseCount) {
            now.cause = static_cast<AlarmCause>(record.code);
            now.axis = static_cast<std::uint8_t>(record.axis < kAxisCount ? record.axis : kNoAxis);
            ++now.alarms;
        } else if (record.kind == RecordKind::job && is_done(record)) {
            now.generation = static_cast<std::uint64_t>(record.value);
            now.override_percent = kFullFeed;
            now.rapid_override_percent = kFullFeed;
        } else if (record.kind == RecordKind::command && is_done(record) &&
                   record.code == static_cast<std::uint16_t>(CommandKind::override)) {
            now.override_percent = static_cast<std::uint16_t>(record.value);
        } else if (record.kind == RecordKind::command && is_done(record) &&
                   record.code == static_cast<std::uint16_t>(CommandKind::rapid_override)) {
            now.rapid_override_percent = static_cast<std::uint16_t>(record.value);
        } else if (record.kind == RecordKind::command && is_done(record) &&
                   record.code == static_cast<std::uint16_t>(CommandKind::start)) {
            now.is_dry = (static_cast<std::uint64_t>(record.value) & kRecordedDryRun) != 0 ? 1 : 0;
        } else if (record.kind != RecordKind::program) {
            continue;
        }
        states_.push_back(now);
    }
}

const RecordStates::At* RecordStates::at(std::uint64_t tick) const noexcept {
    const auto later =
        std::upper_bound(states_.begin(), states_.end(), tick,
                         [](std::uint64_t wanted, const At& state) { return wanted < state.tick; });
    return later == states_.begin() ? nullptr : &*(later - 1);
}

bool RecordStates::runs_program(std::uint64_t tick) const noexcept {
    const At* const found = at(tick);
    return found != nullptr && found->is_program;
}

void RecordStates::fill(CoreStatus& status, std::uint64_t tick) const noexcept {
    const At* const found = at(tick);
    if (found == nullptr) return;
    const At& state = *found;
    status.state = state.state;
    status.alarm_cause = state.cause;
    status.alarm_axis = state.axis;
    status.alarm_count = state.alarms;
    status.homed_mask = is_homed(state.state) ? kAllHomed : std::uint8_t{0};
    status.override_percent = state.override_percent;
    status.rapid_override_percent = state.rapid_override_percent;
    status.job_generation = state.generation;
    status.is_dry = state.is_dry;
}

}  // namespace psicarve::replay
