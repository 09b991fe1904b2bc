// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/job_builder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/placement.hpp"
#include "shared/base/result.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"
#include "tests/hmi/cam/built_job.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::cam {
namespace {

using testing::HasSubstr;

TEST(JobBuilder, MakesAJobThatTheMachineAccepts) {
    const BuiltJob sut = built(shapes::figurine(50.0, 60, 70), Profile{}, small(40, 61));
    const std::vector<std::byte> blob = job_blob_from_table(sut.table);
    const auto view = JobView::check(blob);
    ASSERT_TRUE(view.has_value());
    const auto accepted = check_job(*view, Profile{});
    EXPECT_TRUE(accepted.has_value()) << (accepted ? "" : accepted.error().message);
}

TEST(JobBuilder, RoughsAsTheProfileAsks) {
    const model::Mesh mesh = shapes::box({-4, -4, 0}, {4, 4, 4});
    Profile profile;
    profile.roughing = {2.0, 0.5, 0.0};
    EXPECT_THAT(refused(mesh, profile, small(4, 31)).message,
                HasSubstr("roughing begins at the blank's surface"));
    profile.blank.radius_mm = 8.0;
    for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
        JobOptions options = small(4, 31);
        options.joining = joining;
        const BuiltJob sut = built(mesh, profile, options);
        // 6 and 4.5 mm, and the finishing pass.
        ASSERT_EQ(sut.table.passes.size(), 3U) << name_of(joining);
        EXPECT_EQ(sut.table.passes[0].depth_mm, 6.0);
        EXPECT_EQ(sut.table.passes[0].allowance_mm, 0.5);
    }
    profile.roughing.stepdown_mm = 0.0;
    EXPECT_TRUE(built(mesh, profile, small(4, 31)).table.passes.empty());
}

TEST(JobBuilder, PutsR1AtTheTablesAngleAndR2Opposite) {
    // An arm along +x only: at psi = 0 R1 meets it, R2 does not.
    const model::Mesh mesh = shapes::box({-2, -2, 0}, {9, 2, 8});
    JobOptions options = small(2, 5);
    options.axis_at = AxisAt::origin;
    const BuiltJob sut = built(mesh, Profile{}, options);
    EXPECT_EQ(left(sut.table, 0, 0), 9 * 400);
    EXPECT_EQ(right(sut.table, 0, 0), 2 * 400);
    EXPECT_EQ(left(sut.table, 0, 4), 2 * 400);  // after half a turn
    EXPECT_EQ(right(sut.table, 0, 4), 9 * 400);
}

TEST(JobBuilder, StartsOddLayersHalfATurnOnWhenContinuous) {
    const model::Mesh mesh = shapes::box({-2, -2, 0}, {9, 2, 8});
    JobOptions options = small(2, 5);
    options.axis_at = AxisAt::origin;
    const BuiltJob sut = built(mesh, Profile{}, options);
    EXPECT_EQ(sut.table.joining, Joining::continuous);
    EXPECT_EQ(left(sut.table, 1, 0), left(sut.table, 0, 4));
    EXPECT_EQ(left(sut.table, 1, 4), 9 * 400);
    EXPECT_EQ(right(sut.table, 1, 0), 9 * 400);
}

TEST(JobBuilder, StoresZigzagLayersByAngleAllTheSame) {
    const model::Mesh mesh = shapes::box({-2, -2, 0}, {9, 2, 8});
    JobOptions options = small(2, 5);
    options.axis_at = AxisAt::origin;
    options.joining = Joining::zigzag;
    const BuiltJob sut = built(mesh, Profile{}, options);
    EXPECT_EQ(sut.table.joining, Joining::zigzag);
    for (std::size_t j = 0; j < 5; ++j) EXPECT_EQ(left(sut.table, 1, j), left(sut.table, 0, j));
}

TEST(JobBuilder, SamplesAtWholePulsesWhenTheStepIsNotWhole) {
    const BuiltJob sut = built(oblong(), Profile{}, small(3, 18));  // 3200 / 17 is not whole
    for (std::size_t j = 0; j < 18; ++j) {
        const double psi = rad_from_pulses(point_angle_pulses(static_cast<std::int64_t>(j), 3200, 18), 6400);
        const double wanted_mm = std::min(3.0 / std::abs(std::cos(psi)), 5.0 / std::abs(std::sin(psi)));
        EXPECT_EQ(left(sut.table, 0, j), pulses_from_mm(wanted_mm, 400.0)) << j;
    }
}

