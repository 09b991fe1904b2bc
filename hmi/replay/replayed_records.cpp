// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/replayed_records.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>

#include "shared/base/units.hpp"
#include "shared/machine/replayed_part.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::replay {
namespace {

constexpr SignalWord kOutputs = kEnableMask | bit_of(Signal::spindle);
/// A replay ends once the machine has settled.
constexpr std::int64_t kLongestRest_ns = 5 * kNsPerS;
/// An input that was on at the begin changes there first.
constexpr std::size_t kMostTries = 3;

/// Of a damaged snapshot may be any: no sum of two that are less overflows.
constexpr std::uint64_t kTickBound = std::uint64_t{1} << 61U;

using Ticks = std::set<std::int64_t>;

/// Where an entry told that these pins changed, the trace's first changes that are the same.
void add_same_changes(Ticks& found, const FlightRecord& record, SignalWord changed, const TraceIndex& index) {
    std::size_t tries = 0;
    for (const TraceIndex::PinChange& change : index.changes()) {
        if (tries == kMostTries) return;
        const bool is_same = ((change.before ^ change.after) & changed) == changed &&
                             ((change.after ^ record.signals) & changed) == 0;
        if (!is_same) continue;
        found.insert(change.time_ns / index.start().period_ns - static_cast<std::int64_t>(record.tick));
        ++tries;
    }
}

/// The trace's ticks less the entries'. Of an input its entry is in the very tick, of the drives and the
/// spindle that which says that the machine is at rest.
Ticks possible_shifts(const std::vector<FlightRecord>& records, std::size_t first, const TraceIndex& index) {
    Ticks found;
    bool has_input = false;
    bool has_output = false;
    for (std::size_t i = first + 1; i < records.size() && !(has_input && has_output); ++i) {
        const FlightRecord& record = records[i];
        const SignalWord changed = record.signals ^ records[i - 1].signals;
        const bool is_input = record.kind == RecordKind::input_edge && (changed & kInputMask) != 0;
        const bool is_output = record.kind == RecordKind::state_change && (changed & kOutputs) != 0;
        if (is_input && !has_input) add_same_changes(found, record, changed & kInputMask, index);
        if (is_output && !has_output) add_same_changes(found, record, changed & kOutputs, index);
        has_input = has_input || is_input;
        has_output =
            has_output || (is_output && static_cast<MachineState>(record.code) == MachineState::ready);
    }
    return found;
}

std::optional<ReplayedRecords> shifted(const std::vector<FlightRecord>& records, std::size_t first,
                                       std::int64_t shift_ticks, const TraceIndex& index) {
    const std::int64_t period_ns = index.start().period_ns;
    ReplayedRecords by_trace;
    for (std::size_t i = 0; i < records.size(); ++i) {
        FlightRecord record = records[i];
        const std::int64_t tick = static_cast<std::int64_t>(record.tick) + shift_ticks;
        if (i >= first && (tick < 0 || tick > index.end_ns() / period_ns)) return std::nullopt;
        record.tick = static_cast<std::uint64_t>(tick);
        if (i >= first) by_trace.shown.push_back(record);
        if (i <= first) record.tick = 0;
        by_trace.states.push_back(record);
    }
    const std::int64_t last_tick = static_cast<std::int64_t>(records.back().tick) + shift_ticks;
    if (index.end_ns() / period_ns - last_tick > kLongestRest_ns / period_ns) return std::nullopt;
    return by_trace;
}

}  // namespace

std::vector<ReplayedRecords> replayed_records(const std::vector<FlightRecord>& records,
                                              const TraceIndex& index) {
    std::vector<ReplayedRecords> found;
    if (records.empty() || index.start().period_ns <= 0) return found;
    const auto is_absurd = [](const FlightRecord& record) { return record.tick >= kTickBound; };
    if (std::ranges::any_of(records, is_absurd)) return found;
    for (const auto& first : {replay_begin(records), program_replay_begin(records)}) {
        if (!first) continue;
        for (const std::int64_t shift_ticks : possible_shifts(records, *first, index)) {
            if (auto by_trace = shifted(records, *first, shift_ticks, index))
                found.push_back(std::move(*by_trace));
        }
    }
    return found;
}

}  // namespace psicarve::replay
