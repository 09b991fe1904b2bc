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

void JobEstimate::forecast(const std::vector<double>& layer_ends_s, std::uint32_t point_count) {
    for (const double end_s : layer_ends_s) {
        const std::uint64_t layers = forecast_.size();
        forecast_.push_back({.points = layers * point_count, .seconds = end_s});
    }
}

double JobEstimate::seconds_at(const Marks& marks, std::uint64_t points_done) noexcept {
    const auto after = std::ranges::upper_bound(marks, points_done, {}, &PlannedSoFar::points);
    if (after == marks.begin()) return 0.0;
    if (after == marks.end()) return marks.back().seconds;
    const PlannedSoFar& before = *std::prev(after);
    const double ratio =
        static_cast<double>(points_done - before.points) / static_cast<double>(after->points - before.points);
    return before.seconds + ratio * (after->seconds - before.seconds);
}

double JobEstimate::forecast_between(std::uint64_t begin, std::uint64_t end) const noexcept {
    return seconds_at(forecast_, end) - seconds_at(forecast_, begin);
}

double JobEstimate::seconds_to(std::uint64_t points_done) const noexcept {
    if (points_done > points()) return seconds() + forecast_between(points(), points_done);
    const auto after = std::ranges::upper_bound(marks_, points_done, {}, &PlannedSoFar::points);
    if (after == marks_.begin() || after == marks_.end() || after->points > forecast_.back().points)
        return seconds_at(marks_, points_done);
    const PlannedSoFar& before = *std::prev(after);
    const double way_s = forecast_between(before.points, after->points);
    if (way_s <= 0.0) return seconds_at(marks_, points_done);
    const double share = forecast_between(before.points, points_done) / way_s;
    return before.seconds + share * (after->seconds - before.seconds);
}

TimeLeft JobEstimate::left(std::uint64_t points_done, std::uint64_t points_total) const noexcept {
    const bool is_planned = points_total <= points();
    if (!is_planned && points_total > forecast_.back().points) return {};
    return {std::max(0.0, seconds_to(points_total) - seconds_to(points_done)), is_planned};
}

}  // namespace psicarve::plan
