// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "rtcore/plan/program.hpp"

namespace psicarve::plan {

/// How long a whole table takes as planned, at 100 % feed, and how long the way to each of its points: known
/// at the places where a layer or a stretch ends, in between each point takes as long as the next. Grows as
/// the table is planned.
class JobEstimate {
public:
    /// So much has been planned; neither count nor seconds ever less than before.
    void add(const PlannedSoFar& planned);

    std::uint64_t points() const noexcept { return marks_.back().points; }
    /// From the first point to the last one planned.
    double seconds() const noexcept { return marks_.back().seconds; }
    /// They are the least that the limits allow: T_ref.
    bool is_reference() const noexcept { return marks_.back().is_reference; }
    /// From the first point to the one after which so many are done; past the end: the end.
    double seconds_to(std::uint64_t points_done) const noexcept;
    /// From `points_done` on to the end at `points_total`. Past what is planned each point takes as long as
    /// those so far.
    double seconds_left(std::uint64_t points_done, std::uint64_t points_total) const noexcept;

private:
    std::vector<PlannedSoFar> marks_{PlannedSoFar{.points = 1}};  ///< the first point is where it begins
};

}  // namespace psicarve::plan
