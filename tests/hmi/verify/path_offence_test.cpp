// SPDX-License-Identifier: GPL-3.0-or-later
// Rule 1 broken in one way at a time: each is found and named.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/hmi/verify/pulse_faults.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

TEST(PathOffence, AMissingPulseIsNamedAtTheNextPoint) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.approach().to_point(0, 1).to_point(0, 2);
    const std::size_t pulse = pulses_before(machine, Axis::r1);
    for (std::uint32_t step = 3; step < 21; ++step) machine.to_point(0, step);
    machine.finish();
    drop_pulse(machine, Axis::r1, pulse);
    const VerifyReport report = verified(job, machine);
    const Offence& offence = first_of(report, 1);
    EXPECT_FALSE(report.ok);
    EXPECT_EQ(offence.fault, "point-missed") << offence.sentence;
    EXPECT_EQ(offence.axis, Axis::r1);
    EXPECT_EQ(offence.layer, 0U);
    EXPECT_EQ(offence.point, 3U);
    EXPECT_EQ(offence.allowed, job.view().r_left_pulses(0)[3]);
    EXPECT_EQ(std::abs(offence.measured - offence.allowed), 1.0);
    EXPECT_NE(offence.sentence.find("R1"), std::string::npos);
    EXPECT_NE(offence.sentence.find("layer 0 at point 3"), std::string::npos) << offence.sentence;
}

TEST(PathOffence, TheAxisThatLostAPulseIsNamedWhicheverItIs) {
    for (const Axis axis : {Axis::r1, Axis::r2, Axis::psi}) {
        for (const std::uint32_t from : {2U, 7U, 12U}) {
            const SampleJob job = wavy_job(Joining::continuous, 1);
            PerfectMachine machine(job);
            machine.approach();
            for (std::uint32_t step = 1; step <= from; ++step) machine.to_point(0, step);
            const std::size_t pulse = pulses_before(machine, axis);
            for (std::uint32_t step = from + 1; step < 21; ++step) machine.to_point(0, step);
            machine.finish();
            drop_pulse(machine, axis, pulse);
            const VerifyReport report = verified(job, machine);
            const Offence& offence = first_of(report, 1);
            EXPECT_EQ(offence.axis, axis) << offence.sentence;
            // A pulse of psi only shows where the radii change.
            EXPECT_GE(offence.point, from + 1) << offence.sentence;
            if (axis != Axis::psi) {
                EXPECT_EQ(offence.point, from + 1) << offence.sentence;
            }
            EXPECT_EQ(std::abs(offence.measured - offence.allowed), 1.0);
            EXPECT_NE(offence.sentence.find(" pulses expected"), std::string::npos) << offence.sentence;
        }
    }
}

TEST(PathOffence, APulseOfPsiThatARoundBodyHidesIsNamedAtTheEnd) {
    const SampleJob job(Profile{}, 1, 21, Joining::continuous, [](double, double) { return 8.0; });
    PerfectMachine machine(job);
    machine.carve_job();
    drop_pulse(machine, Axis::psi, 1000);
    const VerifyReport report = verified(job, machine);
    const Offence& offence = first_of(report, 1);
    EXPECT_EQ(offence.fault, "ends-early") << offence.sentence;
    EXPECT_EQ(offence.axis, Axis::psi);
    EXPECT_NE(offence.sentence.find("psi alone stood 1 pulse off"), std::string::npos) << offence.sentence;
}

TEST(PathOffence, AnExtraPulseLeavesItsDepthInTheSurface) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.approach().to_point(0, 1).to_point(0, 2).pulse(Axis::r2, false);
    ++machine.position[1];  // the machine does not know of it
    for (std::uint32_t step = 3; step < 21; ++step) machine.to_point(0, step);
    machine.finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(first_of(report, 1).fault, "point-missed");
    EXPECT_EQ(first_of(report, 1).axis, Axis::r2);
    EXPECT_EQ(first_of(report, 1).point, 3U);
    // 17 points passed; so the end is never reached.
    EXPECT_EQ(report.rules[0].offences, 18U);
    EXPECT_EQ(report.points_visited, 3U);
    EXPECT_EQ(report.max_deviation_pulses, 1);
}

