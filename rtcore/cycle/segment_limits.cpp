// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/segment_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rtcore/cycle/braking.hpp"

namespace psicarve::cycle {
namespace {

/// d2u/dt2 of motions that are known to be allowed here: along the profile of which the speed at hand is a
/// part or a mixture, and along the 200 % profile scaled down.
struct Known {
    double mixed;
    double scaled;
};

double part_of(double speed2, double profile, double slope) noexcept {
    return 0.5 * slope * (profile > 0.0 ? std::min(1.0, speed2 / profile) : 1.0);
}

Known known_accels(const SegmentLimits::Profiles& profiles, double speed2) noexcept {
    Known known{};
    known.scaled = part_of(speed2, profiles.high, profiles.high_slope);
    if (speed2 <= profiles.low || profiles.high <= profiles.low) {
        known.mixed = part_of(speed2, profiles.low, profiles.low_slope);
        return known;
    }
    const double share = std::min(1.0, (speed2 - profiles.low) / (profiles.high - profiles.low));
    known.mixed = 0.5 * (profiles.low_slope + share * (profiles.high_slope - profiles.low_slope));
    return known;
}

}  // namespace

SegmentLimits::Profiles SegmentLimits::profiles_at(double way) const noexcept {
    const double per_tick2 = period_s_ * period_s_;
    Profiles found{};
    found.low_slope = (timing_.end_speed2[0] - timing_.start_speed2[0]) / timing_.length * per_tick2;
    found.high_slope = (timing_.end_speed2[1] - timing_.start_speed2[1]) / timing_.length * per_tick2;
    found.low = std::max(0.0, timing_.start_speed2[0] * per_tick2 + found.low_slope * way);
    found.high = std::max(found.low, timing_.start_speed2[1] * per_tick2 + found.high_slope * way);
    return found;
}

/// The acceleration that every axis has left at this speed, either way; may be negative: then none is known.
double SegmentLimits::spare_accel(double speed2) const noexcept {
    const double per_tick2 = period_s_ * period_s_;
    double spare = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        spare = std::min(spare,
                         double{timing_.accel_free[k]} * per_tick2 - double{timing_.accel_bend[k]} * speed2);
    }
    return spare > 0.0 ? kSteeringShare * spare : spare;
}

double SegmentLimits::rising_accel(const Profiles& profiles, double speed) const noexcept {
    const double speed2 = speed * speed;
    const Known known = known_accels(profiles, speed2);
    double accel = std::max(known.mixed, known.scaled);
    const double spare = spare_accel(speed2);
    if (spare <= 0.0) return accel;
    // Faster at the tick's end, less is left: what is left there is safe all the way.
    const double faster = speed + spare;
    return std::max({accel, 0.0, spare_accel(faster * faster)});
}

double SegmentLimits::accel_along(const std::array<double, 2>& speed2, double way,
                                  double speed) const noexcept {
    const double per_tick2 = period_s_ * period_s_;
    const double slope = (speed2[1] - speed2[0]) / timing_.length * per_tick2;
    return part_of(speed * speed, speed2[0] * per_tick2 + slope * way, slope);
}

double SegmentLimits::falling_accel(const Profiles& profiles, double speed) const noexcept {
    const double speed2 = speed * speed;
    const Known known = known_accels(profiles, speed2);
    const double accel = std::min(known.mixed, known.scaled);
    const double spare = spare_accel(speed2);
    return spare > 0.0 ? std::min(accel, -spare) : accel;
}

}  // namespace psicarve::cycle
