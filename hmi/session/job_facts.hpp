// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/phrase/phrase.hpp"

namespace psicarve::session {

/// What there is to be known of a job besides its tables, as far as it says.
struct JobFacts {
    Joining joining = Joining::continuous;
    std::optional<std::uint64_t> triangles;  ///< of its model
    std::optional<double> undercut_share;
    std::optional<std::uint64_t> open_points;
};
JobFacts job_facts(const JobView& job);

/// The passes of a job that has several: "7 roughing, finishing"; while it is carved, in which the layer
/// lies: "roughing 2 of 7". Empty for a job of one pass.
Phrase pass_phrase(const JobView& job, std::optional<std::uint32_t> layer);

/// What bounds the time most: "feed 71 %, R1 18 %"; what bounds less than a twentieth is not told.
Phrase bound_phrase(const cam::LeastTime& least);

/// One line each: a name and what stands there. `source_bytes`: of the model's file, 0 when it is not known.
struct FactRow {
    Phrase name;
    Phrase value;
};
std::vector<FactRow> fact_rows(const JobFacts& facts, std::uint64_t source_bytes);

}  // namespace psicarve::session
