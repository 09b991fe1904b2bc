// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/program/programmed_way.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "shared/base/units.hpp"

namespace psicarve::verify {
namespace {

/// Halvings until shares of a way no longer differ by anything.
constexpr int kSteps = 48;
constexpr double kGolden = 0.6180339887498949;

double hypot3(const std::array<double, 3>& v) noexcept {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

}  // namespace

WayScale::WayScale(const Profile& profile)
    : tip_mm{profile.r1.tip_mm(), profile.r2.tip_mm()},
      pulses_per_rev(static_cast<double>(profile.psi.pulses_per_rev)),
      rad_per_pulse(rad_from_pulses(1, profile.psi.pulses_per_rev)) {
    for (const Axis axis : kAllAxes) {
        const AxisMotion motion = axis_motion(profile, axis);
        pulses_per_unit[index_of(axis)] = motion.pulses_per_unit;
        speed_pps[index_of(axis)] = motion.speed_pps;
    }
    pulses_per_unit[kPsi] = pulses_per_rev / kDegPerRev;
}

double WayScale::pulses(Axis axis, double place) const noexcept {
    // In the order in which it is exact for whole pulses.
    if (axis == Axis::psi) return place * pulses_per_rev / kDegPerRev;
    return place * pulses_per_unit[index_of(axis)];
}

double WayScale::seconds_along(const Place& from, const Place& to) const noexcept {
    double length2 = 0.0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double seconds = (to[k] - from[k]) / speed_pps[k];
        length2 += seconds * seconds;
    }
    return std::sqrt(length2);
}

ProgrammedWay::ProgrammedWay(const WayScale& scale, const Place& from, const Place& to,
                             const std::optional<WayArc>& arc)
    : scale_(&scale), from_(from), to_(to), end_pulses_{}, arc_(arc), heads_{} {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        end_pulses_[k] = round_to_pulse(to[k]);
        most_pulses_ = std::max(most_pulses_, std::abs(to[k] - from[k]));
        whole_pulses_ = std::max(whole_pulses_, std::abs(end_pulses_[k] - round_to_pulse(from[k])));
    }
    const double arc_mm =
        arc ? std::abs(arc->sweep_rad) * std::max(arc->start_radius_mm, arc->end_radius_mm) : 0.0;
    if (arc) most_pulses_ = std::max(most_pulses_, arc_mm * scale.pulses_per_unit[kY]);
    for (std::size_t head = 0; head < kHeadCount; ++head) {
        const double pulse_mm = 1.0 / scale.pulses_per_unit[head];
        const auto turn_mm = [&](double radius) {
            return std::max(radius * pulse_mm + scale.tip_mm[head], 0.0) * scale.rad_per_pulse;
        };
        Head& of = heads_[head];
        of.pulse_mm = {turn_mm(std::max(from[head], to[head])), pulse_mm, 1.0 / scale.pulses_per_unit[kY]};
        const auto length_mm = [&](double psi_pulse_mm) {
            return hypot3({(to[kPsi] - from[kPsi]) * psi_pulse_mm, (to[head] - from[head]) * of.pulse_mm[1],
                           (to[kY] - from[kY]) * of.pulse_mm[2]});
        };
        of.length_mm = length_mm(of.pulse_mm[0]) + arc_mm;
    }
    if (!arc || arc->start_radius_mm != arc->end_radius_mm || from[kPsi] != to[kPsi]) return;
    for (std::size_t head = 0; head < kHeadCount; ++head)
        if (!arc->moves_head[head] && from[head] != to[head]) return;
    turn_share_ = 2.0 * kPi / std::abs(arc->sweep_rad);
}

Place ProgrammedWay::at(double share) const noexcept {
    Place place;
    for (std::size_t k = 0; k < kAxisCount; ++k) place[k] = from_[k] + share * (to_[k] - from_[k]);
    if (!arc_) return place;
    const double angle_rad = arc_->start_rad + share * arc_->sweep_rad;
    const double radius_mm = arc_->start_radius_mm + share * (arc_->end_radius_mm - arc_->start_radius_mm);
    place[kY] = (arc_->centre_y_mm + radius_mm * std::sin(angle_rad)) * scale_->pulses_per_unit[kY];
    for (std::size_t head = 0; head < kHeadCount; ++head)
        if (arc_->moves_head[head])
            place[head] =
                (arc_->centre_r_mm + radius_mm * std::cos(angle_rad)) * scale_->pulses_per_unit[head];
    return place;
}

double ProgrammedWay::Off::distance_mm() const noexcept {
    Space left;
    for (std::size_t k = 0; k < left.size(); ++k) left[k] = std::max(0.0, std::abs(mm[k]) - slack_mm[k]);
    return hypot3(left);
}

/// Of psi at the radius where the tip stands: where a way begins further out a pulse is wider.
ProgrammedWay::Space ProgrammedWay::pulse_mm(std::size_t head, const Positions& at) const noexcept {
    Space pulse_mm = heads_[head].pulse_mm;
    const double r_mm = static_cast<double>(at[head]) * pulse_mm[1] + scale_->tip_mm[head];
    pulse_mm[0] = std::max(r_mm, 0.0) * scale_->rad_per_pulse;
    return pulse_mm;
}

