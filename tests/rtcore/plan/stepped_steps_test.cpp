// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a program by point-by-point comparison, among others.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "tests/rtcore/plan/program_blocks.hpp"

namespace psicarve::plan {
namespace {

using cycle::BlockKind;
using cycle::MotionBlock;
using cycle::OrderShape;
using cycle::PointByPoint;

constexpr std::size_t kSteppedYAt = 3;
constexpr std::uint8_t kFirstHeadAndY = 0b1001;

ProgramStep stepped_line(std::uint64_t line, const Pulses4& target) {
    ProgramStep step;
    step.kind = MotionKind::way;
    step.shape = OrderShape::stepped;
    step.stepped_axes = kFirstHeadAndY;
    step.line = line;
    step.ends_block = true;
    step.target_pulses = target;
    return step;
}

ProgramStep stepped_arc(std::uint64_t line, const Pulses4& target, std::array<std::int64_t, 2> centre) {
    ProgramStep step = stepped_line(line, target);
    step.kind = MotionKind::arc;
    step.shape = OrderShape::arc;
    step.centre_pulses = centre;
    return step;
}

ProgramStep plain_step(std::uint64_t line, MotionKind kind, const Pulses4& target) {
    ProgramStep step;
    step.kind = kind;
    step.line = line;
    step.ends_block = true;
    step.target_pulses = target;
    return step;
}

std::vector<MotionBlock> lines_of_program(const std::vector<MotionBlock>& blocks, std::uint64_t line) {
    std::vector<MotionBlock> found;
    for (const MotionBlock& block : blocks)
        if (block.kind == BlockKind::line && program_line(block) == line) found.push_back(block);
    return found;
}

/// Each block's steps, one by one, are those of the comparison.
void expect_steps(const std::vector<MotionBlock>& blocks, PointByPoint way) {
    for (const MotionBlock& block : blocks) {
        const std::size_t k = block.delta_pulses[0] != 0 ? 0 : kSteppedYAt;
        const int sign = block.delta_pulses[k] > 0 ? 1 : -1;
        for (std::int64_t n = std::abs(block.delta_pulses[k]); n > 0; --n) {
            ASSERT_FALSE(way.is_finished());
            const PointByPoint::Step wanted =
                k == 0 ? PointByPoint::Step{sign, 0} : PointByPoint::Step{0, sign};
            ASSERT_EQ(way.next(), wanted);
        }
    }
    EXPECT_TRUE(way.is_finished());
}

/// A rounded way, a line, an arc, a whole turn, a way again.
struct MixedSteps {
    Pulses4 first{6040, 6200, 130, 3000};
    Pulses4 second{6100, 6200, 130, 2900};
    Pulses4 third{6000, 6200, 130, 3000};
    Pulses4 last{6020, 6250, 150, 3050};
    std::vector<ProgramStep> steps{
        plain_step(1, MotionKind::way, first), stepped_line(2, second),
        stepped_arc(3, third, {6000, 2900}),   stepped_arc(4, third, {6000, 2950}),
        plain_step(5, MotionKind::way, last),  plain_step(6, MotionKind::end, last)};
    MixedSteps() { steps[0].tolerance_mm = steps[4].tolerance_mm = 0.02; }
};

TEST(SteppedSteps, AreThoseOfTheComparisonFromRestToRestWithTheirLines) {
    const MixedSteps mixed;
    const auto blocks = test::program_blocks(mixed.steps);
    expect_steps(lines_of_program(blocks, 2), PointByPoint::line({60, -100}));
    expect_steps(lines_of_program(blocks, 3), PointByPoint::arc({100, 0}, {0, 100}, true));
    expect_steps(lines_of_program(blocks, 4), PointByPoint::arc({0, 50}, {0, 50}, true));
    std::uint32_t left = 0;
    std::uint64_t line = 0;
    Pulses4 at = test::kStartPulses;
    for (const MotionBlock& block : blocks) {
        EXPECT_GE(program_line(block), line) << "in their order";
        line = program_line(block);
        for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += block.delta_pulses[k];
        if (block.kind != BlockKind::line && block.kind != BlockKind::path) continue;
        EXPECT_EQ(left == 0, block.group_blocks != 0);
        if (left == 0) left = block.group_blocks;
        --left;
    }
    EXPECT_EQ(at, mixed.last);
    EXPECT_EQ(blocks.back().kind, BlockKind::program_end);
}

TEST(SteppedSteps, HaltBehindEachBlockWhereThatIsAskedFor) {
    const MixedSteps mixed;
    std::vector<std::uint64_t> halts;
    std::uint64_t moved = 0;
    for (const MotionBlock& block : test::program_blocks(mixed.steps, true)) {
        if (block.kind == BlockKind::line || block.kind == BlockKind::path) moved = program_line(block);
        if (block.kind != BlockKind::halt) continue;
        EXPECT_EQ(block.halt, ProgramHold::single);
        EXPECT_EQ(program_line(block), moved) << "behind its motion";
        halts.push_back(program_line(block));
    }
    EXPECT_EQ(halts, (std::vector<std::uint64_t>{1, 2, 3, 4, 5}));
}

TEST(SteppedSteps, AreNoFasterThanTheirFeedAlongTheWay) {
    MixedSteps mixed;
    for (ProgramStep& step : mixed.steps) step.seconds = step.shape == OrderShape::straight ? 0.0 : 10.0;
    const auto blocks = test::program_blocks(mixed.steps);
    // A line of one direction: its steps in ten seconds. An arc: where one axis steps alone, its length.
    EXPECT_NEAR(lines_of_program(blocks, 2).front().max_speed_per_s, 16.0, 1e-9);
    EXPECT_NEAR(lines_of_program(blocks, 3).front().max_speed_per_s, 50.0 * M_PI / 10.0, 1e-9);
    EXPECT_NEAR(lines_of_program(blocks, 4).front().max_speed_per_s, 100.0 * M_PI / 10.0, 1e-9);
}

TEST(SteppedSteps, BeginAnewWhereAScrewWithBacklashTurnsRound) {
    Profile profile;
    profile.r1.backlash_mm = 0.05;
    profile.y.backlash_mm = 0.05;
    const MixedSteps mixed;
    const auto blocks = test::program_blocks(mixed.steps, false, profile);
    std::array<int, 2> last{};
    for (const MotionBlock& block : lines_of_program(blocks, 4)) {
        const std::size_t k = block.delta_pulses[0] != 0 ? 0 : kSteppedYAt;
        const int direction = block.delta_pulses[k] > 0 ? 1 : -1;
        int& before = last[k == 0 ? 0 : 1];
        EXPECT_TRUE(before == direction || block.group_blocks > 0);
        before = direction;
    }
}

}  // namespace
}  // namespace psicarve::plan
