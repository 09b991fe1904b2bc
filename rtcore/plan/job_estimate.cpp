// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/job_estimate.hpp"

#include <algorithm>
#include <iterator>

namespace psicarve::plan {

void JobEstimate::add(const PlannedSoFar& planned) {
    if (planned.points > marks_.back().points) {
        marks_.push_back(planned);
    } else {
        marks_.back().seconds = std::max(marks_.back().seconds, planned.seconds);
    }
}

double JobEstimate::seconds_to(std::uint64_t points_done) const noexcept {
    const auto after = std::ranges::upper_bound(marks_, points_done, {}, &PlannedSoFar::points);
    if (after == marks_.begin()) return 0.0;
    if (after == marks_.end()) return seconds();
    const PlannedSoFar& before = *std::prev(after);
    const double ratio =
        static_cast<double>(points_done - before.points) / static_cast<double>(after->points - before.points);
    return before.seconds + ratio * (after->seconds - before.seconds);
}

double JobEstimate::seconds_left(std::uint64_t points_done, std::uint64_t points_total) const noexcept {
    const double planned = std::max(0.0, seconds_to(points_total) - seconds_to(points_done));
    if (points_total <= points()) return planned;
    return planned + seconds() / static_cast<double>(points()) * static_cast<double>(points_total - points());
}

}  // namespace psicarve::plan
