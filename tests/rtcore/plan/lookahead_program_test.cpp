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

namespace psicarve::plan {
namespace {

struct OwnedJob {
    std::vector<std::byte> blob;
    JobView view;
};

JobTable random_table(std::mt19937_64& random, Joining joining, std::int64_t roughness) {
    JobTable table;
    table.layer_count = 4;
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
    return table;
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
            job.layer_heights_pulses()[layer]};
}

class Lookahead : public ::testing::TestWithParam<Joining> {};

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
            if (blocks[i].reaches_point == 0) continue;
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
        if (block.reaches_point == 0) continue;
        layer = block.layer;
        is_link =
            block.point == carved_point(job.joining(), job.point_count(), layer, job.point_count() - 1) &&
            layer + 1 < job.layer_count();
    }
}

TEST_P(Lookahead, NoHeadStandsDeeperThanTheLayerItIsIn) {
    std::mt19937_64 random{47};
    for (int round = 0; round < 30; ++round) {
        const auto job = job_of(random_table(random, GetParam(), 10));
        expect_outside_of_layers(*job, blocks_of(job));
        ASSERT_FALSE(HasFatalFailure()) << round;
    }
}

// So are its pulses, since DDA and timing know nothing but the blocks.
TEST_P(Lookahead, FromALayerOnTheBlocksAreThoseOfTheWholeRun) {
    std::mt19937_64 random{59};
    const auto job = job_of(random_table(random, GetParam(), 12));
    const auto whole = blocks_of(job);
    for (std::uint32_t layer = 1; layer < job->layer_count(); ++layer) {
        const auto part = blocks_of(job, layer);
        const std::uint32_t first = carved_point(job->joining(), job->point_count(), layer, 0);
        const auto begins = std::ranges::find_if(whole, [&](const cycle::MotionBlock& block) {
            return block.reaches_point != 0 && block.layer == layer && block.point == first;
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

INSTANTIATE_TEST_SUITE_P(Joinings, Lookahead, ::testing::Values(Joining::continuous, Joining::zigzag));

}  // namespace
}  // namespace psicarve::plan
