// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/lookahead_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "tests/rtcore/plan/table_blocks.hpp"

namespace psicarve::plan {
namespace {

using test::blocks_of;
using test::job_of;
using test::point_of;
using test::random_table;

class Lookahead : public ::testing::TestWithParam<Joining> {};
class LinkedLookahead : public ::testing::TestWithParam<Joining> {};

TEST_P(Lookahead, VisitsEveryPointInOrderAndExactly) {
    std::mt19937_64 random{41};
    for (const std::int64_t roughness : {0, 3, 40, 400}) {
        const auto job = job_of(random_table(random, GetParam(), roughness));
        const auto blocks = blocks_of(job);
        ASSERT_EQ(blocks.back().kind, cycle::BlockKind::program_end);
        Pulses4 at = point_of(*job, 0, carved_point(job->joining(), job->point_count(), 0, 0));
        std::uint32_t layer = 0;
        std::uint32_t step = 1;
        for (std::size_t i = 0; i + 1 < blocks.size(); ++i) {
            for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += blocks[i].delta_pulses[k];
            if (blocks[i].reaches_points == 0) continue;
            if (step + 1 == job->point_count() && layer + 1 < job->layer_count() &&
                GetParam() == Joining::spiral) {
                // The row's last point is the next one's first.
                ASSERT_EQ(at, point_of(*job, layer, step));
                ASSERT_EQ(blocks[i].reaches_points, 2);
                ++layer;
                step = 0;
            } else {
                ASSERT_EQ(blocks[i].reaches_points, 1);
            }
            ASSERT_EQ(blocks[i].layer, layer);
            ASSERT_EQ(blocks[i].point, carved_point(job->joining(), job->point_count(), layer, step));
            ASSERT_EQ(at, point_of(*job, blocks[i].layer, blocks[i].point));
            if (++step == job->point_count()) {
                step = 0;
                ++layer;
            }
        }
        EXPECT_EQ(layer, job->layer_count());
        EXPECT_EQ(step, 0U);
    }
}

TEST_P(Lookahead, SpeedsAreContinuousWithinARunAndWithinEveryAxisLimit) {
    std::mt19937_64 random{43};
    const MachineLimits limits = machine_limits(Profile{});
    const auto job = job_of(random_table(random, GetParam(), 25));
    double end2 = 0.0;
    std::uint32_t left = 0;
    for (const cycle::MotionBlock& block : blocks_of(job)) {
        if (block.kind != cycle::BlockKind::path) continue;
        ASSERT_GT(block.path.length, 0.0);
        ASSERT_LE(block.path.start_speed2[0], block.path.start_speed2[1] * (1.0 + 1e-9));
        if (left == 0) {
            left = block.group_blocks;
            ASSERT_GT(left, 0U);
        } else {
            ASSERT_EQ(block.group_blocks, 0U);
            ASSERT_NEAR(block.path.start_speed2[0], end2, 1e-9);
        }
        --left;
        end2 = block.path.end_speed2[0];
        const double seconds =
            2.0 * block.path.length / (std::sqrt(block.path.start_speed2[0]) + std::sqrt(end2));
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const double pulses = std::abs(static_cast<double>(block.delta_pulses[k])) - 1.0;
            EXPECT_LE(pulses / seconds, limits.axes[k].speed_pps * 1.001);
        }
    }
    EXPECT_EQ(left, 0U);
}

// Where a narrow tube is soon wide, the curve leaves its first point steeper than its chord does.
TEST(LookaheadProgram, NoAxisLeavesAStopFasterThanItsStartStopSpeed) {
    Profile profile;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->pulses_per_mm = 4000.0;
        axis->speed_mm_s = 12.0;
        axis->accel_mm_s2 = 220.0;
    }
    profile.psi.pulses_per_rev = 128'000;
    profile.psi.speed_deg_s = 135.0;
    profile.psi.accel_deg_s2 = 5300.0;
    profile.job.path_tolerance_mm = 0.001;
    const MachineLimits limits = machine_limits(profile);
    std::mt19937_64 random{47};
    double greatest_share = 0.0;
    for (int round = 0; round < 60; ++round) {
        JobTable table = random_table(random, Joining::zigzag, 400);
        table.psi_sweep_pulses = 64'000;
        LookaheadProgram program(limits, job_of(table));
        cycle::MotionBlock block;
        while (program.next(block)) {
            if (block.kind != cycle::BlockKind::path || block.group_blocks == 0) continue;
            const double speed = std::sqrt(block.path.start_speed2[0]) / block.path.length;
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                const double pulses = std::abs(static_cast<double>(block.delta_pulses[k])) - 1.0;
                greatest_share = std::max(greatest_share, pulses * speed / limits.axes[k].start_stop_pps);
            }
        }
    }
    EXPECT_LE(greatest_share, 1.02);
}

