// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/least_time.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/shared/job_fixture.hpp"
#include "tests/shared/passes_fixture.hpp"

namespace psicarve::cam {
namespace {

/// Two layers of half a turn; radii go from `from_mm` to `to_mm` and back, point by point.
LeastTime time_of(double from_mm, double to_mm, double feed_mm_s) {
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
    const LeastTime time = least_time_of(JobView::check(blob).value(), profile);
    EXPECT_EQ(time.total(), least_carving_seconds(JobView::check(blob).value(), profile));
    return time;
}

double seconds_of(double from_mm, double to_mm, double feed_mm_s) {
    return time_of(from_mm, to_mm, feed_mm_s).total();
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

/// A roughing layer of half a turn, another one and two finishing ones at 8 mm, with a blank of 12 mm.
LeastTime time_of_roughing(double left_mm, double right_mm) {
    const Profile profile;
    JobTable table = with_roughing(small_job(profile, 2, 101, 8.0), 1, 0);
    for (JobPass& pass : table.passes) pass.clear_mm = 12.0;
    for (std::size_t point = 0; point < 101; ++point) {
        table.r_left_pulses[point] = static_cast<std::int32_t>(400.0 * left_mm);
        table.r_right_pulses[point] = static_cast<std::int32_t>(400.0 * right_mm);
    }
    table.feed_mm_s = 8.0;
    const auto blob = job_blob_from_table(table);
    return least_time_of(JobView::check(blob).value(), profile);
}

TEST(LeastTime, AHeadThatIsOutsideOfTheBlankHasNoFeed) {
    const Profile profile;
    EXPECT_NEAR(time_of_roughing(15.0, 10.0).layer_seconds[0], 10.0 * std::numbers::pi / 8.0, 1e-9);
    EXPECT_NEAR(time_of_roughing(10.0, 15.0).layer_seconds[0], 10.0 * std::numbers::pi / 8.0, 1e-9);
    const LeastTime both = time_of_roughing(15.0, 15.0);
    EXPECT_NEAR(both.layer_seconds[0], 180.0 / profile.psi.speed_deg_s, 1e-9);
    EXPECT_NEAR(both.axis_seconds[index_of(Axis::psi)], 180.0 / profile.psi.speed_deg_s, 1e-9);
    EXPECT_NEAR(both.layer_seconds[2], 8.0 * std::numbers::pi / 8.0, 1e-9);
    EXPECT_NEAR(both.layer_path_mm[0][0], 15.0 * std::numbers::pi, 1e-9);
    // Within the clearance of the blank.
    EXPECT_NEAR(time_of_roughing(14.0, 10.0).layer_seconds[0], 14.0 * std::numbers::pi / 8.0, 1e-9);
}

TEST(LeastTime, SaysWhatEachWayWaitsFor) {
    const LeastTime slow = time_of(10.0, 10.0, 20.0);
    EXPECT_EQ(slow.feed_seconds, slow.total());
    ASSERT_EQ(slow.layer_seconds.size(), 2U);
    EXPECT_NEAR(slow.layer_seconds[0], 0.5 * slow.total(), 1e-9);
    EXPECT_NEAR(slow.layer_seconds[1], 0.5 * slow.total(), 1e-9);
    EXPECT_NEAR(slow.path_mm[0], 2.0 * 10.0 * std::numbers::pi, 1e-9);
    EXPECT_NEAR(slow.path_mm[1], 2.0 * 10.0 * std::numbers::pi, 1e-9);
    const LeastTime fast = time_of(10.0, 10.0, 1000.0);
    EXPECT_EQ(fast.axis_seconds[index_of(Axis::psi)], fast.total());
    const LeastTime deep = time_of(10.0, 20.0, 1000.0);
    EXPECT_EQ(deep.axis_seconds[index_of(Axis::r1)], deep.total());
    EXPECT_GT(deep.path_mm[0], 200 * 10.0);
    EXPECT_LT(deep.path_mm[1], 100.0);
}

}  // namespace
}  // namespace psicarve::cam
