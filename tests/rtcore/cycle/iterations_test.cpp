// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/iterations.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace psicarve::cycle {
namespace {

using IterationWay = std::array<std::int64_t, kAxisCount>;

MotionBlock iterations_block(const IterationWay& delta_pulses) {
    MotionBlock block{};
    block.delta_pulses = delta_pulses;
    return block;
}

CycleConfig slow_pins() {
    CycleConfig config;
    config.step_high_ticks = 2;
    config.step_low_ticks = 3;
    return config;
}

/// Emits all that is left; which axes stepped, iteration by iteration.
std::vector<std::uint32_t> emitted(Iterations& sut) {
    const CycleConfig config;
    PulseStage pulses(config);
    std::vector<std::uint32_t> order;
    for (std::uint64_t tick = 0; !sut.are_done(); tick += 10) {
        pulses.begin_tick(tick);
        sut.make();
        EXPECT_TRUE(sut.emit(pulses, tick, 0));
        order.push_back(static_cast<std::uint32_t>(pulses.levels() & kStepMask));
    }
    return order;
}

TEST(Iterations, AreAsManyAsTheLongAxisHasPulses) {
    Iterations sut;
    EXPECT_TRUE(sut.are_done());
    sut.start(iterations_block({3, -7, 0, 5}));
    EXPECT_EQ(sut.left(), 7);
    EXPECT_FALSE(sut.are_done());
    EXPECT_EQ(emitted(sut).size(), 7U);
}

TEST(Iterations, HoldOneUntilAllItsAxesMayStep) {
    const CycleConfig config = slow_pins();
    PulseStage pulses(config);
    pulses.begin_tick(10);
    pulses.step(0b0001, 10);
    Iterations sut;
    sut.start(iterations_block({1, 1, 0, 0}));
    sut.make();
    for (std::uint64_t tick = 11; tick < 15; ++tick) {
        pulses.begin_tick(tick);
        EXPECT_FALSE(sut.emit(pulses, tick, 0)) << tick;
        EXPECT_TRUE(sut.is_held());
        EXPECT_EQ(sut.left(), 0);
        EXPECT_FALSE(sut.are_done()) << "the last one is not out";
        EXPECT_EQ(pulses.emitted()[1], 0U);
    }
    pulses.begin_tick(15);
    EXPECT_TRUE(sut.emit(pulses, 15, 0));
    EXPECT_EQ(pulses.emitted()[0], 2U);
    EXPECT_EQ(pulses.emitted()[1], 1U);
    EXPECT_TRUE(sut.are_done());
}

TEST(Iterations, SendNoPulseOfAnAxisThatStandsStill) {
    const CycleConfig config;
    PulseStage pulses(config);
    Iterations sut;
    sut.start(iterations_block({1, 1, 1, 0}));
    sut.make();
    EXPECT_TRUE(sut.emit(pulses, 0, 0b0011));
    EXPECT_EQ(pulses.levels() & kStepMask, 0b0100U);
    EXPECT_TRUE(sut.are_done());
}

TEST(Iterations, OfSegmentsComeInTheOrderOfTheWholeLine) {
    constexpr IterationWay kLine{13, -5, 8, 3};
    Iterations whole;
    whole.start(iterations_block(kLine));
    const std::vector<std::uint32_t> expected = emitted(whole);
    for (std::size_t cut = 1; cut < expected.size(); ++cut) {
        IterationWay first{};
        for (std::size_t i = 0; i < cut; ++i) {
            for (std::size_t k = 0; k < kAxisCount; ++k) first[k] += expected[i] >> k & 1U;
        }
        std::vector<std::uint32_t> order;
        for (const bool is_second : {false, true}) {
            MotionBlock block{};
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                const std::int64_t sign = kLine[k] < 0 ? -1 : 1;
                block.line_pulses[k] = static_cast<std::int32_t>(kLine[k]);
                block.delta_pulses[k] = is_second ? kLine[k] - sign * first[k] : sign * first[k];
            }
            block.line_done = is_second ? static_cast<std::int64_t>(cut) : 0;
            Iterations sut;
            sut.start_segment(block);
            for (const std::uint32_t axes : emitted(sut)) order.push_back(axes);
        }
        EXPECT_EQ(order, expected) << cut;
    }
}

// Such blocks come of no plan of ours; what they say of a line is not believed.
TEST(Iterations, OfASegmentThatFitsInNoLineAreThoseOfALineOfItsOwn) {
    MotionBlock block = iterations_block({4, 1, 0, 0});
    Iterations own;
    own.start(block);
    const std::vector<std::uint32_t> expected = emitted(own);
    struct Claim {
        std::int32_t line_pulses;
        std::int64_t line_done;
    };
    for (const Claim claim : {Claim{0, 0}, Claim{7, 4}, Claim{7, -1}}) {
        block.line_pulses = {claim.line_pulses, 0, 0, 0};
        block.line_done = claim.line_done;
        Iterations sut;
        sut.start_segment(block);
        EXPECT_EQ(emitted(sut), expected) << claim.line_pulses << ' ' << claim.line_done;
    }
}

TEST(Iterations, ForgetOneThatIsHeldWhenAnotherBlockStarts) {
    Iterations sut;
    sut.start(iterations_block({1, 0, 0, 0}));
    sut.make();
    sut.start(iterations_block({0, 1, 0, 0}));
    EXPECT_FALSE(sut.is_held());
    sut.make();
    sut.start_segment(iterations_block({0, 1, 0, 0}));
    EXPECT_FALSE(sut.is_held());
    EXPECT_EQ(emitted(sut), std::vector<std::uint32_t>{0b0010});
}

}  // namespace
}  // namespace psicarve::cycle