TEST(PathOffence, AWrongDirectionLevelIsNamed) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.approach().to_point(0, 1);
    const std::size_t from = machine.events.size();
    machine.to_point(0, 2);
    const std::size_t to = machine.events.size();
    machine.to_point(0, 3).finish();
    for (std::size_t n = from; n < to; ++n) machine.events[n].levels ^= bit_of(Signal::r1_dir);
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(first_of(report, 1).axis, Axis::r1);
    EXPECT_EQ(first_of(report, 1).point, 2U);
}

TEST(PathOffence, PulsesThatComeTooEarlyLeaveTheStraightLine) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.approach();
    const std::int64_t radius = job.view().r_left_pulses(0)[1] - machine.position[0];
    ASSERT_GT(std::abs(radius), 12);  // more than tolerance and a pulse
    machine.move(Axis::r1, radius).to_point(0, 1).to_point(0, 2).finish();
    const VerifyReport report = verified(job, machine);
    const Offence& offence = first_of(report, 1);
    EXPECT_EQ(offence.fault, "off-the-line");
    EXPECT_EQ(offence.axis, Axis::r1);
    EXPECT_EQ(offence.point, 1U);
    EXPECT_GT(offence.measured, offence.allowed);
    EXPECT_EQ(offence.unit, "mm");
    EXPECT_EQ(report.points_visited, 3U);
}

TEST(PathOffence, PulsesSwappedInTimeWithinTheToleranceAreNone) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.approach();
    const std::int64_t sign = job.view().r_left_pulses(0)[1] > machine.position[0] ? 1 : -1;
    machine.move(Axis::r1, 2 * sign).layer(0);
    for (std::uint32_t layer = 1; layer < 4; ++layer) machine.link_to(layer).layer(layer);
    machine.finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
}

TEST(PathOffence, ASkippedPointIsNamed) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.approach();
    for (std::uint32_t step = 1; step < 21; ++step) {
        if (step != 7) machine.to_point(0, step);
    }
    machine.finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(report.points_visited, 20U);
    EXPECT_EQ(first_of(report, 1).point, 7U);
    EXPECT_FALSE(report.ok);
}

TEST(PathOffence, ADeeperLinkIsNamed) {
    const SampleJob job(Profile{}, 2, 21, Joining::continuous,
                        [](double, double layer) { return 7.0 + 0.5 * layer; });
    PerfectMachine machine(job);
    machine.approach().layer(0);
    // Up before out: at the next layer's height the heads still stand at this layer's radius.
    machine.move(Axis::y, 80).link_to(1).layer(1).finish();
    const VerifyReport report = verified(job, machine);
    const Offence& offence = first_of(report, 1);
    EXPECT_EQ(offence.fault, "too-deep");
    EXPECT_EQ(offence.axis, Axis::r1);
    EXPECT_EQ(offence.layer, 1U);
    EXPECT_EQ(offence.point, 0U);
    EXPECT_EQ(offence.measured, 2800.0);
    EXPECT_EQ(offence.allowed, 3000.0);
    EXPECT_EQ(report.max_deviation_pulses, 200);
}

TEST(PathOffence, AStrayCutAfterTheEndShowsInTheSurface) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.approach().layer(0).move(Axis::r1, -25).move(Axis::r1, 25).finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(first_of(report, 1).fault, "too-deep");
    EXPECT_EQ(first_of(report, 1).axis, Axis::r1);
    EXPECT_EQ(report.max_deviation_pulses, 25);
    EXPECT_FALSE(report.ok);
}

TEST(PathOffence, LayersInTheWrongOrderAreNamed) {
    const SampleJob job = wavy_job(Joining::zigzag);
    PerfectMachine machine(job);
    machine.approach().layer(0);
    for (const std::uint32_t layer : {2U, 1U, 3U}) {
        machine.move(Axis::r1, 1000).move(Axis::r2, 1000).link_to(layer).layer(layer);
    }
    machine.finish();
    const VerifyReport report = verified(job, machine);
    const Offence& offence = first_of(report, 1);
    EXPECT_EQ(offence.fault, "layer-order");
    EXPECT_EQ(offence.axis, Axis::y);
    EXPECT_EQ(offence.layer, 1U);
    EXPECT_EQ(offence.allowed, job.view().layer_heights_pulses()[1]);
    EXPECT_NE(offence.sentence.find("layer 2 where layer 1 is due"), std::string::npos) << offence.sentence;
    EXPECT_EQ(report.points_visited, 63U);  // layers 0, 2 and 3
}

