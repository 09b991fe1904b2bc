// SPDX-License-Identifier: GPL-3.0-or-later
// Rule 1 broken along a spiral.
#include <gtest/gtest.h>

#include <cstdint>

#include "tests/hmi/verify/pulse_faults.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

TEST(SpiralOffence, ALostPulseOfYAlongASpiralIsNamed) {
    const SampleJob job = wavy_job(Joining::spiral);
    PerfectMachine machine(job);
    machine.carve_job();
    drop_pulse(machine, Axis::y, 100 + 40);  // half-way up row 1
    const VerifyReport report = verified(job, machine);
    const Offence& offence = first_of(report, 1);
    EXPECT_EQ(offence.fault, "point-missed") << offence.sentence;
    EXPECT_EQ(offence.axis, Axis::y);
    EXPECT_EQ(offence.layer, 1U);
    EXPECT_EQ(offence.point, 11U);
    EXPECT_EQ(offence.allowed - offence.measured, 1.0);
    EXPECT_EQ(report.points_visited, 21U + 1U + 10U);
}

TEST(SpiralOffence, YThatRunsAheadOfTheTableAlongASpiralIsNamed) {
    const SampleJob job = wavy_job(Joining::spiral, 4, 5);
    PerfectMachine machine(job);
    machine.approach().layer(0).to_point(1, 1).move(Axis::y, 6);
    for (std::uint32_t step = 2; step < 5; ++step) machine.to_point(1, step);
    machine.layer(2).layer(3).finish();
    const VerifyReport report = verified(job, machine);
    const Offence& offence = first_of(report, 1);
    EXPECT_EQ(offence.fault, "height") << offence.sentence;
    EXPECT_EQ(offence.axis, Axis::y);
    EXPECT_EQ(offence.layer, 1U);
    EXPECT_EQ(offence.point, 2U);
    EXPECT_EQ(report.rules[0].offences, 1U);
    EXPECT_EQ(report.points_visited, report.points_total);
}

}  // namespace
}  // namespace psicarve::verify
