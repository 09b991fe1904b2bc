// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/replayed_entries.hpp"

#include <algorithm>
#include <iterator>

#include "shared/machine/command.hpp"
#include "shared/machine/recorded_program.hpp"

namespace psicarve::cli {
namespace {

bool is_next_job(const FlightRecord& record) {
    if (static_cast<AnswerKind>(record.answer) != AnswerKind::done) return false;
    return record.kind == RecordKind::job || (record.kind == RecordKind::command &&
                                              static_cast<CommandKind>(record.code) == CommandKind::start);
}

bool is_told_of(const FlightRecord& record) {
    return record.kind == RecordKind::program || record.kind == RecordKind::state_change ||
           record.kind == RecordKind::alarm;
}

/// A core counts its alarms from its own begin.
bool is_same(const FlightRecord& recorded, const FlightRecord& replayed) {
    if (recorded.kind != replayed.kind || recorded.code != replayed.code) return false;
    if (recorded.kind == RecordKind::alarm) return recorded.axis == replayed.axis;
    // Cores of before did not record how much of its gaps a machine at rest has still to cross.
    const bool tells_no_gaps = recorded.kind == RecordKind::state_change && recorded.value == 0;
    if (tells_no_gaps) return recorded.answer == replayed.answer;
    return recorded.value == replayed.value && recorded.answer == replayed.answer;
}

std::uint64_t apart(std::uint64_t a, std::uint64_t b) {
    return a < b ? b - a : a - b;
}

void note_apart(EntryComparison& found, const FlightRecord& recorded, const FlightRecord& replayed) {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        // Numbers of a file may be anything.
        const std::int64_t a = recorded.position_pulses[k];
        const std::int64_t b = replayed.position_pulses[k];
        const std::uint64_t pulses =
            static_cast<std::uint64_t>(std::max(a, b)) - static_cast<std::uint64_t>(std::min(a, b));
        found.most_pulses = std::max(found.most_pulses, pulses);
    }
}

}  // namespace

std::vector<FlightRecord> entries_of_program(std::span<const FlightRecord> records, std::uint64_t program) {
    const auto is_begin = [](const FlightRecord& record) {
        return is_of_program(record, ProgramEvent::begun);
    };
    const auto last = std::find_if(records.rbegin(), records.rend(), is_begin);
    std::vector<FlightRecord> entries;
    if (last == records.rend() || static_cast<std::uint64_t>(last->value) != program) return entries;
    const auto first = std::prev(last.base());
    const auto end = std::find_if(first, records.end(), is_next_job);
    std::copy_if(first, end, std::back_inserter(entries), is_told_of);
    return entries;
}

EntryComparison compare_entries(std::span<const FlightRecord> recorded,
                                std::span<const FlightRecord> replayed) {
    EntryComparison found;
    for (std::size_t i = 0; i < recorded.size(); ++i) {
        if (i >= replayed.size() || !is_same(recorded[i], replayed[i])) {
            found.first_other = recorded[i];
            return found;
        }
        const std::uint64_t recorded_ticks = recorded[i].tick - recorded[0].tick;
        const std::uint64_t replayed_ticks = replayed[i].tick - replayed[0].tick;
        found.most_ticks = std::max(found.most_ticks, apart(recorded_ticks, replayed_ticks));
        note_apart(found, recorded[i], replayed[i]);
        ++found.same_count;
    }
    return found;
}

std::uint64_t untold_ticks(std::span<const FlightRecord> entries, std::span<const FlightRecord> records,
                           std::int64_t period_ns) {
    // Longer ones are told as starving.
    constexpr std::int64_t kUntoldWait_ns = 200'000'000;
    if (entries.empty() || period_ns <= 0) return 0;
    // Numbers of a file may be anything.
    constexpr std::uint64_t kMost = std::uint64_t{1} << 48U;
    std::uint64_t ticks = static_cast<std::uint64_t>(kUntoldWait_ns / period_ns);
    for (const FlightRecord& record : records) {
        const bool is_while_it_ran =
            record.tick >= entries.front().tick && record.tick <= entries.back().tick;
        if (record.kind == RecordKind::gap && is_while_it_ran)
            ticks += std::min(static_cast<std::uint64_t>(std::max<std::int64_t>(record.value, 0)), kMost);
    }
    return ticks;
}

bool is_as_recorded(const EntryComparison& compared, std::uint64_t untold_ticks) noexcept {
    if (compared.first_other || compared.most_ticks > untold_ticks) return false;
    return compared.most_ticks != 0 || compared.most_pulses == 0;
}

}  // namespace psicarve::cli