// Up to the middle between two layers the lower one's radius counts, above it the upper one's. Y never turns.
void expect_outside_of_layers(const JobView& job, const std::vector<cycle::MotionBlock>& blocks) {
    Pulses4 at = point_of(job, 0, carved_point(job.joining(), job.point_count(), 0, 0));
    std::uint32_t layer = 0;
    bool is_link = false;
    for (const cycle::MotionBlock& block : blocks) {
        for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += block.delta_pulses[k];
        ASSERT_GE(block.delta_pulses[3], 0);
        if (is_link) {
            const std::int64_t below = job.layer_heights_pulses()[layer];
            const std::int64_t above = job.layer_heights_pulses()[layer + 1];
            const std::uint32_t of = at[3] - below <= above - at[3] ? layer : layer + 1;
            const std::uint32_t step = of == layer ? job.point_count() - 1 : 0;
            const Pulses4 floor = point_of(job, of, carved_point(job.joining(), job.point_count(), of, step));
            ASSERT_GE(at[0], floor[0]);
            ASSERT_GE(at[1], floor[1]);
        }
        if (block.reaches_points == 0) continue;
        layer = block.layer;
        is_link =
            block.point == carved_point(job.joining(), job.point_count(), layer, job.point_count() - 1) &&
            layer + 1 < job.layer_count();
    }
}

TEST_P(LinkedLookahead, NoHeadStandsDeeperThanTheLayerItIsIn) {
    std::mt19937_64 random{47};
    for (int round = 0; round < 30; ++round) {
        const auto job = job_of(random_table(random, GetParam(), 10));
        expect_outside_of_layers(*job, blocks_of(job));
        ASSERT_FALSE(HasFatalFailure()) << round;
    }
}

// So are its pulses, since DDA and timing know nothing but the blocks.
TEST_P(LinkedLookahead, FromALayerOnTheBlocksAreThoseOfTheWholeRun) {
    std::mt19937_64 random{59};
    const auto job = job_of(random_table(random, GetParam(), 12));
    const auto whole = blocks_of(job);
    for (std::uint32_t layer = 1; layer < job->layer_count(); ++layer) {
        const auto part = blocks_of(job, layer);
        const std::uint32_t first = carved_point(job->joining(), job->point_count(), layer, 0);
        const auto begins = std::ranges::find_if(whole, [&](const cycle::MotionBlock& block) {
            return block.reaches_points != 0 && block.layer == layer && block.point == first;
        });
        ASSERT_NE(begins, whole.end());
        ASSERT_EQ(part.size(), static_cast<std::size_t>(whole.end() - begins) - 1);
        for (std::size_t i = 0; i < part.size(); ++i) {
            const cycle::MotionBlock& same = *(begins + 1 + static_cast<std::ptrdiff_t>(i));
            ASSERT_EQ(part[i].delta_pulses, same.delta_pulses);
            ASSERT_EQ(part[i].path.length, same.path.length);
            ASSERT_EQ(part[i].path.start_speed2, same.path.start_speed2);
            ASSERT_EQ(part[i].path.end_speed2, same.path.end_speed2);
            ASSERT_EQ(part[i].group_blocks, same.group_blocks);
            ASSERT_EQ(part[i].point, same.point);
        }
    }
}

