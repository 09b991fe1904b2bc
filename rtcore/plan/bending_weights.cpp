// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/bending_weights.hpp"

#include <cstddef>

#include "rtcore/plan/wide.hpp"

namespace psicarve::plan {
namespace {

constexpr double kNearlyAll = 0.9;

/// By axis: what it accelerates in the middle of the cell, as a share of what it may.
PSICARVE_INLINE void accel_share(const PathCell& cell, double begin2, double end2, const Vec& inverse,
                                 Vec& share) {
    Vec begin, end, bend;
    load(cell.slope_begin, begin);
    load(cell.slope_end, end);
    load(cell.bend, bend);
    const double mean2 = 0.5 * (begin2 + end2);
    const double rise2 = (end2 - begin2) / cell.length;
    share = (mean2 * bend + (0.25 * rise2) * (begin + end)) * inverse;
    share = share < 0.0 ? -share : share;
    lower_to(share, Vec(Vec{} + 1.0));
}

}  // namespace

PSICARVE_FOR_WIDE_REGISTERS
double weigh_bending(std::span<const PathCell> cells, std::span<const double> speed2, const Lanes& accel,
                     std::vector<Lanes>& weights) {
    weights.resize(cells.size());
    Vec inverse;
    for (std::size_t k = 0; k < kAxisCount; ++k) inverse[k] = 1.0 / accel[k];
    double all_s = 0.0;
    double limited_s = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        Vec share;
        accel_share(cells[i], speed2[i], speed2[i + 1], inverse, share);
        const Vec root = 0.5 + 0.5 * share;
        store(Vec(root * root), weights[i]);
        const double seconds = cell_seconds(cells[i].length, speed2[i], speed2[i + 1]);
        all_s += seconds;
        if (greatest_of(share) >= kNearlyAll) limited_s += seconds;
    }
    return limited_s / all_s;
}

}  // namespace psicarve::plan
