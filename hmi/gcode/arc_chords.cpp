// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/arc_chords.hpp"

#include <algorithm>
#include <cmath>

#include "hmi/gcode/arc.hpp"
#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

/// However small the circle, it keeps eight corners.
constexpr double kMostChordRad = kPi / 4.0;
/// Less is no machine's pulse, and more points than can be counted.
constexpr double kLeastChordMm = 1e-7;

/// A chord over an angle a is r (1 - cos(a / 2)) = 2 r sin(a / 4)^2 off its circle.
double chord_rad(double radius_mm, double chord_mm) noexcept {
    const double sine = std::sqrt(std::max(chord_mm, kLeastChordMm) / (2.0 * radius_mm));
    return sine >= 1.0 ? kMostChordRad : std::min(kMostChordRad, 4.0 * std::asin(sine));
}

}  // namespace

ArcChords::ArcChords(const CanonRecord& arc, double chord_mm) noexcept
    : start_(arc.start),
      end_(arc.end),
      plane_(arc.plane),
      centre_first_mm_(arc.centre_first_mm),
      centre_second_mm_(arc.centre_second_mm) {
    const PlanePoint from{start_[plane_->first], start_[plane_->second]};
    const PlanePoint to{end_[plane_->first], end_[plane_->second]};
    const PlanePoint centre{centre_first_mm_, centre_second_mm_};
    const auto radius_mm = [&](const PlanePoint& point) {
        return std::hypot(point.first_mm - centre.first_mm, point.second_mm - centre.second_mm);
    };
    start_radius_mm_ = radius_mm(from);
    end_radius_mm_ = radius_mm(to);
    start_rad_ = std::atan2(from.second_mm - centre.second_mm, from.first_mm - centre.first_mm);
    sweep_rad_ = sweep_rad(from, to, centre, arc.turns);
    const double chords =
        std::ceil(std::abs(sweep_rad_) / chord_rad(std::max(start_radius_mm_, end_radius_mm_), chord_mm));
    count_ = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(chords));
}

Position ArcChords::end_of(std::uint64_t number) const noexcept {
    if (number >= count_) return end_;
    const double share = static_cast<double>(number) / static_cast<double>(count_);
    Position at;
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        at[axis] = start_[axis] + share * (end_[axis] - start_[axis]);
    const double angle_rad = start_rad_ + share * sweep_rad_;
    const double radius_mm = start_radius_mm_ + share * (end_radius_mm_ - start_radius_mm_);
    at[plane_->first] = centre_first_mm_ + radius_mm * std::cos(angle_rad);
    at[plane_->second] = centre_second_mm_ + radius_mm * std::sin(angle_rad);
    return at;
}

}  // namespace psicarve::gcode
