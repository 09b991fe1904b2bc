// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/path/path_line.hpp"

#include <algorithm>
#include <cmath>

namespace psicarve::verify {

PathLine PathLine::between(const JobGeometry& geometry, std::size_t h, const Positions& from,
                           const Positions& to) {
    const HeadGeometry& head = geometry.head(h);
    const std::size_t radius = index_of(kHeads[h]);
    const std::size_t psi = index_of(Axis::psi);
    const double r_mm = std::max(head.real_mm(from[radius]), head.real_mm(to[radius]));
    const double psi_pulse_mm = std::max(r_mm, 0.0) * geometry.rad_per_pulse();
    const double radius_pulse_mm = 1.0 / head.pulses_per_mm;
    const double x_mm = static_cast<double>(to[psi] - from[psi]) * psi_pulse_mm;
    const double y_mm = static_cast<double>(to[radius] - from[radius]) * radius_pulse_mm;

    PathLine line;
    line.length_mm_ = std::hypot(x_mm, y_mm);
    const double ux = line.length_mm_ > 0.0 ? x_mm / line.length_mm_ : 1.0;
    const double uy = line.length_mm_ > 0.0 ? y_mm / line.length_mm_ : 0.0;
    line.across_psi_ = -uy * psi_pulse_mm;
    line.across_radius_ = ux * radius_pulse_mm;
    line.along_psi_ = ux * psi_pulse_mm;
    line.along_radius_ = uy * radius_pulse_mm;
    line.pulse_across_mm_ = std::max(std::abs(line.across_psi_), std::abs(line.across_radius_));
    line.pulse_along_mm_ = std::max(std::abs(line.along_psi_), std::abs(line.along_radius_));
    constexpr double kRounding_mm = 1e-9;
    line.pulse_along_mm_ += kRounding_mm;
    line.allowed_mm_ = geometry.tolerance_mm() + line.pulse_across_mm_ + kRounding_mm;
    return line;
}

PathLine::Distance PathLine::distance(std::int64_t psi_passed_pulses,
                                      std::int64_t radius_passed_pulses) const noexcept {
    const auto psi = static_cast<double>(psi_passed_pulses);
    const auto radius = static_cast<double>(radius_passed_pulses);
    const double across = std::abs(across_psi_ * psi + across_radius_ * radius);
    const double along = along_psi_ * psi + along_radius_ * radius;
    const double outside = std::max({0.0, -along, along - length_mm_});
    if (outside <= pulse_along_mm_) return {across, across, across <= allowed_mm_, across, allowed_mm_};
    // Past an end the way back to the line is longer; the tolerance is the same.
    const double mm = std::hypot(across, outside);
    return {mm, across, mm <= allowed_mm_, mm, allowed_mm_};
}

}  // namespace psicarve::verify
