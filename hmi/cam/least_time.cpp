// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/least_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "shared/base/units.hpp"
#include "shared/job/outside.hpp"

namespace psicarve::cam {
namespace {

struct HeadPace {
    double mm_per_pulse;
    double tip_offset_mm;
    double speed_pps;

    struct Way {
        double path_mm;  ///< over the surface
        double seconds;  ///< along the head's own axis at its top speed
    };
    Way way(std::int64_t from, std::int64_t to, double turn_rad) const {
        const double radius_mm =
            std::max(0.0, static_cast<double>(std::min(from, to)) * mm_per_pulse + tip_offset_mm);
        const auto way_pulses = static_cast<double>(std::abs(to - from));
        const double way_mm = way_pulses * mm_per_pulse;
        const double arc_mm = radius_mm * turn_rad;
        return {std::sqrt(arc_mm * arc_mm + way_mm * way_mm), way_pulses / speed_pps};
    }
};

HeadPace pace_of(const Profile& profile, Axis axis) {
    const AxisMotion motion = axis_motion(profile, axis);
    const double offset_mm = axis == Axis::r1 ? profile.r1.tip_mm() : profile.r2.tip_mm();
    return {1.0 / motion.pulses_per_unit, offset_mm, motion.speed_pps};
}

}  // namespace

double LeastTime::total() const noexcept {
    return std::accumulate(axis_seconds.begin(), axis_seconds.end(), feed_seconds);
}

LeastTime least_time_of(const JobView& job, const Profile& profile) {
    const HeadPace left = pace_of(profile, Axis::r1);
    const HeadPace right = pace_of(profile, Axis::r2);
    const double psi_speed_pps = axis_motion(profile, Axis::psi).speed_pps;
    const double rad_per_pulse = rad_from_pulses(1, profile.psi.pulses_per_rev);
    const double feed_mm_s = job.header().feed_mm_s;
    const HeadsOutside outside = heads_outside(job, outside_rule(profile));
    LeastTime sum;
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        const auto r_left = job.r_left_pulses(layer);
        const auto r_right = job.r_right_pulses(layer);
        std::int64_t before = job.psi_pulses(layer, 0);
        std::int64_t height = job.y_pulses(layer, 0);
        double in_layer = 0.0;
        std::array<double, 2> path_mm{};
        for (std::uint32_t point = 1; point < job.point_count(); ++point) {
            const std::int64_t psi = job.psi_pulses(layer, point);
            const auto turn_pulses = static_cast<double>(std::abs(psi - before));
            before = psi;
            const double turn_rad = turn_pulses * rad_per_pulse;
            const HeadPace::Way r1 = left.way(r_left[point - 1], r_left[point], turn_rad);
            const HeadPace::Way r2 = right.way(r_right[point - 1], r_right[point], turn_rad);
            // A spiral rises meanwhile, which takes no time of its own.
            const std::int64_t y = job.y_pulses(layer, point);
            const double rise_mm = mm_from_pulses(y - height, profile.y.pulses_per_mm);
            height = y;
            path_mm[0] += std::hypot(r1.path_mm, rise_mm);
            path_mm[1] += std::hypot(r2.path_mm, rise_mm);
            const bool is_r1_fed = !outside.holds(0, r_left[point - 1], r_left[point]);
            const bool is_r2_fed = !outside.holds(1, r_right[point - 1], r_right[point]);
            const double feed =
                std::max(is_r1_fed ? r1.path_mm : 0.0, is_r2_fed ? r2.path_mm : 0.0) / feed_mm_s;
            const double psi_alone = turn_pulses / psi_speed_pps;
            const double longest = std::max({feed, r1.seconds, r2.seconds, psi_alone});
            double& waits_for = longest == feed         ? sum.feed_seconds
                                : longest == r1.seconds ? sum.axis_seconds[index_of(Axis::r1)]
                                : longest == r2.seconds ? sum.axis_seconds[index_of(Axis::r2)]
                                                        : sum.axis_seconds[index_of(Axis::psi)];
            waits_for += longest;
            in_layer += longest;
        }
        sum.layer_seconds.push_back(in_layer);
        sum.layer_path_mm.push_back(path_mm);
        for (std::size_t h = 0; h < path_mm.size(); ++h) sum.path_mm[h] += path_mm[h];
    }
    return sum;
}

double least_carving_seconds(const JobView& job, const Profile& profile) {
    return least_time_of(job, profile).total();
}

}  // namespace psicarve::cam