TEST(JobBuilder, PutsLayersAtTheMiddleOfTheirShareOfTheHeight) {
    Profile profile;
    profile.job.base_height_mm = 2.5;
    const BuiltJob sut = built(oblong(), profile, small(4, 5));
    EXPECT_THAT(sut.table.layer_height_pulses, testing::ElementsAre(1400, 2200, 3000, 3800));
}

/// How a model that stands upright must lie in its file for `up` to raise it: the inverse of the rotation.
model::Mesh laid_down(const model::Mesh& upright, slice::Up up) {
    return shapes::moved(upright, [up](const shapes::Point& p) {
        if (up == slice::Up::x) return shapes::Point{p[2], p[0], p[1]};
        if (up == slice::Up::y) return shapes::Point{p[1], p[2], p[0]};
        return p;
    });
}

/// Counter-clockwise from R1's direction 0: 9 along +x at the bottom, 6 along +y in the middle, 4 along -x on
/// top.
void expect_unmirrored_letter(slice::Up up) {
    JobOptions options = small(3, 5);
    options.axis_at = AxisAt::origin;
    options.up = up;
    options.joining = Joining::zigzag;
    const BuiltJob sut = built(laid_down(shapes::letter(), up), Profile{}, options);
    EXPECT_EQ(left(sut.table, 0, 0), 9 * 400);
    EXPECT_EQ(left(sut.table, 1, 2), 6 * 400);
    EXPECT_EQ(right(sut.table, 1, 2), 600);
    EXPECT_EQ(left(sut.table, 2, 4), 4 * 400);
    EXPECT_EQ(right(sut.table, 2, 0), 4 * 400);
}

TEST(Up, ZLeavesALetterUnmirrored) {
    expect_unmirrored_letter(slice::Up::z);
}

TEST(Up, XLeavesALetterUnmirrored) {
    expect_unmirrored_letter(slice::Up::x);
}

TEST(Up, YLeavesALetterUnmirrored) {
    expect_unmirrored_letter(slice::Up::y);
}

model::Mesh rod_under_a_wider_one() {
    return shapes::Builder()
        .add(shapes::cylinder(1.0, 0.0, 5.0, 40))
        .add(shapes::cylinder(6.0, 5.0, 10.0, 40))
        .mesh();
}

TEST(JobBuilder, NeverGoesInsideTheCoreRadiusAndCountsWhereItWould) {
    const BuiltJob sut = built(rod_under_a_wider_one(), Profile{}, small(4, 9));
    EXPECT_EQ(*std::min_element(sut.table.r_left_pulses.begin(), sut.table.r_left_pulses.end()), 600);
    EXPECT_EQ(sut.report.core_points, 2U * 2U * 9U);
    EXPECT_EQ(sut.report.r_min_mm, 1.5);
}

TEST(JobBuilder, KeepsTheHeadsApartByTheirClearance) {
    Profile profile;
    profile.core_radius_mm = 0.5;
    profile.head_clearance_mm = 3.0;
    const BuiltJob sut = built(shapes::cylinder(1.0, 0.0, 10.0, 40), profile, small(4, 9));
    for (std::size_t i = 0; i < sut.table.r_left_pulses.size(); ++i) {
        EXPECT_GE(sut.table.r_left_pulses[i] + sut.table.r_right_pulses[i], 3 * 400);
    }
    EXPECT_EQ(sut.report.clearance_points, 4U * 9U);
}

TEST(JobBuilder, TakesTipOffsetsOff) {
    Profile profile;
    profile.r1.tip_offset_mm = 0.5;
    profile.r2.tip_offset_mm = -0.25;
    const BuiltJob sut = built(oblong(), profile, small(3, 5));
    EXPECT_EQ(left(sut.table, 0, 0), 3 * 400 - 200);
    EXPECT_EQ(right(sut.table, 0, 0), 3 * 400 + 100);
}

TEST(JobBuilder, SamplesR2WhereItReallyStands) {
    Profile profile;
    profile.head_r2_angle_error_deg = 90.0;  // R2 stands at 270 degrees: it meets the oblong's long side
    const BuiltJob sut = built(oblong(), profile, small(3, 5));
    EXPECT_EQ(left(sut.table, 0, 0), 3 * 400);
    EXPECT_EQ(right(sut.table, 0, 0), 5 * 400);
    EXPECT_EQ(right(sut.table, 1, 2), 3 * 400);
}

