// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/path_target.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

TEST(PathTarget, IsTheFirstProfileAtFirst) {
    const PathTarget sut;
    EXPECT_EQ(sut.of(9.0, 25.0), 9.0);
    EXPECT_FALSE(sut.is_rest());
}

TEST(PathTarget, IsTheFirstProfileScaledDownBelowThePlannedFeed) {
    PathTarget sut;
    EXPECT_TRUE(sut.aim(0.5));
    EXPECT_EQ(sut.of(16.0, 64.0), 4.0);
    EXPECT_TRUE(sut.aim(0.0));
    EXPECT_EQ(sut.of(16.0, 64.0), 0.0);
    EXPECT_TRUE(sut.is_rest());
}

// Where the second profile is twice as fast as the first, any feed between them is what it says.
TEST(PathTarget, MixesBothProfilesAboveThePlannedFeed) {
    for (const double feed : {1.0, 1.2, 1.5, 1.9, 2.0}) {
        PathTarget sut;
        sut.aim(feed);
        EXPECT_NEAR(sut.of(1.0, 4.0), feed * feed, 1e-12) << feed;
        EXPECT_LE(sut.of(1.0, 3.0), 3.0) << "never beyond the second profile";
        EXPECT_GE(sut.of(1.0, 3.0), 1.0);
    }
}

TEST(PathTarget, SaysWhenNothingChanges) {
    PathTarget sut;
    EXPECT_FALSE(sut.aim(1.0));
    EXPECT_TRUE(sut.aim(1.5));
    EXPECT_FALSE(sut.aim(1.5));
    EXPECT_TRUE(sut.aim(1.0));
}

}  // namespace
}  // namespace psicarve::cycle
