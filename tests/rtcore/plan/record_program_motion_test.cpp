// SPDX-License-Identifier: GPL-3.0-or-later
// What the blocks of a program make of the machine: ways, times, limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "shared/base/units.hpp"
#include "tests/rtcore/cycle/path_rig.hpp"
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

std::vector<BlockKind> kinds_of(const std::vector<MotionBlock>& blocks) {
    std::vector<BlockKind> kinds;
    for (const MotionBlock& block : blocks) kinds.push_back(block.kind);
    return kinds;
}

// v^2/2a each way, and v between them, but for what is kept back of both for whole pulses in whole ticks.
TEST(RecordProgramMotion, TakesAsLongForAStraightWayAsItsMotorTakesAtBest) {
    Profile profile;
    const MachineLimits limits = machine_limits(profile);
    const AxisMotion& axis = limits.axes[0];
    Script script{kStartPulses};
    script.way({-4000, 0, 0, 0}, 0.0).end();
    const auto blocks = program_blocks(script.steps);
    double seconds = 0.0;
    for (const MotionBlock& block : blocks) {
        if (block.kind == BlockKind::path) seconds += block_seconds(block, 0);
    }
    const double v = 0.998 * axis.speed_pps;
    const double a = 0.985 * axis.accel_pps2;
    const double j = 0.5 * axis.start_stop_pps;
    const double best_s = 2.0 * (v - j) / a + (4000.0 - (v * v - j * j) / a) / v;
    EXPECT_NEAR(seconds, best_s, 1e-9);
    EXPECT_EQ(kinds_of(blocks), (std::vector{BlockKind::path, BlockKind::path, BlockKind::path,
                                             BlockKind::outputs, BlockKind::program_end}));
}

/// Where every axis is after each tick.
std::vector<Pulses4> ticked(const std::vector<MotionBlock>& blocks, const MachineLimits& limits,
                            std::vector<std::uint64_t>* lines = nullptr) {
    cycle::PathRig rig{limits.tick};
    rig.pulses.set_enables(0xF, 0);
    for (const MotionBlock& block : blocks) {
        if (block.kind == BlockKind::path || block.kind == BlockKind::program_end)
            rig.program.push_back(block);
    }
    for (std::size_t k = 0; k < kAxisCount; ++k) rig.pulses.set_position(k, kStartPulses[k]);
    std::vector<Pulses4> places;
    for (int n = 0; n < 20'000'000; ++n) {
        const auto progress = rig.tick();
        places.push_back(rig.pulses.positions());
        if (lines != nullptr) lines->push_back(rig.executor.program_line());
        EXPECT_EQ(progress & cycle::Executor::kStarved, 0U);
        if ((progress & (cycle::Executor::kProgramEnd | cycle::Executor::kStarved)) != 0) return places;
    }
    ADD_FAILURE() << "it does not end";
    return places;
}

/// Square corners at random, of three axes.
Script square_corners(std::uint64_t seed, double tolerance_mm) {
    std::mt19937_64 random{seed};
    Script script{kStartPulses};
    constexpr std::array<std::size_t, 3> kSquareAxes{0, kPsi, kY};
    for (std::size_t i = 0; i < 120; ++i) {
        Pulses4 way{};
        const std::size_t axis = kSquareAxes[i % 3];
        way[axis] = static_cast<std::int64_t>(random() % 400) - 200;
        if (axis == kPsi) way[axis] /= 4;
        script.way(way, tolerance_mm);
    }
    script.end();
    return script;
}

// The quick test of what pulses must obey, at windows from 5 to 100 ms; rests and turns may jump.
TEST(RecordProgramMotion, AsksNoMotorForMoreThanItsAcceleration) {
    const MachineLimits limits = machine_limits(Profile{});
    const double tick_s = limits.tick_seconds();
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        const Script script = seed <= 8 ? random_program(seed, kStartPulses, 120)
                                        : square_corners(seed, seed % 2 == 0 ? 0.05 : 0.3);
        const auto places = ticked(program_blocks(script.steps), limits);
        for (const double window_s : {0.005, 0.02, 0.1}) {
            const auto w = static_cast<std::size_t>(window_s / tick_s);
            for (std::size_t k = 0; k < kAxisCount; ++k) {
                const AxisMotion& axis = limits.axes[k];
                // One jump of a motor that rests or turns round within the window.
                const double most =
                    axis.accel_pps2 * window_s * window_s + axis.start_stop_pps * window_s + 6.0;
                for (std::size_t t = w; t + w < places.size(); t += 7) {
                    const auto second =
                        static_cast<double>(places[t + w][k] - 2 * places[t][k] + places[t - w][k]);
                    ASSERT_LE(std::abs(second), most) << "seed " << seed << " axis " << k << " tick " << t;
                }
            }
        }
    }
}

