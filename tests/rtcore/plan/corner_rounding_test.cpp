// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of a program are rounded within its tolerance.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "rtcore/program/record_rules.hpp"
#include "tests/parameter_name.hpp"
#include "tests/rtcore/plan/corner_rig.hpp"

namespace psicarve::plan {
namespace {

using test::carved;
using test::CarvedProgram;
using test::WayScript;

struct Machine {
    const char* name;
    Profile profile;
};

Profile fine_profile() {
    Profile profile;
    profile.tick.period_us = 10;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) axis->pulses_per_mm = 2000;
    profile.psi.pulses_per_rev = 128'000;
    return profile;
}

/// No two axes alike.
Profile uneven_profile() {
    Profile profile = fine_profile();
    profile.r1.pulses_per_mm = 700;
    profile.r2.accel_mm_s2 = 350.0;
    profile.y.pulses_per_mm = 160;
    profile.y.speed_mm_s = 25.0;
    profile.psi.speed_deg_s = 90.0;
    profile.psi.accel_deg_s2 = 400.0;
    return profile;
}

Profile backlash_profile() {
    Profile profile = fine_profile();
    profile.r1.backlash_mm = 0.02;
    profile.psi.backlash_deg = 0.1;
    return profile;
}

std::vector<Machine> machines() {
    return {{"built_in", Profile{}},
            {"fine", fine_profile()},
            {"uneven", uneven_profile()},
            {"backlash", backlash_profile()}};
}

Pulses4 start_of(const MachineLimits& limits) {
    Pulses4 start{};
    start[kPsi] = 100;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}, kY})
        start[k] = round_to_pulse(15.0 * limits.axes[k].pulses_per_unit);
    return start;
}

/// Corners at random: ways of up to `most_mm` along each of the axes (bit by axis), every other one along one
/// alone.
WayScript random_corners(const MachineLimits& limits, std::uint64_t seed, unsigned axes, double most_mm,
                         double tolerance_mm) {
    std::mt19937_64 random{seed};
    WayScript program{start_of(limits)};
    const Pulses4 start = program.script.at();
    for (int i = 0; i < 30; ++i) {
        Pulses4 way{};
        const std::size_t alone = random() % kAxisCount;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if ((axes >> k & 1U) == 0 || (i % 2 == 0 && k != alone)) continue;
            const double per_mm = k == kPsi ? 1.0 / (15.0 * rad_from_pulses(1, limits.pulses_per_rev))
                                            : limits.axes[k].pulses_per_unit;
            const double share = static_cast<double>(random() % 2001) / 1000.0 - 1.0;
            way[k] = round_to_pulse(share * most_mm * per_mm);
            const auto off = static_cast<double>(program.script.at()[k] + way[k] - start[k]);
            if (k != kPsi && std::abs(off) > 4.0 * per_mm) way[k] = -way[k];
        }
        if (way != Pulses4{}) program.way(way, tolerance_mm);
    }
    program.script.end();
    return program;
}

double coarsest_pulse_mm(const MachineLimits& limits, const Pulses4& at) {
    double pulse_mm = 0.0;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}, kY})
        pulse_mm = std::max(pulse_mm, 1.0 / limits.axes[k].pulses_per_unit);
    for (std::size_t head = 0; head < kHeads; ++head) {
        const double radius_mm =
            static_cast<double>(at[head]) / limits.axes[head].pulses_per_unit + limits.tip_offset_mm[head];
        pulse_mm = std::max(pulse_mm, radius_mm * rad_from_pulses(1, limits.pulses_per_rev));
    }
    return pulse_mm;
}

class RandomCorners : public ::testing::TestWithParam<Machine> {};

