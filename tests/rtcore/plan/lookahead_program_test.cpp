// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/lookahead_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "shared/job.hpp"
#include "shared/units.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve::plan {
namespace {

struct OwnedJob {
    std::vector<std::byte> blob;
    JobView view;
};

JobTable random_table(std::mt19937_64& random, Joining joining, std::int64_t roughness,
                      std::uint32_t layers = 4) {
    JobTable table;
    table.layer_count = layers;
    table.point_count = 60;
    table.psi_sweep_pulses = 3200;
    table.joining = joining;
    table.feed_mm_s = 20.0;
    std::int64_t height = 100;
    for (std::uint32_t layer = 0; layer < table.layer_count; ++layer) {
        table.layer_height_pulses.push_back(height);
        height += 1 + static_cast<std::int64_t>(random() % 90);
        for (auto* radii : {&table.r_left_pulses, &table.r_right_pulses}) {
            auto radius = static_cast<std::int32_t>(5000 + random() % 2000);
            for (std::uint32_t point = 0; point < table.point_count; ++point) {
                const auto step =
                    static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * roughness + 1));
                radius += static_cast<std::int32_t>(step - roughness);
                radii->push_back(radius);
            }
        }
    }
    table.profile_toml = profile_to_toml(Profile{});
    return joining == Joining::spiral ? spiral_of(table) : table;
}

std::shared_ptr<const JobView> job_of(const JobTable& table) {
    auto owned = std::make_shared<OwnedJob>();
    owned->blob = job_blob_from_table(table);
    const auto view = JobView::check(owned->blob);
    EXPECT_TRUE(view);
    owned->view = *view;
    return {owned, &owned->view};
}

std::vector<cycle::MotionBlock> blocks_of(const std::shared_ptr<const JobView>& job,
                                          std::uint32_t first_layer = 0) {
    LookaheadProgram program(machine_limits(Profile{}), job, first_layer);
    std::vector<cycle::MotionBlock> blocks;
    cycle::MotionBlock block;
    while (program.next(block)) blocks.push_back(block);
    return blocks;
}

Pulses4 point_of(const JobView& job, std::uint32_t layer, std::uint32_t point) {
    return {job.r_left_pulses(layer)[point], job.r_right_pulses(layer)[point], job.psi_pulses(layer, point),
            job.y_pulses(layer, point)};
}

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
    LookaheadProgram program(machine_limits(Profile{}), job);
    cycle::MotionBlock block;
    double seconds = 0.0;
    while (program.next(block)) {
        if (block.kind != cycle::BlockKind::path) continue;
        seconds += 2.0 * block.path.length /
                   (std::sqrt(block.path.start_speed2[0]) + std::sqrt(block.path.end_speed2[0]));
    }
    EXPECT_TRUE(program.planned().is_reference);
    EXPECT_NEAR(program.planned().seconds, seconds, 1e-6 * seconds);
    EXPECT_EQ(program.planned().points, 4U * 60U - 1U);
}

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

TEST(LookaheadProgram, NothingStopsBetweenTheRowsOfASpiral) {
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

// Y is where the table is on its straight way between two points, to a pulse.
TEST(LookaheadProgram, YRisesWithTheTableBetweenFarPoints) {
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
        ASSERT_NEAR(static_cast<double>(at[3] - from[3]), part * static_cast<double>(to[3] - from[3]),
                    0.5001);
    }
}

INSTANTIATE_TEST_SUITE_P(Joinings, Lookahead,
                         ::testing::Values(Joining::continuous, Joining::zigzag, Joining::spiral));
INSTANTIATE_TEST_SUITE_P(Joinings, LinkedLookahead, ::testing::Values(Joining::continuous, Joining::zigzag));

}  // namespace
}  // namespace psicarve::plan
