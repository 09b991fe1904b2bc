// SPDX-License-Identifier: GPL-3.0-or-later
// Programs too long to be planned at once: part by part, without a rest between them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

#include "rtcore/plan/path_stretch.hpp"
#include "tests/rtcore/plan/program_blocks.hpp"

namespace psicarve::plan {
namespace {

using cycle::BlockKind;
using cycle::MotionBlock;
using test::block_seconds;
using test::dense_program;
using test::kStartPulses;
using test::program_blocks;
using test::Script;
using test::ScriptedSource;

struct Groups {
    std::vector<std::vector<MotionBlock>> groups;
    double seconds = 0.0;
    int runs = 0;  ///< from rest to rest
};

Groups groups_of(const std::vector<MotionBlock>& blocks) {
    Groups all;
    for (const MotionBlock& block : blocks) {
        if (block.kind != BlockKind::path) continue;
        if (block.group_blocks > 0) all.groups.emplace_back();
        all.groups.back().push_back(block);
        all.seconds += block_seconds(block, 0);
        all.runs += block.group_blocks > 0 && (block.joints & cycle::kCarriesOn) == 0 ? 1 : 0;
    }
    return all;
}

/// All of a program's points as one stretch, planned at once.
double seconds_at_once(const Script& script) {
    MachineLimits limits = machine_limits(Profile{});
    limits.is_program = true;
    limits.feed_mm_s = 1e9;
    for (AxisMotion& axis : limits.axes) axis.start_stop_pps *= 0.5;
    limits.path_tolerance_mm = 0.02;
    std::vector<PathPoint> points{{kStartPulses, 0, 0, false}};
    std::vector<double> least_s;
    bool lifts = false;
    for (const ProgramStep& step : script.steps) {
        if (step.kind != MotionKind::way || step.target_pulses == points.back().pulses) continue;
        points.push_back({step.target_pulses, 0, 0, false});
        least_s.push_back(step.seconds);
        lifts = lifts || step.target_pulses[kY] != kStartPulses[kY];
    }
    if (lifts) limits.path_tolerance_mm *= 0.7;
    auto spans = path_spans(limits, points);
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const double pace = least_s[i] / spans[i].length;
        spans[i].least_pace2 = {pace * pace, 0.25 * pace * pace};
    }
    const auto corners = path_corners(limits, spans);
    for (const PathCorner& corner : corners) EXPECT_FALSE(corner.is_stop);
    StretchPlanner planner(limits);
    std::vector<PathPiece> pieces;
    planner.plan(points, spans, corners, 0, points.size() - 1, pieces);
    double seconds = 0.0;
    for (const PathPiece& piece : pieces)
        seconds += cell_seconds(piece.length, piece.begin_speed2[0], piece.end_speed2[0]);
    return seconds;
}

TEST(ProgramHorizon, GoesThroughTwentyThousandWaysWithoutARest) {
    const Script script = dense_program(1, 20'000, 0b1101);
    const Groups all = groups_of(program_blocks(script.steps));
    EXPECT_EQ(all.runs, 1);
    EXPECT_GE(all.groups.size(), 38U);
    Pulses4 at = kStartPulses;
    for (const auto& group : all.groups) {
        EXPECT_LE(group.size(), cycle::kGroupStartBlocks);
        for (const MotionBlock& block : group) {
            for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += block.delta_pulses[k];
        }
    }
    EXPECT_EQ(at, script.at());
}

TEST(ProgramHorizon, TakesAsLongAsIfAllWasPlannedAtOnce) {
    for (const unsigned axes : {0b0101U, 0b1001U, 0b1111U}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const Script script = dense_program(seed, 3000, axes);
            const Groups all = groups_of(program_blocks(script.steps));
            EXPECT_EQ(all.runs, 1);
            const double at_once_s = seconds_at_once(script);
            EXPECT_LE(all.seconds, 1.01 * at_once_s) << "axes " << axes << " seed " << seed;
        }
    }
}

TEST(ProgramHorizon, NeverJumpsFromGroupToGroupAndCanRestFromEachBegin) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const double step = seed % 2 == 0 ? 20.0 : 3.0;
        const Groups all = groups_of(program_blocks(dense_program(seed, 3000, 0b1101, step).steps));
        ASSERT_EQ(all.runs, 1);
        for (std::size_t g = 0; g < all.groups.size(); ++g) {
            const auto& group = all.groups[g];
            const bool is_last = g + 1 == all.groups.size();
            for (std::size_t i = 0; i < group.size(); ++i) {
                const MotionBlock& block = group[i];
                ASSERT_EQ(block.joints, (g > 0 ? cycle::kCarriesOn : 0) | (is_last ? 0 : cycle::kGoesOn));
                if (i == 0 && g == 0) continue;
                const MotionBlock& before = i > 0 ? group[i - 1] : all.groups[g - 1].back();
                for (std::size_t t = 0; t < 2; ++t) {
                    ASSERT_NEAR(block.path.start_speed2[t], before.path.end_speed2[t],
                                1e-9 * before.path.end_speed2[t]);
                    ASSERT_GE(block.path.start_speed2[1], block.path.start_speed2[0] * (1 - 1e-12));
                }
                if (i > 0 && !is_last) {
                    ASSERT_NEAR(block.path.rest_speed2[0], before.path.rest_speed2[1],
                                1e-9 * before.path.rest_speed2[1]);
                }
            }
            if (is_last) continue;
            EXPECT_GE(group.front().path.rest_speed2[0], group.front().path.start_speed2[1] * (1 - 1e-9));
            const double rest = std::sqrt(group.back().path.rest_speed2[1]);
            EXPECT_LE(rest, 0.51 * group.back().path.start_stop_speed) << "group " << g;
            EXPECT_GT(group.back().path.end_speed2[0], group.back().path.rest_speed2[1]);
        }
    }
}

