// SPDX-License-Identifier: GPL-3.0-or-later
// Rule 1 over several attempts at a job: each is judged, and what lies between them.
#include <gtest/gtest.h>

#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

TEST(PathOffence, ASecondAttemptAfterAStopCounts) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.approach().to_point(0, 1).set(Signal::spindle, false);
    machine.move(Axis::r1, 2000).move(Axis::r2, 2000);
    machine.approach().layer(0).finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
}

TEST(PathOffence, ASecondCarveOfTheJobIsJudgedLikeTheFirst) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.carve_job().move(Axis::r1, 2000).move(Axis::r2, 2000).carve_job();
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_EQ(report.points_visited, report.points_total);
    EXPECT_GT(report.carve_seconds, 0.0);
}

TEST(PathOffence, ASecondCarveAfterHomingIsJudgedLikeTheFirst) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.carve_job().move(Axis::r1, 2000).move(Axis::r2, 2000);
    machine.define_positions(machine.position).carve_job();
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_EQ(report.max_deviation_pulses, 0);
}

TEST(PathOffence, HomingAfterACompleteCarveKeepsIt) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.carve_job().define_positions(machine.position).move(Axis::r1, 100);
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_EQ(report.max_deviation_pulses, 0);
}

TEST(PathOffence, ASecondCarveThatEndsEarlyIsNamed) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.carve_job().move(Axis::r1, 2000).move(Axis::r2, 2000);
    machine.approach().to_point(0, 1).finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(first_of(report, 1).fault, "ends-early");
    EXPECT_EQ(report.points_visited, 2U);
}

TEST(PathOffence, ARetractionAfterAStopIsTheEndOfTheAttempt) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.approach().finish().move(Axis::r1, 2000).move(Axis::r2, 2000).carve_job();
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_LT(report.max_line_deviation_mm, 0.01);
}

TEST(PathOffence, AnAttemptThatIsNotFollowedByAnotherOnlyEndsEarly) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.approach().to_point(0, 1).finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(report.rules[0].offences, 1U);
    EXPECT_EQ(first_of(report, 1).fault, "ends-early");
    EXPECT_LT(report.max_line_deviation_mm, 0.01);
}

TEST(PathOffence, AnEndedAttemptsOffencesDoNotCountWhenAnotherFollows) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.approach().to_point(0, 1).move(Axis::y, 3).move(Axis::y, -3).to_point(0, 2).finish();
    const VerifyReport alone = verified(job, machine);
    EXPECT_EQ(alone.rules[0].offences, 2U);
    EXPECT_EQ(first_of(alone, 1).fault, "height");
    machine.move(Axis::r1, 2000).move(Axis::r2, 2000).carve_job();
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
}

// On a flank outwards psi stands at the point's angle before the head has come out all the way.
TEST(PathOffence, StandingOnThePathWhereAnAttemptEndedIsNone) {
    const SampleJob job(Profile{}, 1, 21, Joining::continuous,
                        [](double angle, double) { return angle < 3.5 ? 8.0 : 10.0; });
    for (const bool cuts_deeper : {false, true}) {
        PerfectMachine machine(job);
        machine.approach().to_point(0, 1).to_point(0, 2).line({0, 798, 160, 0});
        machine.set(Signal::spindle, false).define_positions(machine.position);
        machine.move(Axis::r1, 2000);
        if (cuts_deeper) machine.move(Axis::r2, -1);
        machine.move(Axis::r2, 2000).carve_job();
        const VerifyReport report = verified(job, machine);
        EXPECT_EQ(report.ok, !cuts_deeper) << report_text(report);
        EXPECT_EQ(report.max_deviation_pulses, cuts_deeper ? 3 : 0);
    }
}

/// R2 comes to a flank outwards of 800 pulses in 8 of psi. It ends 40 short of the point's radius, where the
/// line has come to the point's angle.
SampleJob job_with_a_cliff() {
    return SampleJob(Profile{}, 1, 401, Joining::continuous,
                     [](double angle, double) { return angle < 3.5 ? 8.0 : 10.0; });
}
void go_to_the_cliffs_edge(PerfectMachine& machine) {
    machine.approach();
    for (std::uint32_t step = 1; step <= 45; ++step) machine.to_point(0, step);
    machine.line({0, 760, 8, 0});
}

// While the heads go out, R1 first, and where R2 goes on from a short way out.
TEST(PathOffence, RetractingFromAFlankOutwardsIsNone) {
    const SampleJob job = job_with_a_cliff();
    for (const std::int64_t outward_pulses : {400, 20}) {
        for (const bool cuts_deeper : {false, true}) {
            PerfectMachine machine(job);
            go_to_the_cliffs_edge(machine);
            machine.move(Axis::r1, outward_pulses);
            if (cuts_deeper) machine.move(Axis::r2, -300);
            machine.move(Axis::r2, outward_pulses).set(Signal::spindle, false);
            machine.move(Axis::r1, 10).move(Axis::r2, 10);
            const VerifyReport report = verified(job, machine);
            EXPECT_EQ(report.rules[0].offences > 1, cuts_deeper) << report_text(report);
            EXPECT_EQ(first_of(report, 1).fault == "ends-early", !cuts_deeper) << report_text(report);
        }
    }
}

TEST(PathOffence, AHeadOnASteepLineIsNotBlamedForTheOtherOne) {
    const SampleJob job = job_with_a_cliff();
    PerfectMachine machine(job);
    go_to_the_cliffs_edge(machine);
    machine.move(Axis::r1, 40).move(Axis::r1, -40).to_point(0, 46).to_point(0, 47).finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(first_of(report, 1).fault, "off-the-line") << report_text(report);
    EXPECT_EQ(first_of(report, 1).axis, Axis::r1);
    EXPECT_EQ(report.rules[0].offences, 2U) << report_text(report);
}

TEST(PathOffence, AStrayCutBetweenTwoAttemptsStillCounts) {
    const SampleJob job = wavy_job(Joining::continuous, 1);
    PerfectMachine machine(job);
    machine.approach().finish().move(Axis::r1, -430).move(Axis::r1, 430).carve_job();
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(first_of(report, 1).fault, "too-deep");
    EXPECT_EQ(report.rules[0].offences, 1U);
}

}  // namespace
}  // namespace psicarve::verify