TEST(JobBuilder, SamplesR2AtItsOwnHeight) {
    // A step: 5 wide up to 4 high, then 3.
    const model::Mesh mesh = shapes::Builder()
                                 .add(shapes::box({-5, -5, 0}, {5, 5, 4}))
                                 .add(shapes::box({-3, -3, 4}, {3, 3, 8}))
                                 .mesh();
    Profile profile;
    profile.head_r2_height_error_mm = 1.0;
    const BuiltJob sut = built(mesh, profile, small(4, 5));  // layers at 1, 3, 5, 7; R2's at 2, 4, 6, 8
    EXPECT_EQ(left(sut.table, 1, 0), 5 * 400);
    EXPECT_EQ(right(sut.table, 1, 0), 3 * 400);
    EXPECT_EQ(right(sut.table, 3, 0), 600);  // above the model: the core radius
}

TEST(JobBuilder, GivesTheSameTablesInOnePassAndInTwo) {
    const model::Mesh mesh = shapes::figurine(50.0, 40, 50);
    Profile nearly;
    nearly.head_r2_angle_error_deg = 1e-9;
    const BuiltJob one = built(mesh, Profile{}, small(20, 31));
    const BuiltJob two = built(mesh, nearly, small(20, 31));
    EXPECT_EQ(one.table.r_left_pulses, two.table.r_left_pulses);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < one.table.r_right_pulses.size(); ++i) {
        differing += std::abs(one.table.r_right_pulses[i] - two.table.r_right_pulses[i]) > 1 ? 1 : 0;
    }
    EXPECT_EQ(differing, 0U);
}

TEST(JobBuilder, MakesTheSameJobTwiceToTheLastByte) {
    const model::Mesh mesh = shapes::spring(12.0, 4.0, 3.0, 50.0, 90, 20);
    JobOptions options = small(30, 31);
    const auto first = job_blob_from_table(built(mesh, Profile{}, options).table);
    options.thread_count = 2;
    const auto second = job_blob_from_table(built(mesh, Profile{}, options).table);
    EXPECT_EQ(first, second);
}

TEST(JobBuilder, RefusesAnAxisFromWhichNothingIsSeen) {
    JobOptions options = small(10, 11);
    options.axis_at = AxisAt::point;
    options.axis_x = 500.0;
    options.axis_y = 1.0;
    const auto job = build_job(shapes::box({-1, -1, 0}, {1, 1, 8}), Profile{}, options);
    ASSERT_FALSE(job);
    EXPECT_NE(
        job.error().message.find("the axis passes beside the model and no sample meets it: nothing but the "
                                 "core would be carved; --axis-at moves the axis"),
        std::string::npos)
        << job.error().message;
    // Beside it, but seen.
    options.axis_x = 8.0;
    EXPECT_TRUE(build_job(shapes::box({-1, -5, 0}, {1, 5, 8}), Profile{}, options));
    // All of it within the core, but about the axis: refused for what it is.
    const auto within = build_job(shapes::box({-0.5, -0.5, 0}, {0.5, 0.5, 8}), Profile{}, small(10, 11));
    ASSERT_FALSE(within);
    EXPECT_EQ(within.error().message.find("passes beside"), std::string::npos) << within.error().message;
}

TEST(JobBuilder, EndsWhenProgressSaysSo) {
    JobOptions options = small(40, 30);
    options.progress = [](double) { return false; };
    EXPECT_EQ(refused(oblong(), Profile{}, options).code, ErrorCode::cancelled);
}

TEST(JobBuilder, CarriesSourceAndProfile) {
    model::Mesh mesh = oblong();
    mesh.source_name = "oblong.stl";
    mesh.source_hash = 0x123456789abcdef0ULL;
    Profile profile;
    profile.job.feed_mm_s = 7.0;
    const JobTable sut = built(mesh, profile, small(2, 5)).table;
    EXPECT_EQ(sut.source_name, "oblong.stl");
    EXPECT_EQ(sut.source_hash, 0x123456789abcdef0ULL);
    EXPECT_EQ(sut.feed_mm_s, 7.0);
    EXPECT_EQ(sut.psi_sweep_pulses, 3200);
    const auto carried = parse_profile(sut.profile_toml, "job");
    ASSERT_TRUE(carried.has_value());
    EXPECT_TRUE(motion_differences(*carried, profile).empty());
}

}  // namespace
}  // namespace psicarve::cam