// Where a part is too short to come to rest within, what it begins with is as slow as that.
TEST(ProgramHorizon, GoesNoFasterThanThePartAheadCanStop) {
    Profile profile;
    profile.psi.accel_deg_s2 = 20.0;
    profile.psi.start_stop_deg_s = 1.0;
    Script script{kStartPulses};
    for (int i = 0; i < 6000; ++i) script.way({0, 0, 1, 0}, 0.02);
    script.end();
    const Groups all = groups_of(program_blocks(script.steps, false, profile));
    ASSERT_EQ(all.runs, 1);
    ASSERT_GE(all.groups.size(), 11U);
    bool is_bound = false;
    for (const auto& group : all.groups) {
        const cycle::PathTiming& first = group.front().path;
        if ((group.front().joints & cycle::kGoesOn) == 0) continue;
        EXPECT_GE(first.rest_speed2[0], first.start_speed2[1] * (1 - 1e-9));
        is_bound = is_bound || first.rest_speed2[0] < first.start_speed2[1] * 1.01;
    }
    EXPECT_TRUE(is_bound);
}

// On a straight way there is nothing but the braking: none of the three profiles asks more of a motor than it
// has, however the ways' own speeds are cut into segments.
TEST(ProgramHorizon, BrakesToItsRestsWithinWhatTheAxesHave) {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        std::mt19937_64 random{seed};
        Script script{kStartPulses};
        for (int i = 0; i < 3000; ++i) {
            const auto pulses = static_cast<std::int64_t>(20 + random() % 60);
            const double pace_s =
                random() % 3 == 0 ? 0.0 : 0.0003 + 2e-5 * static_cast<double>(random() % 200);
            script.way({0, 0, pulses, 0}, 0.02, pace_s * static_cast<double>(pulses));
        }
        script.end();
        const Groups all = groups_of(program_blocks(script.steps));
        ASSERT_EQ(all.runs, 1);
        for (const auto& group : all.groups) {
            if ((group.front().joints & cycle::kGoesOn) == 0) continue;
            for (const MotionBlock& block : group) {
                const auto& rest2 = block.path.rest_speed2;
                const double brake = 0.5 * std::abs(rest2[1] - rest2[0]) / block.path.length;
                worst = std::max(worst, brake / block.path.accel_free[kPsi]);
            }
        }
    }
    EXPECT_LE(worst, 1.0);
}

