// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/record_program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <random>
#include <vector>

#include "rtcore/cycle/path_pace.hpp"
#include "tests/rtcore/plan/program_blocks.hpp"

namespace psicarve::plan {
namespace {

using cycle::BlockKind;
using cycle::MotionBlock;
using test::block_seconds;
using test::kStartPulses;
using test::program_blocks;
using test::random_program;
using test::Script;
using test::ScriptedSource;

bool is_same(const std::vector<MotionBlock>& a, const std::vector<MotionBlock>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a.front()) == 0;
}

TEST(RecordProgram, ReachesEveryExactEndToThePulseAtRest) {
    std::mt19937_64 random{11};
    Script script{kStartPulses};
    for (int i = 0; i < 60; ++i) {
        const auto part = [&] { return static_cast<std::int64_t>(random() % 401) - 200; };
        script.way({part(), part(), part(), part()}, i % 4 == 0 ? 0.0 : 0.02);
    }
    script.way({7, 0, 0, 0}, 0.0).end();
    std::map<std::uint64_t, Pulses4> rests;  // by line: where a run that ends in it ends
    Pulses4 at = kStartPulses;
    std::uint32_t left = 0;
    for (const MotionBlock& block : program_blocks(script.steps)) {
        if (block.kind != BlockKind::path) continue;
        if (block.group_blocks > 0) {
            ASSERT_EQ(left, 0U);
            left = block.group_blocks;
        }
        for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += block.delta_pulses[k];
        if (--left == 0) rests[program_line(block)] = at;
    }
    for (const ProgramStep& step : script.steps) {
        if (step.kind != MotionKind::way) continue;
        const auto rest = rests.find(step.line);
        if (step.tolerance_mm == 0.0) {
            ASSERT_NE(rest, rests.end()) << "line " << step.line;
        }
        if (rest == rests.end()) continue;
        EXPECT_EQ(rest->second, step.target_pulses) << "line " << step.line;
    }
    EXPECT_EQ(at, script.at());
}

TEST(RecordProgram, NeverTakesLessTimeThanAWayAsksFor) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const Script script = random_program(seed, kStartPulses, 80);
        std::map<std::uint64_t, std::array<double, 2>> seconds;
        for (const MotionBlock& block : program_blocks(script.steps)) {
            if (block.kind != BlockKind::path) continue;
            for (std::size_t timing = 0; timing < 2; ++timing)
                seconds[program_line(block)][timing] += block_seconds(block, timing);
        }
        for (const ProgramStep& step : script.steps) {
            if (step.kind != MotionKind::way || !seconds.contains(step.line)) continue;
            const auto& took = seconds[step.line];
            ASSERT_GE(took[0], step.seconds * 0.9999) << "seed " << seed << " line " << step.line;
            const double at_twice = step.is_rapid ? step.seconds : 0.5 * step.seconds;
            ASSERT_GE(took[1], at_twice * 0.9999) << "seed " << seed << " line " << step.line;
            ASSERT_LE(took[1], took[0] * 1.0001);
        }
    }
}

TEST(RecordProgram, KeepsEveryAxisWithinItsLimits) {
    const MachineLimits limits = machine_limits(Profile{});
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        double end2 = 0.0;
        std::uint32_t left = 0;
        for (const MotionBlock& block : program_blocks(random_program(seed, kStartPulses, 120).steps)) {
            if (block.kind != BlockKind::path) continue;
            ASSERT_TRUE(cycle::can_end(block.path));
            if (left == 0) {
                left = block.group_blocks;
                for (std::size_t k = 0; k < kAxisCount; ++k) {
                    const double pulses = std::abs(static_cast<double>(block.delta_pulses[k])) - 1.0;
                    const double jump = std::sqrt(block.path.start_speed2[0]) / block.path.length;
                    EXPECT_LE(pulses * jump, 0.5 * limits.axes[k].start_stop_pps * 1.02);
                }
            } else {
                ASSERT_EQ(block.group_blocks, 0U);
                ASSERT_NEAR(block.path.start_speed2[0], end2, 1e-9);
            }
            --left;
            end2 = block.path.end_speed2[0];
            for (std::size_t timing = 0; timing < 2; ++timing) {
                for (std::size_t k = 0; k < kAxisCount; ++k) {
                    const double pulses = std::abs(static_cast<double>(block.delta_pulses[k])) - 1.0;
                    EXPECT_LE(pulses / block_seconds(block, timing), limits.axes[k].speed_pps * 1.001);
                }
            }
        }
        EXPECT_EQ(left, 0U);
    }
}

