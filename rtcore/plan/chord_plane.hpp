// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "rtcore/plan/path.hpp"
#include "rtcore/plan/wide.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {

/// Which places are judged: where a way may be cut, after which the DDA rounds once more, or the pulses.
enum class JudgedPlaces { cuts, pulses };

/// One head's plane around a job's chord: along and across it [mm], from pulses past the chord's begin.
class ChordPlane {
public:
    ChordPlane(const MachineLimits& limits, const PathSpan& span, std::size_t head, JudgedPlaces places)
        : head_(head) {
        const double psi_mm = std::max(span.radius_mm[head], 0.0) * rad_from_pulses(1, limits.pulses_per_rev);
        const double radius_mm = 1.0 / limits.axes[head].pulses_per_unit;
        const double x_mm = span.slope[kPsi] * span.length * psi_mm;
        const double y_mm = span.slope[head] * span.length * radius_mm;
        length_mm_ = std::sqrt(x_mm * x_mm + y_mm * y_mm);
        const double ux = length_mm_ > 0.0 ? x_mm / length_mm_ : 1.0;
        const double uy = length_mm_ > 0.0 ? y_mm / length_mm_ : 0.0;
        across_psi_ = -uy * psi_mm;
        across_radius_ = ux * radius_mm;
        along_psi_ = ux * psi_mm;
        along_radius_ = uy * radius_mm;
        pulse_along_mm_ = std::max(std::abs(along_psi_), std::abs(along_radius_));
        // Rule 1 grants the greater of the two axes' pulses; half of both is the DDA's.
        const double psi_share_mm = std::abs(across_psi_);
        const double radius_share_mm = std::abs(across_radius_);
        const double granted_mm = limits.path_tolerance_mm + std::max(psi_share_mm, radius_share_mm);
        const bool is_cut = places == JudgedPlaces::cuts;
        inverse_allowed_ =
            1.0 / (is_cut ? granted_mm - 0.5 * (psi_share_mm + radius_share_mm) : granted_mm + kRounding_mm);
    }

    /// How far from the chord, its ends included, as a share of what is allowed.
    PSICARVE_INLINE double share_of_allowed(const Vec& passed) const {
        const double across = across_psi_ * passed[kPsi] + across_radius_ * passed[head_];
        const double along = along_psi_ * passed[kPsi] + along_radius_ * passed[head_];
        const double outside = std::max(-along, along - length_mm_);
        const double distance_mm =
            outside <= pulse_along_mm_ ? std::abs(across) : std::sqrt(across * across + outside * outside);
        return distance_mm * inverse_allowed_;
    }

private:
    static constexpr double kRounding_mm = 1e-9;

    std::size_t head_;
    double length_mm_;
    double across_psi_;
    double across_radius_;
    double along_psi_;
    double along_radius_;
    double pulse_along_mm_;
    double inverse_allowed_;
};

}  // namespace psicarve::plan
