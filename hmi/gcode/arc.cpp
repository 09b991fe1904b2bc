// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/arc.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

constexpr double kLeastRadiusMm = 1e-4;
constexpr double kAnyDifferenceMm = 0.005;
constexpr double kMostDifferenceMm = 0.5;
constexpr double kMostDifferenceRatio = 0.001;

double distance_mm(const PlanePoint& a, const PlanePoint& b) noexcept {
    return std::hypot(a.first_mm - b.first_mm, a.second_mm - b.second_mm);
}

}  // namespace

std::optional<ArcFault> centre_fault(const PlanePoint& start, const PlanePoint& end,
                                     const PlanePoint& centre) {
    const double start_mm = distance_mm(start, centre);
    const double end_mm = distance_mm(end, centre);
    if (std::min(start_mm, end_mm) < kLeastRadiusMm)
        return ArcFault{ProblemCode::arc_radius_zero, phrase("the arc's centre lies on one of its ends")};
    const double difference_mm = std::abs(start_mm - end_mm);
    const double allowed_mm =
        std::min(kMostDifferenceMm, std::max(kAnyDifferenceMm, kMostDifferenceRatio * start_mm));
    if (difference_mm > allowed_mm)
        return ArcFault{ProblemCode::arc_radius_differs,
                        phrase("the arc's radius is %1 mm at its begin and %2 mm at its end",
                               mm_text(start_mm), mm_text(end_mm))};
    return std::nullopt;
}

std::optional<PlanePoint> centre_of_radius(const PlanePoint& start, const PlanePoint& end, double radius_mm,
                                           bool is_clockwise, std::optional<ArcFault>& fault) {
    const double chord_mm = distance_mm(start, end);
    if (chord_mm < kSamePlaceMm) {
        fault = ArcFault{ProblemCode::arc_whole_by_radius, phrase("the arc ends where it begins")};
        return std::nullopt;
    }
    const double half_mm = chord_mm / 2.0;
    const double magnitude_mm = std::abs(radius_mm);
    if (half_mm - magnitude_mm > kAnyDifferenceMm || magnitude_mm < kLeastRadiusMm) {
        fault = ArcFault{ProblemCode::arc_radius_small,
                         phrase("a radius of %1 mm does not reach the end, which is %2 mm away",
                                mm_text(magnitude_mm), mm_text(chord_mm))};
        return std::nullopt;
    }
    const double inside = (magnitude_mm - half_mm) * (magnitude_mm + half_mm);
    const double off_mm = inside > 0.0 ? std::sqrt(inside) : 0.0;
    const bool is_right = is_clockwise == (radius_mm > 0.0);
    const double side = is_right ? off_mm : -off_mm;
    const double along_first = (end.first_mm - start.first_mm) / chord_mm;
    const double along_second = (end.second_mm - start.second_mm) / chord_mm;
    return PlanePoint{(start.first_mm + end.first_mm) / 2.0 + side * along_second,
                      (start.second_mm + end.second_mm) / 2.0 - side * along_first};
}

double sweep_rad(const PlanePoint& start, const PlanePoint& end, const PlanePoint& centre,
                 int turns) noexcept {
    constexpr double kWholeRad = 2.0 * kPi;
    const double others_rad = kWholeRad * static_cast<double>(std::abs(turns) - 1);
    double sweep = std::atan2(end.second_mm - centre.second_mm, end.first_mm - centre.first_mm) -
                   std::atan2(start.second_mm - centre.second_mm, start.first_mm - centre.first_mm);
    if (turns < 0) sweep = -sweep;
    if (distance_mm(start, end) < kSamePlaceMm) {
        sweep = kWholeRad;
    } else if (sweep <= kSameDirectionRad) {
        sweep += kWholeRad;
    }
    return turns < 0 ? -(sweep + others_rad) : sweep + others_rad;
}

ArcExtents arc_extents(const PlanePoint& from, const PlanePoint& to, const PlanePoint& centre,
                       int turns) noexcept {
    const double radius_mm = std::hypot(from.first_mm - centre.first_mm, from.second_mm - centre.second_mm);
    const double start_rad = std::atan2(from.second_mm - centre.second_mm, from.first_mm - centre.first_mm);
    const double sweep = sweep_rad(from, to, centre, turns);
    const double begin_rad = std::min(start_rad, start_rad + sweep);
    const double end_rad = std::max(start_rad, start_rad + sweep);
    const auto passes = [&](double angle_rad) {
        const double next = angle_rad + 2.0 * kPi * std::ceil((begin_rad - angle_rad) / (2.0 * kPi));
        return next <= end_rad;
    };
    ArcExtents found{{std::min(from.first_mm, to.first_mm), std::min(from.second_mm, to.second_mm)},
                     {std::max(from.first_mm, to.first_mm), std::max(from.second_mm, to.second_mm)}};
    if (passes(0.0)) found.most_mm[0] = centre.first_mm + radius_mm;
    if (passes(kPi / 2.0)) found.most_mm[1] = centre.second_mm + radius_mm;
    if (passes(kPi)) found.least_mm[0] = centre.first_mm - radius_mm;
    if (passes(-kPi / 2.0)) found.least_mm[1] = centre.second_mm - radius_mm;
    return found;
}

}  // namespace psicarve::gcode
