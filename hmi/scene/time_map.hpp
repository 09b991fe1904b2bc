// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "shared/job/point_plan.hpp"

namespace psicarve::session {

/// How long the heads take from point to point, and what bounds that, unrolled as the job's radii are
/// (RadiusMap): columns are directions of the workpiece, 0 to 360 degrees, rows layers of the finishing pass
/// from the lowest up. Both heads carve at the same time: what a way takes stands at both of its places. A
/// cell of several ways has their mean, and what bounds most of their time; of very large jobs not all
/// layers count.
struct TimeMap {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<float> way_ms;     ///< [rows * columns]
    std::vector<WayBound> bounds;  ///< likewise
    double most_ms = 0.0;          ///< so that no more than one cell in fifty takes longer; > 0
    std::array<double, kWayBoundCount> bound_ratio{};  ///< of the carving's time, by bound; of all passes
};
/// Requires a plan of that job.
TimeMap time_map(const cam::PreparedJob& job, const PointPlan& plan, std::size_t most_columns,
                 std::size_t most_rows);

/// As pictures, 0xFFRRGGBB, highest layer first.
std::vector<std::uint32_t> time_picture(const TimeMap& map);
std::vector<std::uint32_t> bound_picture(const TimeMap& map,
                                         const std::array<std::uint32_t, kWayBoundCount>& colours);

}  // namespace psicarve::session
