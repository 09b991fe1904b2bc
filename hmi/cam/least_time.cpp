// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/least_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "shared/units.hpp"

namespace psicarve::cam {
namespace {

struct HeadPace {
    double mm_per_pulse;
    double tip_offset_mm;
    double speed_pps;

    /// From one point to the next, over the surface and along the head's own axis.
    double seconds(std::int64_t from, std::int64_t to, double turn_rad, double feed_mm_s) const {
        const double radius_mm =
            std::max(0.0, static_cast<double>(std::min(from, to)) * mm_per_pulse + tip_offset_mm);
        const auto way_pulses = static_cast<double>(std::abs(to - from));
        const double way_mm = way_pulses * mm_per_pulse;
        const double arc_mm = radius_mm * turn_rad;
        const double over_surface_s = std::sqrt(arc_mm * arc_mm + way_mm * way_mm) / feed_mm_s;
        return std::max(over_surface_s, way_pulses / speed_pps);
    }
};

HeadPace pace_of(const Profile& profile, Axis axis) {
    const AxisMotion motion = axis_motion(profile, axis);
    const double offset_mm = axis == Axis::r1 ? profile.r1.tip_offset_mm : profile.r2.tip_offset_mm;
    return {1.0 / motion.pulses_per_unit, offset_mm, motion.speed_pps};
}

}  // namespace

double least_carving_seconds(const JobView& job, const Profile& profile) {
    const HeadPace left = pace_of(profile, Axis::r1);
    const HeadPace right = pace_of(profile, Axis::r2);
    const double psi_speed_pps = axis_motion(profile, Axis::psi).speed_pps;
    const double rad_per_pulse = rad_from_pulses(1, profile.psi.pulses_per_rev);
    const double feed_mm_s = job.header().feed_mm_s;
    double seconds = 0.0;
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        const auto r_left = job.r_left_pulses(layer);
        const auto r_right = job.r_right_pulses(layer);
        std::int64_t before = job.psi_pulses(layer, 0);
        for (std::uint32_t point = 1; point < job.point_count(); ++point) {
            const std::int64_t psi = job.psi_pulses(layer, point);
            const auto turn_pulses = static_cast<double>(std::abs(psi - before));
            before = psi;
            const double turn_rad = turn_pulses * rad_per_pulse;
            seconds += std::max({left.seconds(r_left[point - 1], r_left[point], turn_rad, feed_mm_s),
                                 right.seconds(r_right[point - 1], r_right[point], turn_rad, feed_mm_s),
                                 turn_pulses / psi_speed_pps});
        }
    }
    return seconds;
}

}  // namespace psicarve::cam
