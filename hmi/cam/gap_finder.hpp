// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "hmi/slice/directions.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cam {

/// Finds the gap between two neighbouring directions that a place lies in, and about where, without
/// trigonometry.
class GapFinder {
public:
    static constexpr std::size_t kUnsure = ~std::size_t{0};

    /// Requires ascending directions once round, the first 0.
    explicit GapFinder(std::span<const double> round_rad) : directions_(round_rad) {
        constexpr double kWidest_rad = 0.4;
        for (std::size_t gap = 0; gap < round_rad.size(); ++gap) {
            const double end_rad = gap + 1 < round_rad.size() ? round_rad[gap + 1] : 2.0 * kPi;
            is_fine_ = is_fine_ && end_rad - round_rad[gap] < kWidest_rad;
            gaps_per_rad_.push_back(1.0 / (end_rad - round_rad[gap]));
            ends_.push_back(slice::diamond_angle(std::cos(end_rad), std::sin(end_rad)));
        }
        ends_.back() = kTurn;
    }

    /// For (x, y); kUnsure for a place too near to a direction, or where gaps are too wide.
    std::size_t gap_at(double x, double y) const noexcept {
        if (!is_fine_) return kUnsure;
        const double diamond = slice::diamond_angle(x, y);
        const std::size_t gap = directions_.count_up_to(diamond) - std::size_t{1};
        if (gap >= ends_.size()) return kUnsure;
        constexpr double kTooNear = 1e-12;  // rounding is a thousand times less
        const double begin = gap > 0 ? ends_[gap - 1] : 0.0;
        return diamond - begin < kTooNear || ends_[gap] - diamond < kTooNear ? kUnsure : gap;
    }

    struct Along {
        double least;
        double most;
    };
    /// How far (x, y) lies along its gap, from its begin 0 to its end 1: between from and to.
    Along along(std::size_t gap, double x, double y) const noexcept {
        // The sine of what it lies behind the gap's begin; of less than 0.5 the angle is s to s + s^3 / 4.
        const double sine =
            (directions_.cosine()[gap] * y - directions_.sine()[gap] * x) / std::sqrt(x * x + y * y);
        constexpr double kRounding = 1e-12;
        return {(sine - kRounding) * gaps_per_rad_[gap],
                (sine + kRounding + 0.25 * sine * sine * sine) * gaps_per_rad_[gap]};
    }

private:
    static constexpr double kTurn = 4.0;  ///< in diamond angles

    slice::Directions directions_;
    std::vector<double> ends_;  ///< of the gaps, diamond angles
    std::vector<double> gaps_per_rad_;
    bool is_fine_ = true;
};

}  // namespace psicarve::cam
