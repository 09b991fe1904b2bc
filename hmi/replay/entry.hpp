// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "hmi/replay/trace_index.hpp"
#include "hmi/session/message_log.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::replay {

/// An event on the timeline.
struct Entry {
    std::int64_t time_ns = 0;  ///< since the recording's begin
    session::Severity severity = session::Severity::info;
    session::Phrase what;
    bool is_major = false;  ///< gets a mark: not one of hundreds
};

/// Ticks in a file are not trusted: later times than this are not shown [ns], some 73 years.
inline constexpr std::int64_t kLatest_ns = std::numeric_limits<std::int64_t>::max() / 4;
constexpr std::int64_t time_of_ticks(std::uint64_t ticks, std::int64_t period_ns) noexcept {
    const std::int64_t period = std::max<std::int64_t>(period_ns, 1);
    const std::uint64_t most = static_cast<std::uint64_t>(kLatest_ns / period);
    return static_cast<std::int64_t>(std::min(ticks, most)) * period;
}

/// The event in an entry of the flight recorder.
Entry entry_of(const FlightRecord& record, std::int64_t time_ns);
/// The events that the pins alone show: drives, spindle, switches, homing.
std::vector<Entry> entries_of(const std::vector<TraceIndex::PinChange>& changes);

/// Index of the first that is later than the time, or of the last that is earlier; -1: none.
int next_entry(const std::vector<Entry>& entries, std::int64_t time_ns) noexcept;
int entry_before(const std::vector<Entry>& entries, std::int64_t time_ns) noexcept;
/// Index of the last that is not later than the time; -1: none.
int entry_at(const std::vector<Entry>& entries, std::int64_t time_ns) noexcept;

}  // namespace psicarve::replay
