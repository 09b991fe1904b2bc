// SPDX-License-Identifier: GPL-3.0-or-later
// Where a stop is sooner than a turn, how links go, and how soon the first block is there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "rtcore/plan/carve_program.hpp"
#include "rtcore/plan/lookahead_program.hpp"
#include "tests/rtcore/plan/table_blocks.hpp"

namespace psicarve::plan {
namespace {

using test::job_of;
using test::random_table;

double seconds_of(Program& program) {
    cycle::MotionBlock block;
    while (program.next(block)) continue;
    return program.planned().seconds;
}

double seconds_of(const JobTable& table, double tolerance_mm) {
    Profile profile;
    profile.job.path_tolerance_mm = tolerance_mm;
    LookaheadProgram program(machine_limits(profile), job_of(table));
    return seconds_of(program);
}

/// So many points a tooth and as many a gap, each head a step of 3 mm at a time.
JobTable teeth(std::uint32_t points_a_tooth) {
    std::mt19937_64 random{1};
    JobTable table = random_table(random, Joining::continuous, 0, 1);
    table.point_count = 14 * points_a_tooth;
    table.r_left_pulses.clear();
    table.r_right_pulses.clear();
    for (std::uint32_t point = 0; point < table.point_count; ++point) {
        const bool is_tooth = point / points_a_tooth % 2 == 0;
        table.r_left_pulses.push_back(is_tooth ? 5200 : 4000);
        table.r_right_pulses.push_back(is_tooth ? 4000 : 5200);
    }
    return table;
}

// What goes within the narrow tube goes within the wide one.
TEST(FastWays, AWiderTubeIsNotSlowerWhereStopsAreSooner) {
    for (const std::uint32_t points : {10U, 20U, 35U}) {
        const JobTable table = teeth(points);
        EXPECT_LE(seconds_of(table, 0.01), 1.002 * seconds_of(table, 0.0027)) << points;
        EXPECT_LE(seconds_of(table, 0.03), 1.002 * seconds_of(table, 0.01)) << points;
    }
}

JobTable rings(std::int32_t step_pulses) {
    std::mt19937_64 random{2};
    JobTable table = random_table(random, Joining::continuous, 0, 4);
    for (std::uint32_t layer = 0; layer < table.layer_count; ++layer) {
        table.layer_height_pulses[layer] = 100 + 40 * layer;
        for (std::uint32_t i = layer * table.point_count; i < (layer + 1) * table.point_count; ++i) {
            table.r_left_pulses[i] = table.r_right_pulses[i] =
                5000 + step_pulses * static_cast<std::int32_t>(layer);
        }
    }
    return table;
}

// Three moves one after the other against one, Y rising while the heads come out or set off inwards.
TEST(FastWays, LinksWhoseHeadsGoTheSameWayBlend) {
    const MachineLimits limits = machine_limits(Profile{});
    const auto links_s = [&](auto program) {
        decltype(program) level(limits, job_of(rings(0)));
        return seconds_of(program) - seconds_of(level);
    };
    for (const std::int32_t step_pulses : {200, -200}) {
        const JobTable table = rings(step_pulses);
        const double blended_s = links_s(LookaheadProgram(limits, job_of(table)));
        const double stopping_s = links_s(CarveProgram(limits, job_of(table)));
        EXPECT_LE(blended_s, 0.96 * stopping_s) << step_pulses;
    }
}

std::vector<cycle::MotionBlock> blocks_from(const MachineLimits& limits, const JobTable& table,
                                            std::uint32_t layer) {
    LookaheadProgram program(limits, job_of(table), {layer, kLastLayer});
    std::vector<cycle::MotionBlock> blocks;
    cycle::MotionBlock block;
    while (program.next(block)) blocks.push_back(block);
    return blocks;
}

// A head that came out with the link goes on outwards within the layer: the gap is behind it, wherever
// carving began.
TEST(FastWays, CarvingOnFromALayerPlansTheSameWithBacklash) {
    Profile profile;
    profile.r1.backlash_mm = profile.r2.backlash_mm = profile.y.backlash_mm = 0.05;
    JobTable table = rings(300);
    for (std::uint32_t i = 0; i < table.r_left_pulses.size(); ++i) {
        const auto past = static_cast<std::int32_t>(i % table.point_count) - 30;
        if (past > 0) table.r_left_pulses[i] += past * past / 4;
    }
    const MachineLimits limits = machine_limits(profile);
    const auto whole = blocks_from(limits, table, 0);
    for (const std::uint32_t layer : {1U, 2U, 3U}) {
        const auto part = blocks_from(limits, table, layer);
        ASSERT_LT(part.size(), whole.size());
        for (std::size_t i = 1; i <= part.size(); ++i) {
            const auto& expected = whole[whole.size() - i];
            const auto& found = part[part.size() - i];
            ASSERT_EQ(found.delta_pulses, expected.delta_pulses) << layer << ", the last but " << i;
            ASSERT_EQ(found.path.start_speed2, expected.path.start_speed2) << layer << ", the last but " << i;
            ASSERT_EQ(found.up_axes, expected.up_axes) << layer << ", the last but " << i;
        }
    }
}

// However many layers there are.
TEST(FastWays, TheFirstBlockIsThereAfterOneLayer) {
    for (const std::uint32_t layers : {3U, 300U}) {
        std::mt19937_64 random{3};
        const auto job = job_of(random_table(random, Joining::continuous, 40, layers));
        LookaheadProgram program(machine_limits(Profile{}), job);
        cycle::MotionBlock block;
        std::uint64_t most = 0;
        std::uint64_t before = 0;
        while (program.next(block)) {
            const std::uint64_t points = program.planned().points;
            most = std::max(most, points - before);
            before = points;
        }
        EXPECT_EQ(before + 1, std::uint64_t{layers} * job->point_count())
            << "the first one is where it begins";
        EXPECT_EQ(most, job->point_count()) << "planned at once";
    }
}

}  // namespace
}  // namespace psicarve::plan