TEST(ProgramHorizon, GoesOnWhereYBeginsToMove) {
    for (const std::size_t planar : {400U, 1500U}) {
        Script script = dense_program(5, 3000, 0b0101);
        Pulses4 at{};
        for (std::size_t i = planar; i + 1 < script.steps.size(); ++i)
            script.steps[i].target_pulses[kY] += static_cast<std::int64_t>(i - planar + 1);
        const auto blocks = program_blocks(script.steps);
        EXPECT_EQ(groups_of(blocks).runs, 1);
        for (const MotionBlock& block : blocks) {
            for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += block.delta_pulses[k];
        }
        const Pulses4 to = script.steps[script.steps.size() - 2].target_pulses;
        for (std::size_t k = 0; k < kAxisCount; ++k) EXPECT_EQ(at[k], to[k] - kStartPulses[k]);
    }
}

// From part to part no axis with backlash begins to move or turns round: the gap is crossed at rest.
TEST(ProgramHorizon, CrossesGapsAtRestAlone) {
    Profile profile;
    profile.r1.backlash_mm = 0.02;
    profile.y.backlash_mm = 0.03;
    const MachineLimits limits = machine_limits(profile);
    int all_joined = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        // An axis goes one way, or stands still, for up to three parts.
        std::mt19937_64 random{seed};
        Script script{kStartPulses};
        Pulses4 way{0, 0, 20, 0};
        std::array<int, kAxisCount> until{};
        for (int i = 0; i < 5000; ++i) {
            for (const std::size_t k : {std::size_t{0}, kY}) {
                if (i < until[k]) continue;
                until[k] = i + 1 + static_cast<int>(random() % (3 * RecordProgram::kPartPoints));
                way[k] = static_cast<std::int64_t>(random() % 3) - 1;
            }
            script.way(way, 0.02);
        }
        const auto blocks = program_blocks(script.end().steps, false, profile);
        std::array<int, kAxisCount> ways{};
        std::uint8_t up = 0;
        std::uint8_t down = 0;
        int joined = 0;
        for (const MotionBlock& block : blocks) {
            const bool begins = block.group_blocks > 0;
            const bool carries_on = (block.joints & cycle::kCarriesOn) != 0;
            joined += begins && carries_on ? 1 : 0;
            if (begins && !carries_on) {
                up = block.up_axes;
                down = block.down_axes;
                for (std::size_t k = 0; k < kAxisCount; ++k) {
                    if ((up >> k & 1U) != 0) ways[k] = 1;
                    if ((down >> k & 1U) != 0) ways[k] = -1;
                }
            }
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                if (limits.tick.axes[k].backlash_pulses == 0 || block.delta_pulses[k] == 0) continue;
                ASSERT_EQ(block.delta_pulses[k] > 0 ? 1 : -1, ways[k]) << "seed " << seed << " axis " << k;
            }
        }
        all_joined += joined;
    }
    EXPECT_GT(all_joined, 12);
}

// How the axis stands in its gap is known, however long ago it moved.
TEST(ProgramHorizon, GoesOnWhereAnAxisWithBacklashGoesOnTheSameWay) {
    Profile profile;
    profile.r1.backlash_mm = 0.02;
    const auto runs_of = [&profile](std::int64_t second_way) {
        Script script{kStartPulses};
        for (int i = 0; i < 2600; ++i) {
            const std::int64_t out = i < 100 ? 1 : i < 1700 ? 0 : second_way;
            script.way({out, 0, 20, 0}, 0.02);
        }
        return groups_of(program_blocks(script.end().steps, false, profile)).runs;
    };
    EXPECT_EQ(runs_of(1), 1);
    EXPECT_EQ(runs_of(-1), 2);
}

TEST(ProgramHorizon, MakesTheSameBlocksWheneverItsStepsCome) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const auto steps = dense_program(seed, 2200, seed % 2 == 0 ? 0b1101 : 0b0101).steps;
        const auto at_once = program_blocks(steps);
        auto source = std::make_shared<ScriptedSource>(steps);
        source->written = 0;
        RecordProgram program(machine_limits(Profile{}), source, kStartPulses);
        std::mt19937_64 random{seed};
        std::vector<MotionBlock> blocks;
        MotionBlock block;
        for (;;) {
            if (program.next(block)) {
                blocks.push_back(block);
            } else if (program.is_waiting()) {
                source->written += random() % 40;
            } else {
                break;
            }
        }
        ASSERT_EQ(at_once.size(), blocks.size());
        EXPECT_EQ(std::memcmp(at_once.data(), blocks.data(), blocks.size() * sizeof block), 0);
    }
}

}  // namespace
}  // namespace psicarve::plan
