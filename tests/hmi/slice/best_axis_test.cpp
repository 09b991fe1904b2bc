// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/best_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shared/base/result.hpp"
#include "tests/hmi/model/shapes.hpp"

namespace psicarve::slice {
namespace {

constexpr double kAnyRadius = 1e9;

/// A tall post at (20, 3) on a low plate whose middle is elsewhere.
model::Mesh post_on_plate() {
    return shapes::Builder()
        .add(shapes::box({-30, -10, 0}, {30, 10, 2}))
        .add(shapes::cylinder(4.0, 2.0, 40.0, 32, 20.0, 3.0))
        .mesh();
}

TEST(AxisSearch, FindsThePostThatTheCentreMisses) {
    const auto sut = search_axis(post_on_plate(), Up::z, {0.0, 0.0}, kAnyRadius, {});
    ASSERT_TRUE(sut.has_value());
    EXPECT_LT(std::hypot(sut->best[0] - 20.0, sut->best[1] - 3.0), 4.0);
    EXPECT_GT(sut->centre_loss.outside_share, 0.8);
    EXPECT_EQ(sut->best_loss.outside_share, 0.0);
    EXPECT_LT(sut->best_loss.undercut_share, 0.01);
}

TEST(AxisSearch, StaysAtTheCentreOfABodyThatLosesNothingThere) {
    const auto sut = search_axis(shapes::cylinder(10.0, 0.0, 5.0, 24), Up::z, {0.0, 0.0}, kAnyRadius, {});
    ASSERT_TRUE(sut.has_value());
    EXPECT_NEAR(sut->best[0], 0.0, 1e-6);
    EXPECT_NEAR(sut->best[1], 0.0, 1e-6);
    EXPECT_EQ(sut->best_loss.total(), 0.0);
}

TEST(AxisSearch, PrefersWhatTheMachineCanReach) {
    // From the post the plate's far end is over 50 away; a machine that reaches 40 cannot carve it.
    const auto sut = search_axis(post_on_plate(), Up::z, {0.0, 0.0}, 40.0, {});
    ASSERT_TRUE(sut.has_value());
    EXPECT_LE(sut->best_loss.radius_max, 40.0);
}

TEST(AxisSearch, NeverDoesWorseThanThePositionInUse) {
    const auto sut = search_axis(shapes::figurine(60.0, 40, 64), Up::z, {5.0, -2.0}, kAnyRadius, {});
    ASSERT_TRUE(sut.has_value());
    EXPECT_LE(sut->best_loss.total(), sut->used_loss.total());
    EXPECT_LE(sut->best_loss.total(), sut->centre_loss.total());
}

TEST(AxisSearch, FindsTheSameTwice) {
    const model::Mesh mesh = shapes::figurine(60.0, 40, 64);
    const auto a = search_axis(mesh, Up::z, {0.0, 0.0}, kAnyRadius, {});
    const auto b = search_axis(mesh, Up::z, {0.0, 0.0}, kAnyRadius, {});
    ASSERT_TRUE(a.has_value() && b.has_value());
    EXPECT_EQ(a->best, b->best);
}

TEST(AxisSearch, EndsWhenProgressSaysSo) {
    const auto sut =
        search_axis(post_on_plate(), Up::z, {0.0, 0.0}, kAnyRadius, [](double) { return false; });
    ASSERT_FALSE(sut.has_value());
    EXPECT_EQ(sut.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace psicarve::slice