// 200 programs, each as a writer with another mood gives it.
TEST(RecordProgram, MakesTheSameBlocksWheneverItsStepsCome) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const auto steps = random_program(seed, kStartPulses, 60).steps;
        const auto at_once = program_blocks(steps, seed % 5 == 0);
        auto source = std::make_shared<ScriptedSource>(steps);
        source->written = 0;
        RecordProgram program(machine_limits(Profile{}), source, kStartPulses, seed % 5 == 0);
        std::mt19937_64 random{seed};
        std::vector<MotionBlock> blocks;
        MotionBlock block;
        for (;;) {
            if (program.next(block)) {
                blocks.push_back(block);
            } else if (program.is_waiting()) {
                source->written += random() % 4;
            } else {
                break;
            }
        }
        ASSERT_TRUE(is_same(at_once, blocks)) << "seed " << seed;
    }
}

TEST(RecordProgram, HoldsNoMoreThanTwoPartsAndATail) {
    Script script{kStartPulses};
    for (int i = 0; i < 5000; ++i) script.way({i % 200 < 100 ? 2 : -2, 0, 3, 0}, 0.01);
    script.end();
    auto source = std::make_shared<ScriptedSource>(script.steps);
    RecordProgram program(machine_limits(Profile{}), source, kStartPulses);
    MotionBlock block;
    std::size_t most_ahead = 0;
    while (program.next(block)) {
        if (block.kind == BlockKind::path)
            most_ahead = std::max(most_ahead, source->taken() - program_line(block));
    }
    EXPECT_LE(most_ahead, 2 * RecordProgram::kPartPoints + RecordProgram::kTailPoints);
}

TEST(RecordProgram, MakesRestsOfEverythingThatIsNoWay) {
    Script script{kStartPulses};
    script.spindle(true).way({50, 0, 0, 0}, 0.01).dwell(0.25).way({50, 0, 0, 0}, 0.01);
    script.stop(StopReason::tool_change).spindle(false).end();
    const auto blocks = program_blocks(script.steps);
    std::vector<BlockKind> kinds;
    for (const MotionBlock& block : blocks) {
        if (kinds.empty() || block.kind != BlockKind::path || kinds.back() != BlockKind::path)
            kinds.push_back(block.kind);
    }
    using K = BlockKind;
    EXPECT_EQ(kinds, (std::vector{K::outputs, K::dwell, K::path, K::dwell, K::path, K::halt, K::outputs,
                                  K::outputs, K::program_end}));
    EXPECT_EQ(blocks[0].spindle, cycle::Spindle::on);
    EXPECT_EQ(blocks[1].ticks, machine_limits(Profile{}).spinup_ticks);
    const auto dwell = std::find_if(blocks.begin() + 2, blocks.end(),
                                    [](const MotionBlock& block) { return block.kind == K::dwell; });
    EXPECT_EQ(dwell->ticks, 5000);
    EXPECT_EQ(program_line(*dwell), 3U);
    const auto halt = std::find_if(blocks.begin(), blocks.end(),
                                   [](const MotionBlock& block) { return block.kind == K::halt; });
    EXPECT_EQ(halt->halt, ProgramHold::tool_change);
    EXPECT_EQ(program_line(*halt), 5U);
    EXPECT_EQ(blocks.back().kind, K::program_end);
    EXPECT_EQ(blocks[blocks.size() - 2].spindle, cycle::Spindle::off);
}

TEST(RecordProgram, HaltsAfterEachBlockOneAtATime) {
    Script script{kStartPulses};
    script.way({30, 0, 0, 0}, 0.01).way({0, 30, 0, 0}, 0.01).way({0, 0, 0, 0}, 0.01).dwell(0.1).end();
    script.steps[0].ends_block = false;
    std::vector<std::uint64_t> halted;
    for (const MotionBlock& block : program_blocks(script.steps, true)) {
        if (block.kind != BlockKind::halt) continue;
        EXPECT_EQ(block.halt, ProgramHold::single);
        halted.push_back(program_line(block));
    }
    EXPECT_EQ(halted, (std::vector<std::uint64_t>{2, 3, 4}));
}

// As behind each arc under G61, whose last record only brings it to rest.
TEST(RecordProgram, EndsALineWithItsLastWayWhereTheRecordBehindHasNone) {
    for (const double tolerance_mm : {0.0, 0.01, 0.02}) {
        Script script{kStartPulses};
        script.way({30, 0, 0, 0}, 0.01).way({0, 30, 0, 0}, 0.01).way({0, 0, 0, 0}, tolerance_mm).end();
        script.steps[0].ends_block = script.steps[1].ends_block = false;
        std::vector<std::int64_t> ends;  // of r1 and y together
        std::int64_t way = 0;
        for (const MotionBlock& block : program_blocks(script.steps)) {
            way += block.delta_pulses[0] + block.delta_pulses[1];
            if (block.marks != 0) ends.push_back(way);
        }
        EXPECT_EQ(ends, std::vector<std::int64_t>{60}) << tolerance_mm;
    }
}