TEST(PathOffence, AMissedFirstPointIsNamedAndTheRestIsJudged) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.approach().pulse(Axis::r1, false).layer(0).finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_GE(report.points_visited, 20U);

    PerfectMachine short_by_one(job);
    short_by_one.approach();
    drop_pulse(short_by_one, Axis::r1, 100);
    short_by_one.layer(0).finish();
    const VerifyReport shifted = verified(job, short_by_one);
    EXPECT_EQ(first_of(shifted, 1).fault, "point-missed");
    EXPECT_EQ(first_of(shifted, 1).axis, Axis::r1);
    EXPECT_EQ(first_of(shifted, 1).point, 0U);
    EXPECT_EQ(shifted.max_deviation_pulses, 1);
}

TEST(PathOffence, ATraceThatEndsEarlyIsNamedWithThePointItWasAt) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.approach().layer(0).link_to(1).to_point(1, 1).to_point(1, 2);
    const VerifyReport report = verified(job, machine);
    const Offence& offence = first_of(report, 1);
    EXPECT_FALSE(report.ok);
    EXPECT_EQ(offence.fault, "ends-early");
    EXPECT_EQ(offence.layer, 1U);
    EXPECT_EQ(offence.point, 3U);
    EXPECT_EQ(offence.measured, 24.0);
    EXPECT_EQ(offence.allowed, 84.0);
}

TEST(PathOffence, ATraceWithoutCarvingIsNamed) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.move(Axis::r1, -10);
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(first_of(report, 1).fault, "no-carving");
    EXPECT_FALSE(report.ok);
}

TEST(PathOffence, YThatLeavesItsLayerIsNamed) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.approach().to_point(0, 1).move(Axis::y, 3).move(Axis::y, -3).to_point(0, 2).finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(first_of(report, 1).fault, "height");
    EXPECT_EQ(first_of(report, 1).axis, Axis::y);
    EXPECT_EQ(report.points_visited, 3U);
}

TEST(PathOffence, PulsesOfOneInstantAreJudgedTogether) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.carve_job();
    // The same instants, each wire's change an event of its own.
    std::vector<TraceEvent> split;
    SignalWord levels = 0;
    for (const TraceEvent& event : machine.events) {
        for (SignalWord left = levels ^ event.levels; left != 0; left &= left - 1) {
            levels ^= left & (~left + 1);
            split.push_back(event);
            split.back().levels = levels;
        }
    }
    ASSERT_GT(split.size(), machine.events.size());
    machine.events = split;
    EXPECT_TRUE(verified(job, machine).ok);
}

TEST(PathOffence, AHeadThatGoesOutwardOnThePathIsNamedOncePsiGoesOn) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.approach().to_point(0, 1).move(Axis::r1, 40).to_point(0, 2).to_point(0, 3).finish();
    const VerifyReport report = verified(job, machine);
    const Offence& offence = first_of(report, 1);
    EXPECT_EQ(offence.fault, "off-the-line");
    EXPECT_EQ(offence.axis, Axis::r1);
    EXPECT_EQ(offence.point, 2U);
    EXPECT_GT(offence.measured, offence.allowed);
    EXPECT_GT(report.max_line_deviation_mm, 0.05);
}

TEST(PathOffence, WhatIsMeasuredBeyondALinesEndIsComparedWithWhatIsAllowedThere) {
    const SampleJob job(Profile{}, 1, 21, Joining::continuous,
                        [](double angle, double) { return angle < 0.01 ? 20.0 : 12.0; });
    PerfectMachine machine(job);
    machine.approach().move(Axis::r1, 20).layer(0).finish();
    const Offence offence = first_of(verified(job, machine), 1);
    EXPECT_EQ(offence.fault, "off-the-line");
    EXPECT_GT(offence.measured, offence.allowed);
}

}  // namespace
}  // namespace psicarve::verify
