// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/directions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/base/units.hpp"

namespace psicarve::slice {
namespace {

constexpr double kDiamondTurn = 4.0;

}  // namespace

Directions::Directions(std::span<const double> ascending_rad) {
    const std::size_t n = ascending_rad.size();
    std::vector<double> diamond(n);
    for (std::size_t i = 0; i < n; ++i) {
        diamond[i] = diamond_angle(std::cos(ascending_rad[i]), std::sin(ascending_rad[i]));
    }
    // Where the list passes angle 0 its diamond angles fall back.
    const auto lowest = std::min_element(diamond.begin(), diamond.end());
    first_sorted_ = n == 0 ? 0 : static_cast<std::size_t>(lowest - diamond.begin());
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t from = (i + first_sorted_) % n;
        cosine_.push_back(std::cos(ascending_rad[from]));
        sine_.push_back(std::sin(ascending_rad[from]));
        diamond_.push_back(diamond[from]);
    }
    diamond_.push_back(2.0 * kDiamondTurn);

    const std::size_t bins = 2 * n + 1;
    bins_per_unit_ = static_cast<double>(bins) / kDiamondTurn;
    std::uint32_t before = 0;
    for (std::size_t b = 0; b <= bins; ++b) {  // the last bin holds a whole turn itself
        while (diamond_[before] * bins_per_unit_ < static_cast<double>(b)) ++before;
        guess_.push_back(before);
    }
}

std::vector<double> full_circle_rad(std::int64_t point_count, std::int64_t pulses_per_rev,
                                    double offset_deg) {
    const std::int64_t sweep = pulses_per_rev / 2;
    double first_deg = std::fmod(offset_deg, kDegPerRev);
    if (first_deg < 0.0) first_deg += kDegPerRev;
    const double first_rad = rad_from_deg(first_deg);
    std::vector<double> angles;
    for (std::int64_t half = 0; half < 2; ++half) {
        for (std::int64_t j = 0; j + 1 < point_count; ++j) {
            const std::int64_t pulses = half * sweep + point_angle_pulses(j, sweep, point_count);
            angles.push_back(first_rad + rad_from_pulses(pulses, pulses_per_rev));
        }
    }
    return angles;
}

}  // namespace psicarve::slice
