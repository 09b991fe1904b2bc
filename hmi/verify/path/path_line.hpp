// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "hmi/surface/job_geometry.hpp"

namespace psicarve::verify {

/// The straight line between two neighbouring points of a layer, in one head's plane (r*dpsi, R) [mm].
class PathLine {
public:
    /// r is the larger of the two ends' radii, so that no way between them seems shorter than it is.
    static PathLine between(const JobGeometry& geometry, std::size_t h, const Positions& from,
                            const Positions& to);

    struct Distance {
        double mm;         ///< from the line between the ends
        double across_mm;  ///< its part across the line
        bool is_allowed;
        double judged_mm;   ///< compared with `allowed_mm`: the way across, or beyond the line's ends
        double allowed_mm;  ///< of that
    };
    Distance distance(std::int64_t psi_passed_pulses, std::int64_t radius_passed_pulses) const noexcept;

    /// One pulse of the coarser axis, seen across the line.
    double pulse_across_mm() const noexcept { return pulse_across_mm_; }

private:
    double across_psi_ = 0.0;  ///< mm across the line per psi pulse
    double across_radius_ = 0.0;
    double along_psi_ = 0.0;
    double along_radius_ = 0.0;
    double length_mm_ = 0.0;
    double allowed_mm_ = 0.0;
    double pulse_across_mm_ = 0.0;
    double pulse_along_mm_ = 0.0;
};

}  // namespace psicarve::verify
