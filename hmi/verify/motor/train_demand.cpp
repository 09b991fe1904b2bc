// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/motor/train_demand.hpp"

#include <algorithm>

#include "hmi/verify/motor/train_follower.hpp"

namespace psicarve::verify {

namespace {

constexpr double kPrecision_ratio = 1e-4;
constexpr double kMostAccel_ratio = 1e4;
constexpr double kMostSpeed_ratio = 1e3;

bool can_follow(std::span<const TrainEvent> stretch, const MotorLimits& limits) {
    if (stretch.empty()) return true;
    TrainFollower follower(limits, stretch.front().time_ns);
    return std::all_of(stretch.begin(), stretch.end(),
                       [&](const TrainEvent& event) { return follower.take(event); });
}

/// The least value that suffices between `low`, which does not, and `most`; nothing: `most` does not either.
template <typename Does>
double least_that_does(double low, double most, const Does& does) {
    double high = low;
    do {
        low = high;
        high = std::min(2.0 * low, most);
        if (does(high)) break;
    } while (high < most);
    while (high - low > kPrecision_ratio * high) {
        const double middle = 0.5 * (low + high);
        (does(middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace

TrainDemand demand_of(std::span<const TrainEvent> stretch, const MotorLimits& limits) {
    const auto with_accel = [&](double accel_pps2) {
        MotorLimits other = limits;
        other.accel_pps2 = accel_pps2;
        return can_follow(stretch, other);
    };
    const auto with_speed = [&](double speed_pps) {
        MotorLimits other = limits;
        other.speed_pps = speed_pps;
        other.accel_pps2 = kMostAccel_ratio * limits.accel_pps2;
        return can_follow(stretch, other);
    };
    const double most_pps2 = kMostAccel_ratio * limits.accel_pps2;
    if (with_accel(most_pps2)) return {false, least_that_does(limits.accel_pps2, most_pps2, with_accel)};
    return {true, least_that_does(limits.speed_pps, kMostSpeed_ratio * limits.speed_pps, with_speed)};
}

}  // namespace psicarve::verify
