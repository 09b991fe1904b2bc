// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace psicarve::slice {

/// Grows with the angle of (x, y) from 0 (at +x) to 4 (a turn), a quarter turn for each 1, without
/// trigonometry; opposite directions differ by exactly 2. (0, 0) gives 0.
inline double diamond_angle(double x, double y) noexcept {
    constexpr double kNotZero = 1e-300;
    const double slope = y / (std::abs(x) + std::abs(y) + kNotZero);
    if (x < 0.0) return 2.0 - slope;
    return slope < 0.0 ? 4.0 + slope : slope;
}

/// The directions a layer is sampled at, in ascending order of angle once round the axis.
class Directions {
public:
    /// Requires ascending angles [rad] that span less than a whole turn, the first in [0, 2 pi).
    explicit Directions(std::span<const double> ascending_rad);

    std::size_t count() const noexcept { return cosine_.size(); }
    const double* cosine() const noexcept { return cosine_.data(); }
    const double* sine() const noexcept { return sine_.data(); }

    /// Internally, directions are sorted from angle 0: sorted cell 0 is the caller's direction
    /// first_sorted().
    std::size_t first_sorted() const noexcept { return first_sorted_; }

    /// How many sorted directions lie at or before this diamond angle: 0 .. count().
    std::uint32_t count_up_to(double diamond) const noexcept {
        std::uint32_t k = guess_[static_cast<std::uint32_t>(diamond * bins_per_unit_)];
        // Where directions are even a bin holds one or none, which no processor predicts: so no branch here.
        k += diamond_[k] <= diamond ? 1U : 0U;
        while (diamond_[k] <= diamond) ++k;
        return k;
    }

private:
    std::vector<double> cosine_;
    std::vector<double> sine_;
    std::vector<double> diamond_;       ///< of every direction, and a last one that no angle reaches
    std::vector<std::uint32_t> guess_;  ///< directions before each bin of diamond angles
    double bins_per_unit_ = 0.0;
    std::size_t first_sorted_ = 0;
};

/// The 2 * (point_count - 1) directions of a turn, at exactly the whole-pulse table angles of a layer's
/// points and half a turn further: R1's in even and odd layers, and so R2's. All are turned by `offset_deg`
/// (R2's angle error). Requires point_count >= 2 and an even pulses_per_rev.
std::vector<double> full_circle_rad(std::int64_t point_count, std::int64_t pulses_per_rev, double offset_deg);

}  // namespace psicarve::slice
