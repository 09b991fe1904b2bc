// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "rtcore/plan/lookahead_program.hpp"
#include "tests/rtcore/plan/table_blocks.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve::plan {
namespace {

using test::blocks_of;
using test::job_of;
using test::random_table;

/// What the blocks of a run that begins at a layer's first point have in common with the whole run's.
void expect_same_cuts(const std::vector<cycle::MotionBlock>& part,
                      const std::vector<cycle::MotionBlock>& whole) {
    ASSERT_LT(part.size(), whole.size());
    const auto* same = whole.data() + (whole.size() - part.size());
    for (std::size_t i = 0; i < part.size(); ++i, ++same) {
        ASSERT_EQ(part[i].delta_pulses, same->delta_pulses) << i;
        ASSERT_EQ(part[i].path.length, same->path.length);
        ASSERT_EQ(part[i].reaches_points, same->reaches_points);
        ASSERT_EQ(part[i].layer, same->layer);
        ASSERT_EQ(part[i].point, same->point);
        for (std::size_t k = 0; k < 2; ++k) {
            ASSERT_LE(part[i].path.start_speed2[k], same->path.start_speed2[k]);
            ASSERT_LE(part[i].path.end_speed2[k], same->path.end_speed2[k]);
        }
    }
}

/// The first block begins at about start-stop speed, and until it has caught up no block asks more of an axis
/// than there is.
void expect_speeds_up_from_rest(const std::vector<cycle::MotionBlock>& part,
                                const std::vector<cycle::MotionBlock>& whole) {
    const cycle::PathTiming& first = part.front().path;
    EXPECT_LE(std::sqrt(first.start_speed2[1]), 1.1 * double{first.start_stop_speed});
    const auto* same = whole.data() + (whole.size() - part.size());
    double end2 = first.start_speed2[0];
    for (std::size_t i = 0; i < part.front().group_blocks; ++i, ++same) {
        const cycle::PathTiming& timing = part[i].path;
        ASSERT_NEAR(timing.start_speed2[0], end2, 1e-9) << i;
        end2 = timing.end_speed2[0];
        if (end2 == same->path.end_speed2[0]) continue;
        const double accel = 0.5 * (end2 - timing.start_speed2[0]) / timing.length;
        ASSERT_GT(accel, 0.0) << i;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            ASSERT_LE(accel + double{timing.accel_bend[k]} * end2, double{timing.accel_free[k]}) << i;
        }
    }
}

// Nothing stops between the rows of a spiral: where the carving begins in their midst it has to speed up. But
// the cuts, and with them the order of all pulses, are those of the whole run.
TEST(LookaheadProgram, FromARowOfASpiralOnOnlySpeedsDiffer) {
    std::mt19937_64 random{59};
    const auto job = job_of(random_table(random, Joining::spiral, 12, 300));
    const auto whole = blocks_of(job);
    for (const std::uint32_t layer : {1U, 2U, 100U, 135U, 136U, 137U, 298U, 299U}) {
        const auto part = blocks_of(job, layer);
        expect_same_cuts(part, whole);
        ASSERT_FALSE(::testing::Test::HasFatalFailure()) << layer;
        const auto& before = whole[whole.size() - part.size() - 1];
        EXPECT_EQ(before.layer, layer);
        EXPECT_EQ(before.point, 0U);
        expect_speeds_up_from_rest(part, whole);
        ASSERT_FALSE(::testing::Test::HasFatalFailure()) << layer;
    }
}

/// A cylinder of 12 layers.
JobTable even_table() {
    JobTable table;
    table.layer_count = 12;
    table.point_count = 61;
    table.psi_sweep_pulses = 3200;
    table.feed_mm_s = 1000.0;
    for (std::uint32_t layer = 0; layer < table.layer_count; ++layer) {
        table.layer_height_pulses.push_back(100 + 40 * layer);
    }
    table.r_left_pulses.assign(std::size_t{12} * 61, 4000);
    table.r_right_pulses = table.r_left_pulses;
    table.profile_toml = profile_to_toml(Profile{});
    return table;
}

// And where it ends in their midst it has to slow down.
TEST(LookaheadProgram, UpToARowOfASpiralOnlySpeedsDiffer) {
    const auto job = job_of(spiral_of(even_table()));
    const auto whole = blocks_of(job);
    for (std::uint32_t end = 1; end < job->layer_count(); ++end) {
        bool is_slowed_down = false;
        auto part = blocks_of(job, 0, end);
        ASSERT_EQ(part.back().kind, cycle::BlockKind::program_end);
        part.pop_back();
        std::uint32_t left = 0;
        double end2 = 0.0;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const cycle::PathTiming& timing = part[i].path;
            ASSERT_EQ(part[i].delta_pulses, whole[i].delta_pulses) << i;
            ASSERT_EQ(timing.length, whole[i].path.length);
            ASSERT_EQ(part[i].point, whole[i].point);
            ASSERT_LE(timing.start_speed2[1], whole[i].path.start_speed2[1]);
            if (left == 0) {
                left = part[i].group_blocks;
            } else {
                ASSERT_NEAR(timing.start_speed2[0], end2, 1e-9) << i;
            }
            --left;
            end2 = timing.end_speed2[0];
            if (end2 == whole[i].path.end_speed2[0]) continue;
            is_slowed_down = true;
            const double accel = 0.5 * (timing.start_speed2[0] - end2) / timing.length;
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                ASSERT_LE(accel + double{timing.accel_bend[k]} * timing.start_speed2[0],
                          double{timing.accel_free[k]})
                    << i;
            }
        }
        EXPECT_EQ(left, 0U);
        const cycle::PathTiming& last = part.back().path;
        EXPECT_LE(std::sqrt(last.end_speed2[1]), 1.1 * double{last.start_stop_speed}) << end;
        EXPECT_EQ(part.back().layer, end);
        EXPECT_EQ(part.back().point, 0U);
        EXPECT_TRUE(is_slowed_down) << end;
    }
}

TEST(LookaheadProgram, NothingStopsBetweenTheRowsOfASpiral) {
    JobTable table = even_table();
    const auto spiral = job_of(spiral_of(table));
    std::size_t runs = 0;
    double slowest2 = 1.0;
    const auto blocks = blocks_of(spiral);
    for (const cycle::MotionBlock& block : blocks) {
        runs += block.group_blocks > 0 ? 1 : 0;
        if (block.reaches_points == 2) slowest2 = std::min(slowest2, block.path.end_speed2[0]);
    }
    EXPECT_EQ(runs, 1U);
    EXPECT_GT(slowest2, 0.98);  // psi at its top speed
    LookaheadProgram rings(machine_limits(Profile{}), job_of(table));
    LookaheadProgram sut(machine_limits(Profile{}), spiral);
    cycle::MotionBlock block;
    while (rings.next(block)) continue;
    while (sut.next(block)) continue;
    EXPECT_LT(sut.planned().seconds, 0.95 * rings.planned().seconds);
    EXPECT_EQ(sut.planned().points, 12U * 61U - 1U);
}

}  // namespace
}  // namespace psicarve::plan
