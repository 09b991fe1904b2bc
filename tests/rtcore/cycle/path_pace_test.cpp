// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/path_pace.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace psicarve::cycle {
namespace {

/// One u a second, as fast at the end as at the begin; a tick is a tenth of a second.
constexpr double kPaceTick_s = 0.1;

PathTiming even_timing(double length) {
    PathTiming timing{};
    timing.length = length;
    timing.start_speed2 = {1.0, 4.0};
    timing.end_speed2 = {1.0, 4.0};
    timing.accel_free.fill(10.0F);
    timing.start_stop_speed = 0.5F;
    return timing;
}

/// At which tick each iteration of the segment is due, when each is taken at once.
std::vector<int> due_ticks_of(PathPace& sut, std::int64_t iterations) {
    std::vector<int> due;
    for (int tick = 1; tick < 1000 && iterations > 0; ++tick) {
        sut.tick();
        if (!sut.is_due(iterations)) continue;
        due.push_back(tick);
        --iterations;
        sut.take();
    }
    return due;
}

TEST(PathPace, SpreadsTheIterationsEvenlyOverTheSegment) {
    PathPace sut(kPaceTick_s);
    sut.start(even_timing(2.0), 4);
    const std::vector<int> expected{5, 10, 15, 20};
    EXPECT_EQ(due_ticks_of(sut, 4), expected);
    EXPECT_TRUE(sut.is_at_end());
}

TEST(PathPace, HasNoIterationDueWhenNoneIsLeft) {
    PathPace sut(kPaceTick_s);
    sut.start(even_timing(2.0), 0);
    EXPECT_TRUE(due_ticks_of(sut, 0).empty());
    for (int tick = 0; tick < 20; ++tick) {
        EXPECT_FALSE(sut.is_at_end()) << tick;
        EXPECT_FALSE(sut.is_due(0)) << tick;
        sut.tick();
    }
    EXPECT_TRUE(sut.is_at_end());
    EXPECT_FALSE(sut.is_due(0));
}

// Way and pulses end together: however the way of an iteration is rounded, the last waits for the end.
TEST(PathPace, LetsTheLastIterationBeDueWithTheSegmentsEndAlone) {
    PathPace sut(kPaceTick_s);
    sut.start(even_timing(1.0), 3);
    for (int tick = 0; tick < 9; ++tick) sut.tick();
    EXPECT_TRUE(sut.is_due(2));
    EXPECT_FALSE(sut.is_due(1));
}

TEST(PathPace, GoesOnWithTheNextSegmentInTheSpeedAtHand) {
    PathPace sut(kPaceTick_s);
    sut.start(even_timing(1.0), 2);
    EXPECT_EQ(due_ticks_of(sut, 2).back(), 10);
    sut.next(even_timing(3.0), 3);
    EXPECT_FALSE(sut.is_at_end());
    const std::vector<int> expected{10, 20, 30};
    EXPECT_EQ(due_ticks_of(sut, 3), expected);
}

// A segment that ends between two ticks leaves the rest of the tick to the next one: nothing adds up.
TEST(PathPace, GivesTheNextSegmentTheTimeThatIsLeftOver) {
    PathPace sut(kPaceTick_s);
    sut.start(even_timing(0.95), 1);
    EXPECT_EQ(due_ticks_of(sut, 1), std::vector<int>{10});
    sut.next(even_timing(1.04), 1);
    EXPECT_EQ(due_ticks_of(sut, 1), std::vector<int>{10});
}

TEST(PathPace, StandsStillOnceTwoIterationsAreDueSoThatNoBurstFollows) {
    PathPace sut(kPaceTick_s);
    sut.start(even_timing(10.0), 20);
    for (int tick = 0; tick < 60; ++tick) sut.tick();
    EXPECT_TRUE(sut.is_due(20));
    sut.take();
    EXPECT_TRUE(sut.is_due(19)) << "a short wait is made up for";
    sut.take();
    EXPECT_FALSE(sut.is_due(18)) << "all that was missed beyond it is not";
}

TEST(PathPace, SlowsDownAndRestsAndGoesOnAsItIsAimed) {
    PathPace sut(kPaceTick_s);
    sut.start(even_timing(100.0), 1000);
    sut.tick();
    EXPECT_FALSE(sut.is_slowest());
    sut.aim(0.0);
    std::int64_t left = 1000;
    for (int tick = 0; tick < 50 && !sut.is_slowest(); ++tick) {
        sut.tick();
        if (sut.is_due(left)) sut.take();
    }
    ASSERT_TRUE(sut.is_slowest());
    sut.rest();
    EXPECT_TRUE(sut.is_slowest());
    sut.aim(1.0);
    for (int tick = 0; tick < 20; ++tick) {
        sut.tick();
        while (sut.is_due(left)) sut.take();
    }
    EXPECT_FALSE(sut.is_slowest());
}

TEST(PathPace, CallsASegmentEndlessInWhichNoTimePasses) {
    EXPECT_TRUE(can_end(even_timing(1.0)));
    PathTiming timing = even_timing(0.0);
    EXPECT_FALSE(can_end(timing));
    timing = even_timing(1.0);
    timing.start_speed2[0] = 0.0;
    EXPECT_TRUE(can_end(timing)) << "from rest";
    timing.end_speed2[0] = 0.0;
    EXPECT_FALSE(can_end(timing)) << "from rest to rest";
    timing = even_timing(1.0);
    timing.start_speed2[0] = -1.0;
    timing.end_speed2[0] = 4.0;
    EXPECT_FALSE(can_end(timing));
    timing = even_timing(1.0);
    timing.start_speed2[0] = 4.0;
    timing.end_speed2[0] = -1.0;
    EXPECT_FALSE(can_end(timing));
}

}  // namespace
}  // namespace psicarve::cycle