TEST_P(RandomCorners, StayWithinTheToleranceOfThePolylineAtEveryIteration) {
    const MachineLimits limits = machine_limits(GetParam().profile);
    for (const unsigned axes : {0b1001U, 0b0101U, 0b1100U, 0b0011U, 0b1111U}) {
        for (const double tolerance_mm : {0.002, 0.02, 0.1, 0.5}) {
            for (const double most_mm : {0.1, 3.0}) {
                const WayScript program = random_corners(limits, 3 + axes, axes, most_mm, tolerance_mm);
                const CarvedProgram done = carved(limits, program.script, start_of(limits));
                double worst = 0.0;
                for (const CarvedProgram::Place& place : done.places) {
                    const double allowed_mm = tolerance_mm + coarsest_pulse_mm(limits, place.at);
                    for (std::size_t head = 0; head < kHeads; ++head) {
                        const double off_mm =
                            test::off_polyline_mm(limits, program.points, place.line, place.at, head);
                        worst = std::max(worst, off_mm / allowed_mm);
                    }
                }
                EXPECT_LE(worst, 1.0) << "axes " << axes << " P " << tolerance_mm << " ways " << most_mm;
                ASSERT_FALSE(done.rests.empty());
                EXPECT_EQ(done.rests.back(), program.script.at());
                for (const Pulses4& rest : done.rests)
                    EXPECT_NE(std::find(program.points.begin(), program.points.end(), rest),
                              program.points.end());
            }
        }
    }
}

