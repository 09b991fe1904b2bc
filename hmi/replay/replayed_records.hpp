// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "hmi/replay/trace_index.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::replay {

/// A flight recorder's entries by the ticks of another core, which ran what they tell again.
struct ReplayedRecords {
    std::vector<FlightRecord> shown;   ///< what was run again
    std::vector<FlightRecord> states;  ///< with those before, which hold from the trace's begin
};

/// How the entries may lie in a trace that `replay` wrote of them. `psicarve replay` lets its core settle
/// before it begins, how long depends on the machine: so they are laid where a pin of the trace changes as an
/// entry says. Whether they fit there, the axes' positions must tell. Nothing for a trace that goes on long
/// after the last entry.
std::vector<ReplayedRecords> replayed_records(const std::vector<FlightRecord>& records,
                                              const TraceIndex& index);

}  // namespace psicarve::replay
