// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "shared/machine/status.hpp"

namespace psicarve::cli {

/// What a flight recorder tells of the last program, if it has that number: where it was begun, held and
/// ended, its lines, states and alarms, from its begin up to the next job. Empty: it does not hold its begin.
std::vector<FlightRecord> entries_of_program(std::span<const FlightRecord> records, std::uint64_t program);

/// The program and its recording, entry by entry.
struct EntryComparison {
    std::size_t same_count = 0;                 ///< of the recorded entries, from the first on
    std::optional<FlightRecord> first_other{};  ///< the recorded one that was not repeated
    std::uint64_t most_ticks = 0;               ///< by which one of the same came earlier or later
    std::uint64_t most_pulses = 0;              ///< by which an axis stood elsewhere at one of the same
};
/// Ticks and lines are counted from the begin of each. A recording may end before its replay does.
EntryComparison compare_entries(std::span<const FlightRecord> recorded,
                                std::span<const FlightRecord> replayed);

/// By so many ticks entries of a real clock's recording may lie elsewhere for what a recorder does not tell:
/// where within its gaps ticks were missed, and a wait for a block that was too short to be told. `entries`:
/// the program's; `records`: all.
std::uint64_t untold_ticks(std::span<const FlightRecord> entries, std::span<const FlightRecord> records,
                           std::int64_t period_ns);
/// The recording was repeated, as exactly as it tells. untold_ticks: nothing for a virtual clock's. An axis
/// that stood elsewhere at the very tick was somewhere else.
bool is_as_recorded(const EntryComparison& compared, std::uint64_t untold_ticks) noexcept;

}  // namespace psicarve::cli
