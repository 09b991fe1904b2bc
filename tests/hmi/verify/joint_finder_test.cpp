// SPDX-License-Identifier: GPL-3.0-or-later
// Where the planner "angle" may let speeds jump though rule 1 follows no points: in dry runs, and in layers
// that are not judged.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "shared/base/units.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

constexpr std::int64_t kLine_pulses = 160;  ///< of psi, from point to point

/// Psi may jump by 400 pulses a second, and gets no other speed within many pulses.
SampleJob slow_job() {
    SampleJob job = wavy_job();
    job.profile.job.planner = Planner::angle;
    job.profile.psi.start_stop_deg_s = 22.5;
    job.profile.psi.accel_deg_s2 = 225.0;
    return job;
}

/// As of a dry run that was asked for.
VerifyReport verified_dry(const SampleJob& job, const PerfectMachine& machine) {
    auto sut = Verifier::make_for(job.view(), job.profile, {.carves = false}).value();
    EXPECT_TRUE(sut.begin(machine.start).has_value());
    sut.feed(machine.events);
    return sut.finish();
}

class DryJointsOfLines : public testing::Test {
protected:
    DryJointsOfLines() {
        for (const Axis axis : kAllAxes) machine_.set(enable_of(axis), true);
    }
    /// To rest in the first layer, at its first point or so far from it.
    void approach(std::int64_t psi_pulses = 0) {
        machine_.move(Axis::psi, psi_pulses);
        machine_.move(Axis::y, job_.view().y_pulses(0, 0)).wait(10 * kNsPerMs);
    }
    void turn(std::int64_t pulses, std::int64_t pulses_per_s) {
        machine_.iteration_ns = kNsPerS / pulses_per_s;
        machine_.move(Axis::psi, pulses);
    }
    void expect_offence() {
        const VerifyReport report = verified_dry(job_, machine_);
        EXPECT_EQ(first_of(report, 3).axis, Axis::psi);
        EXPECT_EQ(first_of(report, 3).fault, "acceleration");
    }

    SampleJob job_ = slow_job();
    PerfectMachine machine_{job_};
};

TEST_F(DryJointsOfLines, AreWhereTheJobsPointsAre) {
    approach();
    turn(kLine_pulses, 400);
    turn(kLine_pulses, 800);
    turn(kLine_pulses, 400);
    EXPECT_EQ(verified_dry(job_, machine_).rules[2].offences, 0U);
}

TEST_F(DryJointsOfLines, AreThereAgainAfterAHold) {
    approach();
    turn(kLine_pulses / 2, 400);
    machine_.wait(kNsPerS);
    turn(kLine_pulses / 2, 400);
    turn(kLine_pulses, 800);
    turn(kLine_pulses, 400);
    EXPECT_EQ(verified_dry(job_, machine_).rules[2].offences, 0U);
}

TEST_F(DryJointsOfLines, AreNoneWhereACarvingWasAskedFor) {
    approach();
    turn(kLine_pulses, 400);
    turn(kLine_pulses, 800);
    turn(kLine_pulses, 400);
    EXPECT_GT(verified(job_, machine_).rules[2].offences, 0U) << "turned by hand";
}

TEST_F(DryJointsOfLines, AreNoneOfAWayBack) {
    approach(3 * kLine_pulses);
    turn(-kLine_pulses, 400);
    turn(-kLine_pulses, 800);
    turn(-kLine_pulses, 400);
    expect_offence();
}

TEST_F(DryJointsOfLines, AreNowhereElse) {
    approach();
    turn(kLine_pulses / 2, 400);
    turn(kLine_pulses, 800);
    turn(kLine_pulses, 400);
    expect_offence();
}

