// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/publisher.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace psicarve::cycle {
namespace {

constexpr std::uint64_t kSampleTicks = 20;

struct PublisherRig {
    std::unique_ptr<CycleIo> io = std::make_unique<CycleIo>();
    Publisher sut{*io, kSampleTicks};
};

TEST(Publisher, IsDueAtOnceAndThenEverySampleTicks) {
    PublisherRig rig;
    EXPECT_TRUE(rig.sut.is_due(0));
    rig.sut.publish_positions({}, 3);
    EXPECT_FALSE(rig.sut.is_due(3));
    EXPECT_FALSE(rig.sut.is_due(3 + kSampleTicks - 1));
    EXPECT_TRUE(rig.sut.is_due(3 + kSampleTicks));
    EXPECT_TRUE(rig.sut.is_due(300)) << "ticks may be missed";
}

TEST(Publisher, IsDueInTheTickThatAsks) {
    PublisherRig rig;
    rig.sut.publish_positions({}, 3);
    rig.sut.ask(5);
    EXPECT_FALSE(rig.sut.is_due(4));
    EXPECT_TRUE(rig.sut.is_due(5));
}

TEST(Publisher, QueuesPositionsThatChanged) {
    PublisherRig rig;
    rig.sut.publish_positions({}, 1);
    rig.sut.publish_positions({1, -2, 3, 4}, 20);
    rig.sut.publish_positions({1, -2, 3, 4}, 40);
    rig.sut.publish_positions({1, -2, 3, 5}, 60);
    IncrementEntry entry;
    ASSERT_TRUE(rig.io->increments.pop_into(entry));
    EXPECT_EQ(entry.tick, 20U);
    EXPECT_EQ(entry.r1_pulses, 1);
    EXPECT_EQ(entry.r2_pulses, -2);
    EXPECT_EQ(entry.psi_pulses, 3);
    EXPECT_EQ(entry.y_pulses, 4);
    ASSERT_TRUE(rig.io->increments.pop_into(entry));
    EXPECT_EQ(entry.tick, 60U);
    EXPECT_EQ(entry.y_pulses, 5);
    EXPECT_FALSE(rig.io->increments.pop_into(entry));
}

TEST(Publisher, CountsPositionsThatFindTheQueueFull) {
    PublisherRig rig;
    for (std::size_t i = 1; i <= IncrementQueue::capacity(); ++i)
        rig.sut.publish_positions({static_cast<std::int64_t>(i), 0, 0, 0}, i);
    EXPECT_EQ(rig.sut.increments_lost(), 0U);
    rig.sut.publish_positions({0, 0, 0, 1}, 99'999);
    EXPECT_EQ(rig.sut.increments_lost(), 1U);
}

}  // namespace
}  // namespace psicarve::cycle