// It stands where homing has the position of a latch.
TEST(RecordProgram, GivesEachBlockItsRecordAndNoneThatLatchesOrDefines) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        Script script = random_program(seed, kStartPulses, 300);
        script.steps.pop_back();
        script.spindle(true).dwell(0.1).stop();
        for (const bool is_single : {false, true}) {
            for (const Supply how : {Supply::ended, Supply::lost}) {
                std::uint64_t before = 0;
                for (const MotionBlock& block : program_blocks(script.steps, is_single, {}, how)) {
                    ASSERT_EQ(program_sequence(block), program_line(block) + test::kBeforeScript);
                    ASSERT_GE(program_sequence(block), before);
                    before = program_sequence(block);
                    ASSERT_EQ(block.latch, cycle::Latch::none);
                    ASSERT_EQ(block.until, cycle::Until::none);
                    ASSERT_NE(block.kind, BlockKind::define);
                }
                EXPECT_GT(before, test::kBeforeScript);
            }
        }
    }
}

TEST(RecordProgram, RunsAllThatItHasBeforeALossOrARefusal) {
    Script script{kStartPulses};
    script.way({30, 0, 0, 0}, 0.01).way({30, 0, 0, 0}, 0.01);
    for (const Supply how : {Supply::lost, Supply::refused}) {
        const auto blocks = program_blocks(script.steps, false, {}, how);
        std::int64_t way = 0;
        for (const MotionBlock& block : blocks) way += block.delta_pulses[0];
        EXPECT_EQ(way, 60);
        EXPECT_EQ(blocks.back().kind, BlockKind::halt);
        EXPECT_EQ(blocks.back().halt, how == Supply::lost ? ProgramHold::feeder_lost : ProgramHold::refused);
        EXPECT_EQ(program_line(blocks.back()), 2U);
    }
}

// The gap is crossed at rest: in a run such an axis goes one way, and the run says which.
TEST(RecordProgram, TurnsAnAxisWithBacklashRoundAtRestAlone) {
    Profile profile;
    profile.r1.backlash_mm = 0.02;
    profile.y.backlash_mm = 0.03;
    const MachineLimits limits = machine_limits(profile);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Script script = random_program(seed, kStartPulses, 80);
        Pulses4 at = kStartPulses;
        std::uint8_t up = 0;
        std::uint8_t down = 0;
        for (const MotionBlock& block : program_blocks(script.steps, false, profile)) {
            if (block.group_blocks > 0) {
                up = block.up_axes;
                down = block.down_axes;
            }
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                at[k] += block.delta_pulses[k];
                if (limits.tick.axes[k].backlash_pulses == 0 || block.delta_pulses[k] == 0) continue;
                ASSERT_NE((block.delta_pulses[k] > 0 ? up : down) & 1U << k, 0U) << "seed " << seed;
            }
            ASSERT_EQ(up & down, 0U);
        }
        EXPECT_EQ(at, script.at());
    }
}

// A way that goes nowhere still brings it to rest, where that is asked for.
TEST(RecordProgram, RestsAtTheEndOfAWayWithoutAPulse) {
    Script script{kStartPulses};
    script.way({30, 0, 0, 0}, 0.01).way({}, 0.0).way({30, 0, 0, 0}, 0.01).end();
    int runs = 0;
    for (const MotionBlock& block : program_blocks(script.steps)) runs += block.group_blocks > 0 ? 1 : 0;
    EXPECT_EQ(runs, 2);
}

// What a wrong record may ask for: millions of turns of psi, there and back, amid short ways. Curved, it
// would be cut without end.
TEST(RecordProgram, GoesAWayOfMillionsOfTurnsStraightAndInFewBlocks) {
    Script script{kStartPulses};
    for (int i = 0; i < 100; ++i) {
        const bool is_long = i % 10 == 5;
        const std::int64_t turned = i % 20 == 5 ? 60'000'000'000 : -60'000'000'000;
        script.way({15 + i % 7, -12, is_long ? turned : 21, 9}, 0.01);
    }
    script.end();
    const std::vector<MotionBlock> blocks = program_blocks(script.steps);
    EXPECT_LT(blocks.size(), 5'000U);
    Pulses4 at = kStartPulses;
    for (const MotionBlock& block : blocks) {
        std::int64_t longest = 0;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            at[k] += block.delta_pulses[k];
            longest = std::max(longest, std::abs(block.delta_pulses[k]));
        }
        EXPECT_LE(longest, std::int64_t{1} << 30);
    }
    EXPECT_EQ(at, script.at());
}

}  // namespace
}  // namespace psicarve::plan
