// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/polar_way.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

constexpr double kTurnRad = 2.0 * kPi;

double length_mm_of(const PlanePoint& point) noexcept {
    return std::hypot(point.first_mm, point.second_mm);
}

/// The first angle from `begin_rad` on, upwards, that is the same direction.
double next_rad(double angle_rad, double begin_rad) noexcept {
    return angle_rad + kTurnRad * std::ceil((begin_rad - angle_rad) / kTurnRad);
}

}  // namespace

PolarWay PolarWay::line(const PlanePoint& from, const PlanePoint& to) noexcept {
    PolarWay way;
    way.from_ = from;
    way.to_ = to;
    const double first_mm = to.first_mm - from.first_mm;
    const double second_mm = to.second_mm - from.second_mm;
    way.length_mm_ = std::hypot(first_mm, second_mm);
    if (way.length_mm_ > 0.0) {
        way.foot_mm_ = -(from.first_mm * first_mm + from.second_mm * second_mm) / way.length_mm_;
        way.distance_mm_ = std::abs(from.first_mm * second_mm - from.second_mm * first_mm) / way.length_mm_;
    }
    return way;
}

PolarWay PolarWay::arc(const PlanePoint& from, const PlanePoint& to, const PlanePoint& centre,
                       double sweep_rad) noexcept {
    PolarWay way;
    way.is_arc_ = true;
    way.from_ = from;
    way.to_ = to;
    way.centre_ = centre;
    way.centre_mm_ = length_mm_of(centre);
    way.centre_rad_ = std::atan2(centre.second_mm, centre.first_mm);
    const PlanePoint begin{from.first_mm - centre.first_mm, from.second_mm - centre.second_mm};
    way.start_radius_mm_ = length_mm_of(begin);
    way.end_radius_mm_ = std::hypot(to.first_mm - centre.first_mm, to.second_mm - centre.second_mm);
    way.start_rad_ = std::atan2(begin.second_mm, begin.first_mm);
    way.sweep_rad_ = sweep_rad;
    way.length_mm_ = way.start_radius_mm_ * std::abs(sweep_rad);
    return way;
}

double PolarWay::radius_mm(double share) const noexcept {
    return start_radius_mm_ + share * (end_radius_mm_ - start_radius_mm_);
}

double PolarWay::angle_rad(double share) const noexcept {
    return start_rad_ + share * sweep_rad_;
}

PlanePoint PolarWay::at(double share) const noexcept {
    if (share <= 0.0) return from_;
    if (share >= 1.0) return to_;
    if (is_arc_)
        return {centre_.first_mm + radius_mm(share) * std::cos(angle_rad(share)),
                centre_.second_mm + radius_mm(share) * std::sin(angle_rad(share))};
    return {from_.first_mm + share * (to_.first_mm - from_.first_mm),
            from_.second_mm + share * (to_.second_mm - from_.second_mm)};
}

/// Of an arc, z = D + R e^(i a): where the axis lies within the circle z = R e^(i a) (1 + (D/R) e^(-i a)),
/// else z = D (1 + (R/D) e^(i a)). The last factor has its real part above 0, or passes -1 only where z is 0:
/// so its direction makes no jump, and that of z counts all turns.
double PolarWay::direction_rad(double share) const noexcept {
    const double angle = angle_rad(share);
    const double radius = radius_mm(share);
    const bool is_within = 2.0 * centre_mm_ < start_radius_mm_ + end_radius_mm_;
    const double ratio = is_within ? centre_mm_ / radius : radius / centre_mm_;
    const double between_rad = is_within ? centre_rad_ - angle : angle - centre_rad_;
    const double rest_rad = std::atan2(ratio * std::sin(between_rad), 1.0 + ratio * std::cos(between_rad));
    return (is_within ? angle : centre_rad_) + rest_rad;
}

double PolarWay::turned_rad(double share) const noexcept {
    if (is_arc_) return direction_rad(share) - direction_rad(0.0);
    // A line turns by less than half a turn.
    const PlanePoint there = at(share);
    return std::atan2(from_.first_mm * there.second_mm - from_.second_mm * there.first_mm,
                      from_.first_mm * there.first_mm + from_.second_mm * there.second_mm);
}

double PolarWay::nearest_share() const noexcept {
    if (!is_arc_) return length_mm_ > 0.0 ? std::clamp(foot_mm_ / length_mm_, 0.0, 1.0) : 0.0;
    const double least_rad = std::min(start_rad_, start_rad_ + sweep_rad_);
    const double inward_rad = next_rad(centre_rad_ + kPi, least_rad);
    const double share = (inward_rad - start_rad_) / sweep_rad_;
    if (share >= 0.0 && share <= 1.0) return share;
    return length_mm_of(from_) < length_mm_of(to_) ? 0.0 : 1.0;
}

