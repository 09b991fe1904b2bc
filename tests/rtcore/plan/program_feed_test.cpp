// SPDX-License-Identifier: GPL-3.0-or-later
// How long programs take whose ways are hardly longer than a pulse, or shorter.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "shared/base/units.hpp"
#include "tests/rtcore/plan/program_blocks.hpp"

namespace psicarve::plan {
namespace {

using cycle::BlockKind;
using test::block_seconds;
using test::kStartPulses;
using test::ScriptedSource;

constexpr double kPulsesPerMm = 400.0;
constexpr double kTolerance_mm = 0.01;

/// A program as its records have it: places that are no whole pulses.
class UnroundedScript {
public:
    explicit UnroundedScript(double feed_mm_min) : pace_s_(60.0 / feed_mm_min) {}

    /// Of r1 and y, from the start.
    void to(double r1_mm, double y_mm) {
        const double length_mm = std::hypot(r1_mm - at_mm_[0], y_mm - at_mm_[1]);
        to(r1_mm, y_mm, length_mm * pace_s_);
    }
    void to(double r1_mm, double y_mm, double seconds) {
        at_mm_ = {r1_mm, y_mm};
        ProgramStep& step = add();
        step.kind = MotionKind::way;
        step.target_pulses = kStartPulses;
        for (const std::size_t i : {0U, 1U}) {
            const std::size_t k = i == 0 ? 0 : kY;
            const double pulses = static_cast<double>(kStartPulses[k]) + at_mm_[i] * kPulsesPerMm;
            step.target_pulses[k] = round_to_pulse(pulses);
            step.rounded_off_pulses[k] = pulses - static_cast<double>(step.target_pulses[k]);
        }
        step.seconds = seconds;
        step.tolerance_mm = kTolerance_mm;
    }
    /// By point-by-point comparison, of r1.
    void stepped_to(double r1_mm) {
        to(r1_mm, at_mm_[1]);
        steps_.back().tolerance_mm = 0.0;
        steps_.back().shape = cycle::OrderShape::stepped;
        steps_.back().stepped_axes = 1;
    }
    /// Of all ways but those.
    double seconds() {
        add().kind = MotionKind::end;
        double seconds = 0.0;
        RecordProgram program(machine_limits(Profile{}), std::make_shared<ScriptedSource>(steps_),
                              kStartPulses);
        cycle::MotionBlock block;
        // It waits now and then where steps come to nothing.
        while (program.next(block) || program.is_waiting()) {
            if (!program.is_waiting() && block.kind == BlockKind::path) seconds += block_seconds(block, 0);
        }
        return seconds;
    }

private:
    ProgramStep& add() {
        ProgramStep& step = steps_.emplace_back();
        step.line = step.sequence = steps_.size();
        return step;
    }
    double pace_s_;
    std::array<double, 2> at_mm_{};
    std::vector<ProgramStep> steps_;
};

double line_seconds(double step_mm, double length_mm, double feed_mm_min, double angle_deg = 0.0) {
    UnroundedScript script{feed_mm_min};
    const double angle_rad = angle_deg * kPi / 180.0;
    const auto steps = static_cast<int>(std::lround(length_mm / step_mm));
    for (int i = 1; i <= steps; ++i)
        script.to(-std::cos(angle_rad) * step_mm * i, std::sin(angle_rad) * step_mm * i);
    return script.seconds();
}

// Against lines whose points lie far apart: the rounding of points may cost a twentieth, and gives nothing.
TEST(ProgramFeed, DoesNotDependOnHowShortTheWaysAre) {
    for (const double angle_deg : {0.0, 10.0, 22.5, 45.0, 90.0}) {
        const double long_ways_s = line_seconds(0.1, 9.0, 300.0, angle_deg);
        EXPECT_NEAR(long_ways_s, 1.8, 0.05);
        for (const double step_mm : {0.0001, 0.0005, 0.0009, 0.0015, 0.00225, 0.0025, 0.004, 0.0065}) {
            const double taken_s = line_seconds(step_mm, 9.0, 300.0, angle_deg);
            EXPECT_GE(taken_s, 0.998 * long_ways_s) << step_mm << " mm, " << angle_deg << " degrees";
            EXPECT_LE(taken_s, 1.055 * long_ways_s) << step_mm << " mm, " << angle_deg << " degrees";
        }
    }
}

// Along an axis no rounding makes a way longer.
TEST(ProgramFeed, IsKeptExactlyAlongAnAxis) {
    const double long_ways_s = line_seconds(0.1, 9.0, 300.0);
    for (const double step_mm : {0.0005, 0.0009, 0.0015, 0.00225, 0.004})
        EXPECT_NEAR(line_seconds(step_mm, 9.0, 300.0), long_ways_s, 0.001 * long_ways_s) << step_mm;
}

TEST(ProgramFeed, IsThatOfTheCircleWhoseChordsAreShort) {
    for (const double chord_mm : {0.001, 0.002, 0.003, 0.005, 0.02}) {
        UnroundedScript script{240.0};
        const double r_mm = 5.0;
        const auto chords = static_cast<int>(2.0 * kPi * r_mm / chord_mm);
        for (int i = 1; i <= chords; ++i) {
            const double turn_rad = 2.0 * kPi * i / chords;
            script.to(r_mm * (std::cos(turn_rad) - 1.0), r_mm * std::sin(turn_rad));
        }
        const double circle_s = 2.0 * kPi * r_mm / 4.0;
        const double taken_s = script.seconds();
        EXPECT_GE(taken_s, circle_s) << chord_mm;
        EXPECT_LE(taken_s, 1.05 * circle_s) << chord_mm;
    }
}

// What the staircase behind it is longer makes a slow way no quicker.
TEST(ProgramFeed, OfASlowWayIsNotThatOfTheQuickStaircaseBehindIt) {
    constexpr double kStep_mm = 0.0009;
    constexpr double kSlow_mm_s = 0.01;
    const auto seconds = [&](int slow_steps) {
        UnroundedScript script{900.0};
        for (int i = 1; i <= slow_steps; ++i) script.to(-kStep_mm * i, 0.0, kStep_mm / kSlow_mm_s);
        const double begin_mm = kStep_mm * slow_steps;
        for (int i = 1; i <= 2000; ++i) script.to(-begin_mm - 0.7 * kStep_mm * i, 0.7 * kStep_mm * i);
        return script.seconds();
    };
    const double slow_s = seconds(18) - seconds(0);
    const double asked_s = 18 * kStep_mm / kSlow_mm_s;
    EXPECT_GE(slow_s, 0.98 * asked_s);
    EXPECT_LE(slow_s, 1.1 * asked_s);
}

// What rounding made longer in ways from rest to rest is no part of the next staircase.
TEST(ProgramFeed, BehindSteppedWaysIsThatOfTheWay) {
    for (const double way_mm : {0.08, 0.16, 0.27, 0.5}) {
        UnroundedScript alone{300.0};
        alone.to(-way_mm, 0.0);
        UnroundedScript script{300.0};
        for (int i = 0; i < 300; ++i) script.stepped_to(i % 2 == 0 ? -0.6 / kPulsesPerMm : 0.0);
        script.to(-way_mm, 0.0);
        EXPECT_DOUBLE_EQ(script.seconds(), alone.seconds()) << way_mm;
    }
}

// What a way without a pulse asks for is no other way's.
TEST(ProgramFeed, OfAWayWithoutAPulseIsNotThatOfTheNext) {
    UnroundedScript alone{300.0};
    alone.to(-20.0, 0.0);
    const double alone_s = alone.seconds();
    UnroundedScript script{300.0};
    script.to(-0.0004, 0.0, 600.0);
    script.to(-20.0, 0.0);
    EXPECT_NEAR(script.seconds(), alone_s, 0.001 * alone_s);
}

// As far as that can be: a way without a length has no pace.
TEST(ProgramFeed, OfAPulseThatHardlyAWayBringsAboutIsBounded) {
    UnroundedScript script{300.0};
    script.to(-0.5 / kPulsesPerMm + 1e-12, 0.0, 0.0);
    script.to(-0.5 / kPulsesPerMm - 1e-12, 0.0, 0.01);
    EXPECT_LE(script.seconds(), 41.0);
}

}  // namespace
}  // namespace psicarve::plan