/// From a place to the nearest of a way's neighbouring chords, in a head's space (r * psi, R, Y).
double off_chords_mm(const MachineLimits& limits, const std::vector<Pulses4>& points, std::size_t way,
                     const Pulses4& at, std::size_t head) {
    const double radius_mm = static_cast<double>(at[head]) / limits.axes[head].pulses_per_unit;
    const double psi_mm = rad_from_pulses(1, limits.pulses_per_rev) * radius_mm;
    const auto place = [&](const Pulses4& p) {
        return std::array{static_cast<double>(p[kPsi] - at[kPsi]) * psi_mm,
                          static_cast<double>(p[head] - at[head]) / limits.axes[head].pulses_per_unit,
                          static_cast<double>(p[kY] - at[kY]) / limits.axes[kY].pulses_per_unit};
    };
    double least_mm = 1e9;
    for (std::size_t i = way > 1 ? way - 1 : way; i <= way + 1 && i < points.size(); ++i) {
        const auto a = place(points[i - 1]);
        const auto b = place(points[i]);
        double along = 0.0;
        double length2 = 0.0;
        for (std::size_t d = 0; d < 3; ++d) {
            along -= a[d] * (b[d] - a[d]);
            length2 += (b[d] - a[d]) * (b[d] - a[d]);
        }
        const double share = length2 > 0.0 ? std::clamp(along / length2, 0.0, 1.0) : 0.0;
        double off2 = 0.0;
        for (std::size_t d = 0; d < 3; ++d) {
            const double off = a[d] + share * (b[d] - a[d]);
            off2 += off * off;
        }
        least_mm = std::min(least_mm, std::sqrt(off2));
    }
    return least_mm;
}

TEST(RecordProgramMotion, StaysWithinTheToleranceAndAPulseOfItsWays) {
    const MachineLimits limits = machine_limits(Profile{});
    const double pulse_mm = 1.0 / limits.axes[0].pulses_per_unit + 1.0 / limits.axes[kY].pulses_per_unit;
    for (const unsigned axes : {0b0001U, 0b1001U, 0b0101U, 0b1101U}) {
        for (const double tolerance_mm : {0.01, 0.1}) {
            std::mt19937_64 random{17};
            Script script{kStartPulses};
            std::vector<Pulses4> points{kStartPulses};
            for (int i = 0; i < 150; ++i) {
                Pulses4 way{};
                for (std::size_t k = 0; k < kAxisCount; ++k) {
                    if ((axes >> k & 1U) != 0) way[k] = static_cast<std::int64_t>(random() % 161) - 80;
                }
                script.way(way, tolerance_mm);
                points.push_back(script.at());
            }
            script.end();
            std::vector<std::uint64_t> lines;
            const auto places = ticked(program_blocks(script.steps), limits, &lines);
            double worst_mm = 0.0;
            for (std::size_t t = 0; t < places.size(); ++t) {
                if (lines[t] == 0 || lines[t] >= points.size()) continue;
                worst_mm = std::max(worst_mm, off_chords_mm(limits, points, lines[t], places[t], 0));
            }
            EXPECT_LE(worst_mm, tolerance_mm + pulse_mm) << "axes " << axes << " P " << tolerance_mm;
        }
    }
}

