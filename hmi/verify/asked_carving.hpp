// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "hmi/surface/job_geometry.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::verify {

/// What a trace is to be judged against: the whole job, unless something tells that less was asked for.
struct AskedCarving {
    LayerRange layers{};
    bool may_end_early = false;  ///< it was stopped, or the recording ends: as far as it came it is judged
    bool carves = true;          ///< false: dry runs alone
    /// No spindle is on behind the last layer: what comes there is judged by the whole surface.
    bool ends_there = false;
    /// So many of the points are to have been carved although it may end early.
    std::uint64_t least_points = 0;
    /// So many attempts behind the last that came to its second point may lead the heads in and no further:
    /// those of starts that were called off.
    std::uint64_t most_vain_starts = std::numeric_limits<std::uint64_t>::max();
    /// So many came to their second point.
    std::uint64_t least_runs = 0;
};

/// What a trace holds of the runs that a flight recorder tells of.
enum class TraceHolds {
    all_runs,      ///< a replay of it, or the very core's
    the_last_ones  ///< at the least: it may have begun later
};

/// What the starts in a flight recorder, oldest record first, asked for of its newest job, from where a
/// replay of it begins: the last one that was carved, and those before it as long as each goes on within what
/// the one before asked for, or where that ends. A start that was never told to carve is none; dry runs count
/// where there are no others. `points_done`: of the whole job, as the status beside the records has it; 0:
/// not known. Nothing: there is none.
std::optional<AskedCarving> asked_carving(const JobView& job, std::span<const FlightRecord> records,
                                          std::uint64_t points_done = 0,
                                          TraceHolds holds = TraceHolds::all_runs);

}  // namespace psicarve::verify
