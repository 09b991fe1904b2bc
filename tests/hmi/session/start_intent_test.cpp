// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/start_intent.hpp"

#include <gtest/gtest.h>

namespace psicarve::session {
namespace {

using S = MachineState;

CoreStatus status(S state, std::uint64_t heartbeat) {
    CoreStatus made{};
    made.state = state;
    made.heartbeat = heartbeat;
    return made;
}

TEST(StartIntent, CarvesOnceTheHeadsWaitAtTheFirstPoint) {
    StartIntent sut;
    sut.arm(10);
    EXPECT_FALSE(sut.take(status(S::ready, 11)));  // sampled before the start
    EXPECT_FALSE(sut.take(status(S::positioning, 12)));
    EXPECT_FALSE(sut.take(status(S::positioning, 500)));
    EXPECT_TRUE(sut.take(status(S::waiting, 501)));
    EXPECT_FALSE(sut.take(status(S::waiting, 502)));
}

TEST(StartIntent, IsDroppedByAnyOtherTurn) {
    for (const S state : {S::alarm, S::stopping, S::ready, S::off, S::moving, S::carving}) {
        StartIntent sut;
        sut.arm(10);
        EXPECT_FALSE(sut.take(status(S::positioning, 12)));
        EXPECT_FALSE(sut.take(status(state, 20)));
        EXPECT_FALSE(sut.take(status(S::waiting, 21))) << name_of(state);
    }
}

TEST(StartIntent, DoesNotOutliveItsCore) {
    StartIntent sut;
    sut.arm(1000);
    EXPECT_FALSE(sut.take(status(S::off, 3)));
    EXPECT_FALSE(sut.take(status(S::waiting, 4)));
}

TEST(StartIntent, NeverCarvesUnasked) {
    StartIntent sut;
    EXPECT_FALSE(sut.take(status(S::waiting, 5)));
    sut.arm(5);
    sut.drop();
    EXPECT_FALSE(sut.take(status(S::waiting, 9)));
}

TEST(NextLayer, IsTheOneAfterTheLastThatIsWhole) {
    EXPECT_EQ(next_layer(0, 60, 6), 0U);
    EXPECT_EQ(next_layer(9, 60, 6), 0U);
    EXPECT_EQ(next_layer(10, 60, 6), 1U);
    EXPECT_EQ(next_layer(35, 60, 6), 3U);
    EXPECT_EQ(next_layer(60, 60, 6), 0U) << "done: the next run begins below";
    EXPECT_EQ(next_layer(0, 0, 6), 0U);
    EXPECT_EQ(next_layer(5, 60, 0), 0U);
}

TEST(StartIntent, GoesOnBehindTheCheckpointOnlyWhereThisCoreHasCarvedNothing) {
    CoreStatus status{};
    EXPECT_EQ(layer_to_go_on_with(status, std::nullopt, 6), 0U);
    EXPECT_EQ(layer_to_go_on_with(status, 4, 6), 4U) << "of a core that is no more";
    status.job_start_tick = 100;
    status.points_done = 25;
    status.points_total = 60;
    EXPECT_EQ(layer_to_go_on_with(status, 4, 6), 2U);
    status.points_done = 60;
    EXPECT_EQ(layer_to_go_on_with(status, 4, 6), 0U) << "done: the next run begins below";
}

TEST(StartIntent, GoesOnWhereThePieceIsAndNotWhereADryRunCame) {
    CoreStatus status{};
    status.job_start_tick = 100;
    status.points_done = 25;
    status.points_total = 60;
    status.is_dry = 1;
    EXPECT_EQ(layer_to_go_on_with(status, std::nullopt, 6), 0U);
    EXPECT_EQ(layer_to_go_on_with(status, 4, 6), 4U);
}

}  // namespace
}  // namespace psicarve::session
