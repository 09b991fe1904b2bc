// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// The least time that a job's ways from point to point take [s], by the limit that determines it, and their
/// lengths.
struct LeastTime {
    double feed_seconds = 0.0;                         ///< a tip at the job's feed over the surface
    std::array<double, kAxisCount> axis_seconds{};     ///< an axis at its top speed; Y never determines it
                                                       ///< here
    std::array<double, 2> path_mm{};                   ///< R1's and R2's tip over the surface
    std::vector<double> layer_seconds;                 ///< of each layer
    std::vector<std::array<double, 2>> layer_path_mm;  ///< of each layer

    double total() const noexcept;
};

/// Straight from point to point at the job's feed over the surface or at the axes' top speeds, whichever is
/// slower; a head that is outside of the blank (shared/job/outside.hpp) has no feed. Acceleration, links
/// between layers, approach and return are not in it; only the planner knows them. Some 10 ns a point.
LeastTime least_time_of(const JobView& job, const Profile& profile);
/// Its total.
double least_carving_seconds(const JobView& job, const Profile& profile);

}  // namespace psicarve::cam
