// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/job/point_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace psicarve {
namespace {

const PointPlan kPlan{{0.0F, 0.25F, 1e-6F}, {WayBound::unknown, WayBound::y, WayBound::feed}};
constexpr std::size_t kFirstSecond = 16;
constexpr std::size_t kFirstBound = kFirstSecond + 3 * sizeof(float);

TEST(PointPlan, ComesBackAsItWasGiven) {
    const auto bytes = point_plan_bytes(kPlan);
    EXPECT_EQ(bytes.size(), 16U + 3U * 5U);
    const auto read = point_plan_from(bytes, 3);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, kPlan);
    EXPECT_TRUE(point_plan_from(point_plan_bytes({}), 0));
}

TEST(PointPlan, OfOtherPointsIsRefused) {
    const auto bytes = point_plan_bytes(kPlan);
    for (const std::size_t points : {0U, 2U, 4U}) EXPECT_FALSE(point_plan_from(bytes, points)) << points;
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(point_plan_from(std::span{bytes}.first(size), 3)) << size;
    auto miscounted = bytes;
    miscounted[8] = std::byte{2};
    EXPECT_FALSE(point_plan_from(miscounted, 3));
    auto foreign = bytes;
    foreign[0] = std::byte{'X'};
    EXPECT_FALSE(point_plan_from(foreign, 3));
}

TEST(PointPlan, RefusesBoundsAndTimesThatAreNone) {
    const auto bytes = point_plan_bytes(kPlan);
    for (std::size_t bound = 0; bound < 256; ++bound) {
        auto changed = bytes;
        changed[kFirstBound + 1] = static_cast<std::byte>(bound);
        EXPECT_EQ(static_cast<bool>(point_plan_from(changed, 3)), bound < kWayBoundCount) << bound;
    }
    for (const float seconds : {-1.0F, std::numeric_limits<float>::infinity(), std::nanf("")}) {
        auto changed = bytes;
        std::memcpy(changed.data() + kFirstSecond, &seconds, sizeof seconds);
        EXPECT_FALSE(point_plan_from(changed, 3)) << seconds;
    }
}

}  // namespace
}  // namespace psicarve
