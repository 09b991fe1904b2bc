// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "hmi/replay/trace_index.hpp"
#include "hmi/session/message_log.hpp"
#include "shared/status.hpp"

namespace psicarve::replay {

/// Something that happened, on the timeline.
struct Entry {
    std::int64_t time_ns = 0;  ///< since the recording's begin
    session::Severity severity = session::Severity::info;
    session::Phrase what;
    bool is_major = false;  ///< gets a mark: not one of hundreds
};

/// What an entry of the flight recorder says.
Entry entry_of(const FlightRecord& record, std::int64_t time_ns);
/// What the pins alone tell: drives, spindle, switches, homing.
std::vector<Entry> entries_of(const std::vector<TraceIndex::PinChange>& changes);

/// The first that is later than the time, or the last that is earlier; -1: none.
int next_entry(const std::vector<Entry>& entries, std::int64_t time_ns) noexcept;
int entry_before(const std::vector<Entry>& entries, std::int64_t time_ns) noexcept;
/// The last that is not later than the time; -1: none.
int entry_at(const std::vector<Entry>& entries, std::int64_t time_ns) noexcept;

}  // namespace psicarve::replay
