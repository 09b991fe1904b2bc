// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/bending_weights.hpp"

#include <cstddef>

#include "rtcore/plan/wide.hpp"

namespace psicarve::plan {
namespace {

constexpr double kNearlyAll = 0.9;
// Bending that takes less of the acceleration than that everywhere leaves nothing to be bent otherwise.
constexpr double kLeastBendShare = 0.1;
// Another curve is to be worth the cuts that bending more evenly takes.
constexpr double kWorthwhile = 0.998;

/// By axis: what it accelerates in the middle of the cell, as a share of what it may, and what bending alone
/// takes of that.
PSICARVE_INLINE void accel_share(const PathCell& cell, double begin2, double end2, const Vec& inverse,
                                 Vec& share, Vec& bend_share) {
    Vec begin, end, bend;
    load(cell.slope_begin, begin);
    load(cell.slope_end, end);
    load(cell.bend, bend);
    const double mean2 = 0.5 * (begin2 + end2);
    const double rise2 = (end2 - begin2) / cell.length;
    bend_share = mean2 * bend * inverse;
    bend_share = bend_share < 0.0 ? -bend_share : bend_share;
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
    Vec most_bent{};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        Vec share, bend_share;
        accel_share(cells[i], speed2[i], speed2[i + 1], inverse, share, bend_share);
        raise_to(most_bent, bend_share);
        const Vec root = 0.5 + 0.5 * share;
        store(Vec(root * root), weights[i]);
        const double seconds = cell_seconds(cells[i].length, speed2[i], speed2[i + 1]);
        all_s += seconds;
        if (greatest_of(share) >= kNearlyAll) limited_s += seconds;
    }
    return greatest_of(most_bent) >= kLeastBendShare ? limited_s / all_s : 0.0;
}

bool is_worthwhile(const FittedTimes& even, const FittedTimes& least_bent) noexcept {
    if (!even.is_within || !least_bent.is_within) return even.is_within;
    return even.seconds[0] <= kWorthwhile * least_bent.seconds[0] && even.seconds[1] <= least_bent.seconds[1];
}

}  // namespace psicarve::plan