ProgrammedWay::Off ProgrammedWay::off(std::size_t head, const Positions& at, const Place& place,
                                      double pulses) const noexcept {
    const Space pulse_mm = this->pulse_mm(head, at);
    const std::array<std::size_t, 3> axes{kPsi, head, kY};
    Off off{};
    for (std::size_t k = 0; k < axes.size(); ++k) {
        off.mm[k] = (static_cast<double>(at[axes[k]]) - place[axes[k]]) * pulse_mm[k];
        off.slack_mm[k] = pulses * pulse_mm[k];
    }
    return off;
}

double ProgrammedWay::distance_mm(std::size_t head, const Positions& at, double share,
                                  double pulses) const noexcept {
    return off(head, at, this->at(share), pulses).distance_mm();
}

double ProgrammedWay::from_mm(const Place& place, std::size_t head, const Positions& at,
                              double pulses) const noexcept {
    return off(head, at, place, pulses).distance_mm();
}

double ProgrammedWay::both_mm(const Positions& at, double share, double pulses) const noexcept {
    return std::max(distance_mm(0, at, share, pulses), distance_mm(1, at, share, pulses));
}

/// Of a line's both distances are convex, and so is the larger of the two.
double ProgrammedWay::from_one_place_mm(const Positions& at, const WayTolerance& tolerance,
                                        const std::array<double, kHeadCount>& shares) const noexcept {
    double low = std::min(shares[0], shares[1]);
    double high = std::max(shares[0], shares[1]);
    const double pulses = tolerance.pulses;
    double least_mm = both_mm(at, low, pulses);
    if (least_mm > tolerance.mm && low < high) least_mm = std::min(least_mm, both_mm(at, high, pulses));
    for (int step = 0; step < kSteps && least_mm > tolerance.mm && low < high; ++step) {
        const double left = high - kGolden * (high - low);
        const double right = low + kGolden * (high - low);
        const double left_mm = both_mm(at, left, pulses);
        const double right_mm = both_mm(at, right, pulses);
        least_mm = std::min({least_mm, left_mm, right_mm});
        (left_mm <= right_mm ? high : low) = left_mm <= right_mm ? right : left;
    }
    return least_mm;
}

double ProgrammedWay::back_share(std::size_t head, const Positions& at,
                                 const WayTolerance& tolerance) const noexcept {
    const Space each_mm = arc_ ? heads_[head].pulse_mm : pulse_mm(head, at);
    const double length_mm =
        arc_ ? heads_[head].length_mm
             : hypot3({(to_[kPsi] - from_[kPsi]) * each_mm[0], (to_[head] - from_[head]) * each_mm[1],
                       (to_[kY] - from_[kY]) * each_mm[2]});
    if (length_mm <= 0.0) return 1.0;
    const bool turns = !arc_ || to_[kPsi] != from_[kPsi];
    const double pulse_mm = (turns ? each_mm[0] : 0.0) + each_mm[1] + each_mm[2];
    return (tolerance.mm + (tolerance.pulses + 1.0) * pulse_mm) / length_mm;
}

double ProgrammedWay::share_of_line(std::size_t head, const Positions& at) const noexcept {
    const Space pulse_mm = this->pulse_mm(head, at);
    const std::array<std::size_t, 3> axes{kPsi, head, kY};
    double along_mm2 = 0.0;
    double length_mm2 = 0.0;
    for (std::size_t k = 0; k < axes.size(); ++k) {
        const double way_mm = (to_[axes[k]] - from_[axes[k]]) * pulse_mm[k];
        along_mm2 += (static_cast<double>(at[axes[k]]) - from_[axes[k]]) * pulse_mm[k] * way_mm;
        length_mm2 += way_mm * way_mm;
    }
    return length_mm2 > 0.0 ? std::clamp(along_mm2 / length_mm2, 0.0, 1.0) : 0.0;
}

ProgrammedWay::Nearest ProgrammedWay::nearest(std::size_t head, const Positions& at,
                                              const WayTolerance& tolerance) const noexcept {
    const double guess = share_of_line(head, at);
    Nearest found{guess, distance_mm(head, at, guess, tolerance.pulses)};
    if (found.mm <= tolerance.mm) return found;
    // Pulses that count for nothing make another place the nearest: of a line's the distance is convex.
    double low = 0.0;
    double high = 1.0;
    for (int step = 0; step < kSteps; ++step) {
        const double left = high - kGolden * (high - low);
        const double right = low + kGolden * (high - low);
        if (distance_mm(head, at, left, tolerance.pulses) <= distance_mm(head, at, right, tolerance.pulses))
            high = right;
        else
            low = left;
    }
    const double share = 0.5 * (low + high);
    const double mm = distance_mm(head, at, share, tolerance.pulses);
    return mm < found.mm ? Nearest{share, mm} : found;
}

}  // namespace psicarve::verify