TEST_F(DryJointsOfLines, LetSpeedsJumpByNoMoreThanTheStartStopSpeed) {
    approach();
    turn(kLine_pulses, 400);
    turn(kLine_pulses, 1'400);
    turn(kLine_pulses, 1'000);
    turn(kLine_pulses, 600);
    turn(kLine_pulses, 200);
    expect_offence();
}

TEST_F(DryJointsOfLines, AreNoneOfAWayThatBeginsElsewhere) {
    approach(-kLine_pulses / 4);
    turn(kLine_pulses / 4 + kLine_pulses, 400);
    turn(kLine_pulses, 800);
    turn(kLine_pulses, 400);
    expect_offence();
}

TEST_F(DryJointsOfLines, AreNoneBetweenLayers) {
    machine_.move(Axis::y, job_.view().y_pulses(0, 0) + 1).wait(kNsPerS);
    turn(kLine_pulses, 400);
    turn(kLine_pulses, 800);
    turn(kLine_pulses, 400);
    expect_offence();
}

TEST_F(DryJointsOfLines, EndWhereAHeadMoves) {
    approach();
    turn(kLine_pulses / 2, 400);
    machine_.move(Axis::r1, 1);
    turn(kLine_pulses / 2, 400);
    turn(kLine_pulses, 800);
    turn(kLine_pulses, 400);
    expect_offence();
}

TEST_F(DryJointsOfLines, AreNoneWithTheSpindleOn) {
    approach();
    machine_.set(Signal::spindle, true).wait(kNsPerS);
    turn(kLine_pulses, 400);
    turn(kLine_pulses, 800);
    turn(kLine_pulses, 400);
    expect_offence();
}

/// Of one line: R1's 1600 pulses, or none, beside psi's 160; no line behind it moves a head.
SampleJob flank_job(bool has_flank) {
    SampleJob job(Profile{}, 4, 21, Joining::continuous,
                  [&](double angle, double) { return has_flank && angle < 0.01 ? 8.0 : 12.0; });
    job.profile.job.planner = Planner::angle;
    job.profile.psi.accel_deg_s2 = 14.0;
    return job;
}

// Psi's last pulse of a flank is half a pulse's time before its end: 10 ms.
TEST(DryJoints, OfAFlankAreBetweenThePulsesAroundItsEnd) {
    for (const bool has_flank : {true, false}) {
        const SampleJob job = flank_job(has_flank);
        PerfectMachine machine(job);
        machine.move(Axis::y, job.view().y_pulses(0, 0)).wait(10 * kNsPerMs);
        const auto turn = [&](std::int64_t pulses_per_s) {
            machine.iteration_ns = kNsPerS / pulses_per_s;
            machine.move(Axis::psi, kLine_pulses);
        };
        turn(50);
        machine.wait(-10 * kNsPerMs);
        turn(450);
        turn(50);
        EXPECT_EQ(verified_dry(job, machine).rules[2].offences, has_flank ? 0U : 1U);
    }
}

/// Only the second layer is judged; in the first one psi is faster for a line from `begin` pulses on.
VerifyReport with_first_layer_left_out(std::int64_t begin_pulses) {
    const SampleJob job = slow_job();
    PerfectMachine machine(job);
    machine.approach();
    const std::size_t first = machine.events.size();
    machine.layer(0);
    const std::int64_t begin_ns =
        machine.events[first].time_ns + begin_pulses * PerfectMachine::kIteration_ns;
    const std::int64_t end_ns = begin_ns + kLine_pulses * PerfectMachine::kIteration_ns;
    machine.link_to(1).layer(1).finish();
    for (TraceEvent& event : machine.events) {
        const std::int64_t within_ns = std::clamp(event.time_ns, begin_ns, end_ns) - begin_ns;
        event.time_ns -= within_ns / 2;
    }
    return verified(job, machine, {1, 1});
}

TEST(JointsOfLayersThatAreNotJudged, AreKnown) {
    EXPECT_EQ(with_first_layer_left_out(3 * kLine_pulses).rules[2].offences, 0U);
}

TEST(JointsOfLayersThatAreNotJudged, AreNotBetweenPoints) {
    EXPECT_NE(with_first_layer_left_out(3 * kLine_pulses + kLine_pulses / 2).rules[2].offences, 0U);
}

}  // namespace
}  // namespace psicarve::verify