// Round a corner at the travel's end the curve would swing out beyond it, by most of the tolerance.
TEST(RecordProgramMotion, NeverLeavesTheTravelOnItsWay) {
    const MachineLimits limits = machine_limits(Profile{});
    const std::int64_t top = limits.tick.soft_limits.most_pulses[kY];
    const auto highest_from = [&](std::int64_t height) {
        const Pulses4 start{6000, 6200, 100, height - 400};
        Script script{start};
        for (int i = 0; i < 10; ++i) {
            script.way({0, 0, 0, 400}, 0.5).way({300, 0, 0, 0}, 0.5);
            script.way({0, 0, 0, -400}, 0.5).way({-300, 0, 0, 0}, 0.5);
        }
        script.end();
        RecordProgram program(limits, std::make_shared<ScriptedSource>(script.steps), start);
        MotionBlock block;
        Pulses4 at = start;
        std::int64_t highest = 0;
        while (program.next(block)) {
            for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += block.delta_pulses[k];
            highest = std::max(highest, at[kY]);
        }
        EXPECT_EQ(at, script.at());
        return highest;
    };
    EXPECT_GT(highest_from(top - 2000), top - 2000) << "elsewhere it does";
    EXPECT_EQ(highest_from(top), top);
}

double seconds_of_ways(const std::vector<Pulses4>& ways, double tolerance_mm) {
    Script script{kStartPulses};
    for (const Pulses4& way : ways) script.way(way, tolerance_mm);
    script.end();
    double seconds = 0.0;
    for (const MotionBlock& block : program_blocks(script.steps)) {
        if (block.kind == BlockKind::path) seconds += block_seconds(block, 0);
    }
    return seconds;
}

// At sharp corners of four axes a curve through each end gains nothing over a stop there, and loses little.
TEST(RecordProgramMotion, HardlyEverLosesTimeByNotStopping) {
    for (const std::int64_t most : {20, 300, 3000}) {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            std::mt19937_64 random{seed};
            std::vector<Pulses4> ways;
            for (int i = 0; i < 30; ++i) {
                Pulses4 way{};
                for (auto& part : way)
                    part =
                        static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most + 1)) - most;
                ways.push_back(way);
            }
            const double exact_s = seconds_of_ways(ways, 0.0);
            const double tolerant_s = seconds_of_ways(ways, 0.05);
            EXPECT_LE(tolerant_s, exact_s * 1.03) << "most " << most << " seed " << seed;
        }
    }
}

// Of a long way, or many in a row, the ramps are as steep as of one way alone.
TEST(RecordProgramMotion, PassesEndsOnAStraightLineAsIfTheyWereNone) {
    const double alone_s = seconds_of_ways({Pulses4{-4000, 0, 2000, 1000}}, 0.0);
    for (const std::int64_t parts : {1, 2, 5, 20, 100}) {
        const std::vector<Pulses4> row(static_cast<std::size_t>(parts),
                                       Pulses4{-4000 / parts, 0, 2000 / parts, 1000 / parts});
        EXPECT_LE(seconds_of_ways(row, 0.01), 1.02 * alone_s) << parts;
        EXPECT_GE(seconds_of_ways(row, 0.01), 0.999 * alone_s) << parts;
    }
}

// Sooner than at the even speed sqrt(a r): along the diagonals both axes accelerate at once.
TEST(RecordProgramMotion, GoesRoundACircleOfShortWaysAtWhatTheAxesHave) {
    const MachineLimits limits = machine_limits(Profile{});
    const double radius_mm = 4.0;
    const double r1_scale = limits.axes[0].pulses_per_unit;
    const double y_scale = limits.axes[kY].pulses_per_unit;
    constexpr int kChords = 500;
    std::vector<Pulses4> ways;
    Pulses4 at{};
    for (int turn = 1; turn <= 3 * kChords; ++turn) {
        const double angle = 2.0 * 3.14159265358979 * turn / kChords;
        const Pulses4 to{round_to_pulse(radius_mm * r1_scale * (std::cos(angle) - 1.0)), 0, 0,
                         round_to_pulse(radius_mm * y_scale * std::sin(angle))};
        ways.push_back({to[0] - at[0], 0, 0, to[3] - at[3]});
        at = to;
    }
    const double accel_mm_s2 =
        std::min(limits.axes[0].accel_pps2 / r1_scale, limits.axes[kY].accel_pps2 / y_scale);
    const double speed_mm_s =
        std::min({std::sqrt(accel_mm_s2 * radius_mm), limits.axes[0].speed_pps / r1_scale,
                  limits.axes[kY].speed_pps / y_scale});
    const double least_s = 3.0 * 2.0 * 3.14159265358979 * radius_mm / speed_mm_s;
    EXPECT_LE(seconds_of_ways(ways, 0.01), least_s);
}

}  // namespace
}  // namespace psicarve::plan