/// Of the circle with the radius between both, where these differ, and so much more to both sides.
PolarWay::Range PolarWay::range(double from, double to) const noexcept {
    if (!is_arc_) {
        const double begin_mm = from * length_mm_ - foot_mm_;
        const double end_mm = to * length_mm_ - foot_mm_;
        const bool has_foot = begin_mm <= 0.0 && end_mm >= 0.0;
        const double near_mm = has_foot ? 0.0 : std::min(std::abs(begin_mm), std::abs(end_mm));
        const double far_mm = std::max(std::abs(begin_mm), std::abs(end_mm));
        return {std::hypot(distance_mm_, near_mm), std::hypot(distance_mm_, far_mm)};
    }
    const double half_mm = std::abs(end_radius_mm_ - start_radius_mm_) / 2.0;
    const double radius = (start_radius_mm_ + end_radius_mm_) / 2.0;
    const double begin_rad = std::min(angle_rad(from), angle_rad(to));
    const double end_rad = std::max(angle_rad(from), angle_rad(to));
    const auto distance_mm = [&](double angle) {
        return std::hypot(centre_.first_mm + radius * std::cos(angle),
                          centre_.second_mm + radius * std::sin(angle));
    };
    Range found{std::min(distance_mm(begin_rad), distance_mm(end_rad)),
                std::max(distance_mm(begin_rad), distance_mm(end_rad))};
    if (next_rad(centre_rad_ + kPi, begin_rad) <= end_rad) found.least_mm = std::abs(radius - centre_mm_);
    if (next_rad(centre_rad_, begin_rad) <= end_rad) found.most_mm = radius + centre_mm_;
    return {std::max(0.0, found.least_mm - half_mm), found.most_mm + half_mm};
}

double PolarWay::least_radius_mm(double from, double to) const noexcept {
    return range(from, to).least_mm;
}

/// Distance q and direction t of the way are functions of its parameter; a chord replaces each by its linear
/// interpolation over a piece h of it, which is off by h^2/8 max|q''| and h^2/8 max|t''| at most. Two points
/// at distances q1, q2, dq apart, whose directions are dt apart, are sqrt(dq^2 + 4 q1 q2 sin^2(dt/2)) away
/// from each other, no more than hypot(dq, q_max dt). So
///     deviation <= h^2/8 hypot(max|q''|, q_max max|t''|).
double PolarWay::deviation_mm(double from, double to) const noexcept {
    return is_arc_ ? arc_deviation_mm(from, to) : line_deviation_mm(from, to);
}

/// Of a line at the distance d, by its length s from the foot: q = sqrt(d^2 + s^2), q'' = d^2/q^3, t =
/// atan(s/d), t'' = -2 s d/q^4.
double PolarWay::line_deviation_mm(double from, double to) const noexcept {
    const Range radii = range(from, to);
    const double piece_mm = (to - from) * length_mm_;
    const double cubed = radii.least_mm * radii.least_mm * radii.least_mm;
    if (!(cubed > 0.0)) return radii.most_mm;
    const double along_mm = std::min(radii.least_mm, std::max(std::abs(from * length_mm_ - foot_mm_),
                                                              std::abs(to * length_mm_ - foot_mm_)));
    const double outward = distance_mm_ * distance_mm_ / cubed;
    const double around = 2.0 * along_mm * distance_mm_ / (cubed * radii.least_mm);
    return piece_mm * piece_mm / 8.0 * std::hypot(outward, radii.most_mm * around);
}

/// Of an arc z = D + R e^(i a), by its angle a, with R' = dR/da: w = (ln z)' = q'/q + i t', and
///     w' = e^(i a) ((-R + 2 i R') D - R'^2 e^(i a)) / z^2,    |w'| <= (hypot(R, 2R') |D| + R'^2) / q^2 =
///     A/q^2, q q' = Re(z' conj(z)),    |q'| <= hypot(R, R'),    |q'| <= (hypot(R, R') |D| + R |R'|)/q, q'' =
///     q Re(w') + q'^2/q,    t'' = Im(w').
/// About the axis itself, D = 0 and R' = 0, all vanish: one way does for all turns.
double PolarWay::arc_deviation_mm(double from, double to) const noexcept {
    const Range radii = range(from, to);
    const double least_mm = radii.least_mm;
    if (!(least_mm > 0.0)) return radii.most_mm;
    const double piece_rad = (to - from) * sweep_rad_;
    const double radius = std::max(start_radius_mm_, end_radius_mm_);
    const double growth =
        sweep_rad_ != 0.0 ? std::abs((end_radius_mm_ - start_radius_mm_) / sweep_rad_) : 0.0;
    const double bend = std::hypot(radius, 2.0 * growth) * centre_mm_ + growth * growth;
    const double speed = std::hypot(radius, growth);
    const double away = std::min(speed, (speed * centre_mm_ + radius * growth) / least_mm);
    const double outward = (bend + away * away) / least_mm;
    const double around = bend / (least_mm * least_mm);
    return piece_rad * piece_rad / 8.0 * std::hypot(outward, radii.most_mm * around);
}

}  // namespace psicarve::gcode
