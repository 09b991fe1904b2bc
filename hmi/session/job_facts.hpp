// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/phrase/phrase.hpp"

namespace psicarve::session {

/// The facts about a job besides its tables, where it gives them.
struct JobFacts {
    Joining joining = Joining::continuous;
    std::optional<std::uint64_t> triangles;  ///< of its model
    std::optional<double> undercut_share;
    std::optional<std::uint64_t> open_points;
};
JobFacts job_facts(const JobView& job);

/// The passes of a job that has several: "7 roughing, finishing"; while it is carved, the one of the layer:
/// "roughing 2 of 7". Empty for a job of one pass.
Phrase pass_phrase(const JobView& job, std::optional<std::uint32_t> layer);

/// The limits that determine the time most: "feed 71 %, R1 18 %"; leaves out shares below a twentieth.
Phrase bound_phrase(const cam::LeastTime& least);

/// One line each: a name and its value. `source_bytes`: size of the model's file, 0 when it is not known.
struct FactRow {
    Phrase name;
    Phrase value;
};
std::vector<FactRow> fact_rows(const JobFacts& facts, std::uint64_t source_bytes);

}  // namespace psicarve::session