// The line that is shown changes there.
TEST_P(RandomCorners, PassEachPointWithinTheTolerance) {
    const MachineLimits limits = machine_limits(GetParam().profile);
    for (const unsigned axes : {0b1001U, 0b0101U, 0b1111U}) {
        for (const double tolerance_mm : {0.02, 0.2}) {
            const WayScript program = random_corners(limits, 5 + axes, axes, 2.0, tolerance_mm);
            const CarvedProgram done = carved(limits, program.script, start_of(limits));
            for (std::size_t i = 1; i < done.places.size(); ++i) {
                const std::uint64_t line = done.places[i - 1].line;
                if (done.places[i].line == line) continue;
                ASSERT_EQ(done.places[i].line, line + 1);
                const std::vector<Pulses4> point{program.points[line], program.points[line]};
                for (std::size_t head = 0; head < kHeads; ++head) {
                    const double off_mm =
                        test::off_polyline_mm(limits, point, 1, done.places[i - 1].at, head);
                    EXPECT_LE(off_mm, tolerance_mm + 1.5 * coarsest_pulse_mm(limits, program.points[line]))
                        << "line " << line << " axes " << axes << " P " << tolerance_mm;
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(On, RandomCorners, ::testing::ValuesIn(machines()),
                         [](const auto& one) { return std::string{one.param.name}; });

WayScript zigzag(double tolerance_mm) {
    WayScript program{{6000, 6200, 100, 3000}};
    for (int i = 0; i < 30; ++i)
        program.way({i % 2 == 0 ? 400 : -400, 0, 0, 0}, tolerance_mm).way({0, 0, 0, 100}, tolerance_mm);
    program.script.end();
    return program;
}

TEST(CornerRounding, OfAZigzagMakesNoRestAndTakesLessTime) {
    const MachineLimits limits = machine_limits(Profile{});
    const auto of = [&limits](double tolerance_mm) {
        const WayScript program = zigzag(tolerance_mm);
        return carved(limits, program.script, program.points.front());
    };
    const CarvedProgram exact = of(0.0);
    const CarvedProgram rounded = of(0.05);

    EXPECT_EQ(exact.rests.size(), 60U);
    EXPECT_EQ(rounded.rests.size(), 1U);
    // 7.2 s where each end was passed within half a pulse.
    EXPECT_LT(rounded.seconds, 6.2);
}

/// Ways at random that the core accepts, both heads as close as they may be.
WayScript close_heads(const Profile& profile, const MachineLimits& limits, std::uint64_t seed,
                      double tolerance_mm) {
    const program::RecordRules rules{profile};
    const auto clear = static_cast<std::int64_t>(std::ceil(profile.head_clearance_mm * 400.0 / 2.0));
    WayScript program{{clear, clear, 100, 3000}};
    std::mt19937_64 random{seed};
    for (int i = 0; i < 200; ++i) {
        MotionRecord record{};
        record.kind = MotionKind::way;
        record.line = 1;
        record.axes = 0xF;
        const auto up_to = [&random](std::uint64_t most) {
            return static_cast<std::int64_t>(random() % most);
        };
        Pulses4 to = program.script.at();
        const std::size_t alone = i % 2 == 0 ? kY : static_cast<std::size_t>(up_to(2));
        if (alone == kY) {
            to[kY] += up_to(2001) - 1000;
        } else if (up_to(2) == 0) {
            to[alone] = 2 * clear - to[1 - alone];
        } else {
            to[0] += up_to(301) - 150;
            to[1] += up_to(301) - 150;
        }
        for (std::size_t k = 0; k < kAxisCount; ++k)
            record.target[k] = k == kPsi ? static_cast<double>(to[k]) * 360.0 / 6400.0
                                         : static_cast<double>(to[k]) / limits.axes[k].pulses_per_unit;
        ProgramStep step;
        if (!rules.judge(record, program.script.at(), step).is_none()) continue;
        Pulses4 way{};
        for (std::size_t k = 0; k < kAxisCount; ++k) way[k] = step.target_pulses[k] - program.script.at()[k];
        if (way != Pulses4{}) program.way(way, tolerance_mm);
    }
    program.script.end();
    return program;
}

TEST(CornerRounding, KeepsTipsApartAndHeadsOutOfTheCore) {
    Profile profile;
    profile.core_radius_mm = 0.9;
    const MachineLimits limits = machine_limits(profile);
    const cycle::SoftLimits& soft = limits.tick.soft_limits;
    for (std::uint64_t seed = 1; seed <= 140; ++seed) {
        const WayScript program = close_heads(profile, limits, seed, seed % 2 == 0 ? 0.05 : 0.3);
        ASSERT_GT(program.points.size(), 50U);
        for (const CarvedProgram::Place& place :
             carved(limits, program.script, program.points.front()).places) {
            const double sum_mm = soft.mm_per_pulse[0] * static_cast<double>(place.at[0]) +
                                  soft.mm_per_pulse[1] * static_cast<double>(place.at[1]);
            ASSERT_GE(sum_mm, soft.least_sum_mm - 1e-9) << "seed " << seed << " line " << place.line;
            for (std::size_t head = 0; head < kHeads; ++head)
                ASSERT_GE(place.at[head], soft.core_pulses[head]) << "seed " << seed;
        }
    }
}

TEST(CornerRounding, ReachesTheEndBeforeARestToThePulseAndMakesNoOther) {
    const MachineLimits limits = machine_limits(Profile{});
    WayScript program{{6000, 6200, 100, 3000}};
    std::vector<Pulses4> rests;
    for (int rest = 0; rest < 4; ++rest) {
        program.way({400, 0, 0, 0}, 0.05).way({0, 0, 0, 400}, 0.05).way({-400, 0, 0, 0}, 0.05);
        rests.push_back(program.script.at());
        if (rest == 0) program.script.dwell(0.01);
        if (rest == 1) program.script.spindle(true);
        if (rest == 2) program.script.stop();
    }
    program.script.end();
    EXPECT_EQ(carved(limits, program.script, program.points.front()).rests, rests);
}

// As in a job: exactly on the line, at rest in each end.
TEST(CornerRounding, LeavesExactWaysAsTheyAre) {
    const MachineLimits limits = machine_limits(Profile{});
    const WayScript program = random_corners(limits, 8, 0xF, 1.0, 0.0);
    const CarvedProgram done = carved(limits, program.script, program.points.front());
    EXPECT_EQ(done.rests, (std::vector<Pulses4>{program.points.begin() + 1, program.points.end()}));
    for (const CarvedProgram::Place& place : done.places) {
        const std::vector<Pulses4> way{program.points[place.line - 1], program.points[place.line]};
        for (std::size_t head = 0; head < kHeads; ++head)
            EXPECT_LE(test::off_polyline_mm(limits, way, 1, place.at, head),
                      coarsest_pulse_mm(limits, place.at));
    }
}

}  // namespace
}  // namespace psicarve::plan