TEST(LookaheadProgram, ReportsItsTimeAsTheReference) {
    std::mt19937_64 random{53};
    const auto job = job_of(random_table(random, Joining::continuous, 5));
    const MachineLimits limits = machine_limits(Profile{});
    LookaheadProgram program(limits, job);
    cycle::MotionBlock block;
    // A run takes whole ticks, and the one in which it begins.
    std::vector<double> runs_s;
    while (program.next(block)) {
        if (block.kind != cycle::BlockKind::path) continue;
        if (block.group_blocks > 0) runs_s.push_back(0.0);
        runs_s.back() += 2.0 * block.path.length /
                         (std::sqrt(block.path.start_speed2[0]) + std::sqrt(block.path.end_speed2[0]));
    }
    double ticks = 0.0;
    for (const double seconds : runs_s) ticks += std::ceil(seconds / limits.tick_seconds() - 1e-6) + 1.0;
    EXPECT_TRUE(program.planned().is_reference);
    EXPECT_NEAR(program.planned().seconds, ticks * limits.tick_seconds(), 1e-9);
    EXPECT_EQ(program.planned().points, 4U * 60U - 1U);
}

TEST_P(LinkedLookahead, OneLayersBlocksAreThoseOfTheWholeRun) {
    std::mt19937_64 random{61};
    const auto job = job_of(random_table(random, GetParam(), 12));
    for (std::uint32_t layer = 0; layer < job->layer_count(); ++layer) {
        const auto rest = blocks_of(job, layer);
        const auto one = blocks_of(job, layer, layer + 1);
        ASSERT_LE(one.size(), rest.size());
        for (std::size_t i = 0; i + 1 < one.size(); ++i) {
            ASSERT_EQ(one[i].delta_pulses, rest[i].delta_pulses);
            ASSERT_EQ(one[i].path.end_speed2, rest[i].path.end_speed2);
            ASSERT_TRUE(one[i].reaches_points == 0 || one[i].layer == layer) << i;
        }
        EXPECT_EQ(one.back().kind, cycle::BlockKind::program_end);
    }
}

// Y is where the table is on its straight way between two points, to a pulse.
TEST(LookaheadProgram, YRisesWithTheTableBetweenFarPoints) {
    const double tolerance_pulses = Profile{}.job.path_tolerance_mm * Profile{}.y.pulses_per_mm;
    std::mt19937_64 random{71};
    JobTable table = random_table(random, Joining::spiral, 200, 6);
    for (std::size_t i = 0; i < 5; ++i)
        table.layer_height_pulses[i] = 100 + 4000 * static_cast<std::int64_t>(i);
    table.layer_height_pulses[5] = table.layer_height_pulses[4];
    const auto job = job_of(table);
    Pulses4 at = point_of(*job, 0, 0);
    Pulses4 from = at;
    std::size_t next = 0;
    const auto blocks = blocks_of(job);
    for (std::size_t i = 0; i + 1 < blocks.size(); ++i) {
        if (next <= i) {
            for (next = i; blocks[next].reaches_points == 0; ++next) continue;
            ++next;
            from = at;
        }
        const Pulses4 to = point_of(*job, blocks[next - 1].layer, blocks[next - 1].point);
        for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += blocks[i].delta_pulses[k];
        ASSERT_GE(blocks[i].delta_pulses[3], 0);
        const double part = static_cast<double>(at[2] - from[2]) / static_cast<double>(to[2] - from[2]);
        // The DDA's half pulses of both axes take the rest of what rule 1 grants.
        const double slope = static_cast<double>(to[3] - from[3]) / static_cast<double>(to[2] - from[2]);
        const double allowed = tolerance_pulses + 0.5 + 0.5 * slope;
        ASSERT_NEAR(static_cast<double>(at[3] - from[3]), part * static_cast<double>(to[3] - from[3]),
                    allowed + 1e-4);
    }
}

INSTANTIATE_TEST_SUITE_P(Joinings, Lookahead,
                         ::testing::Values(Joining::continuous, Joining::zigzag, Joining::spiral),
                         [](const auto& named) { return std::string{name_of(named.param)}; });
INSTANTIATE_TEST_SUITE_P(Joinings, LinkedLookahead, ::testing::Values(Joining::continuous, Joining::zigzag),
                         [](const auto& named) { return std::string{name_of(named.param)}; });

}  // namespace
}  // namespace psicarve::plan
