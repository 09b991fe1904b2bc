// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/machine/replayed_part.hpp"

#include <algorithm>
#include <iterator>

#include "shared/machine/command.hpp"
#include "shared/machine/machine_state.hpp"

namespace psicarve {
namespace {

using Records = std::span<const FlightRecord>;

bool is_homed_rest(const FlightRecord& record) {
    return record.kind == RecordKind::state_change &&
           static_cast<MachineState>(record.code) == MachineState::ready;
}

bool is_loaded_job(const FlightRecord& record) {
    return record.kind == RecordKind::job && static_cast<AnswerKind>(record.answer) == AnswerKind::done;
}

bool is_begun_program(const FlightRecord& record) {
    return record.kind == RecordKind::command && static_cast<AnswerKind>(record.answer) == AnswerKind::done &&
           static_cast<CommandKind>(record.code) == CommandKind::program;
}

/// The newest job was loaded while the machine was homed and at rest, or it came to be so later: the snapshot
/// holds no other job, so nothing before that can be run again.
Records::iterator first_after_job(Records records) {
    const auto last_job = std::find_if(records.rbegin(), records.rend(), is_loaded_job);
    if (last_job == records.rend()) return std::ranges::find_if(records, is_homed_rest);
    const auto job = std::prev(last_job.base());
    const auto is_change = [](const FlightRecord& record) { return record.kind == RecordKind::state_change; };
    const auto state_at_job = std::find_if(last_job, records.rend(), is_change);
    if (state_at_job != records.rend() && is_homed_rest(*state_at_job)) return job;
    return std::find_if(job, records.end(), is_homed_rest);
}

std::optional<std::size_t> index_in(Records records, Records::iterator record) {
    if (record == records.end()) return std::nullopt;
    return static_cast<std::size_t>(record - records.begin());
}

}  // namespace

std::optional<std::size_t> replay_begin(std::span<const FlightRecord> records) {
    const auto first = first_after_job(records);
    // The records of a program are not in a snapshot.
    const auto program = std::find_if(records.rbegin(), records.rend(), is_begun_program);
    if (program == records.rend() || program.base() <= first) return index_in(records, first);
    return index_in(records, std::find_if(program.base(), records.end(), is_homed_rest));
}

std::optional<std::size_t> program_replay_begin(std::span<const FlightRecord> records) {
    const auto program = std::find_if(records.rbegin(), records.rend(), is_begun_program);
    const auto rest = std::find_if(program, records.rend(), is_homed_rest);
    if (rest == records.rend()) return std::nullopt;
    return index_in(records, std::prev(rest.base()));
}

}  // namespace psicarve
