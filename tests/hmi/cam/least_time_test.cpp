// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/least_time.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace psicarve::cam {
namespace {

/// Two layers of half a turn; radii go from `from_mm` to `to_mm` and back, point by point.
double seconds_of(double from_mm, double to_mm, double feed_mm_s) {
    const Profile profile;
    JobTable table;
    table.layer_count = 2;
    table.point_count = 101;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.feed_mm_s = feed_mm_s;
    table.layer_height_pulses = {400, 800};
    for (std::uint32_t i = 0; i < table.layer_count * table.point_count; ++i) {
        const double radius_mm = i % 2 == 0 ? from_mm : to_mm;
        table.r_left_pulses.push_back(static_cast<std::int32_t>(radius_mm * profile.r1.pulses_per_mm));
        table.r_right_pulses.push_back(static_cast<std::int32_t>(from_mm * profile.r2.pulses_per_mm));
    }
    table.profile_toml = profile_to_toml(profile);
    const auto blob = job_blob_from_table(table);
    return least_carving_seconds(JobView::check(blob).value(), profile);
}

TEST(LeastTime, OfACylinderIsItsSurfaceByTheFeed) {
    EXPECT_NEAR(seconds_of(10.0, 10.0, 20.0), 2.0 * 10.0 * std::numbers::pi / 20.0, 1e-9);
}

TEST(LeastTime, IsTheTablesWhereTheFeedIsMoreThanItCanTurn) {
    const Profile profile;
    EXPECT_NEAR(seconds_of(10.0, 10.0, 1000.0), 360.0 / profile.psi.speed_deg_s, 1e-9);
}

TEST(LeastTime, IsTheHeadsWhereTheyHaveALongWay) {
    const Profile profile;
    EXPECT_NEAR(seconds_of(10.0, 20.0, 1000.0), 200 * 10.0 / profile.r1.speed_mm_s, 1e-6);
}

}  // namespace
}  // namespace psicarve::cam
