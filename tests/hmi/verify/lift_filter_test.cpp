// SPDX-License-Identifier: GPL-3.0-or-later
// What a held machine does with its heads is no path, and what only looks like it is one.
#include <gtest/gtest.h>

#include <cmath>

#include "shared/base/units.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

constexpr std::int64_t kRest_ns = 12'000'000;
constexpr std::uint32_t kCrest = 10;
constexpr std::uint32_t kPoints = 21;

Profile machine_that(bool lifts) {
    Profile profile;
    profile.job.lifts_on_hold = lifts;
    return profile;
}

/// A round body but for one point, where both heads stand further out.
SampleJob crested_job(const Profile& profile, double crest_mm) {
    const double crest_rad = rad_from_pulses(
        point_angle_pulses(kCrest, profile.psi.pulses_per_rev / 2, kPoints), profile.psi.pulses_per_rev);
    return SampleJob(profile, 1, kPoints, Joining::continuous, [=](double angle_rad, double) {
        const double off_rad = std::remainder(angle_rad - crest_rad, kPi);
        return std::abs(off_rad) < 1e-6 ? 8.0 + crest_mm : 8.0;
    });
}

/// Table first, then the heads, out and back again, with rests as long as a hold's.
VerifyReport carved_slowly(const Profile& profile, double crest_mm) {
    const SampleJob job = crested_job(profile, crest_mm);
    PerfectMachine machine(job);
    machine.approach();
    for (std::uint32_t step = 1; step < kCrest; ++step) machine.to_point(0, step);
    const auto out = pulses_from_mm(crest_mm, profile.r1.pulses_per_mm);
    machine.move(Axis::psi, job.view().psi_pulses(0, kCrest) - machine.position[index_of(Axis::psi)]);
    machine.wait(kRest_ns).line({out, out, 0, 0});
    machine.wait(kRest_ns).line({-out, -out, 0, 0}).wait(kRest_ns);
    for (std::uint32_t step = kCrest + 1; step < kPoints; ++step) machine.to_point(0, step);
    machine.finish();
    return verified(job, machine);
}

TEST(LiftFilter, APointOnACrestIsSeenHoweverSlowlyItIsPassed) {
    EXPECT_TRUE(carved_slowly(machine_that(false), 0.0025).ok);
    EXPECT_TRUE(carved_slowly(machine_that(true), 0.0025).ok) << "one pulse is no lift";
    EXPECT_TRUE(carved_slowly(machine_that(false), 0.0075).ok) << "a machine that does not lift";
}

VerifyReport held_on_the_way(const Profile& profile, const std::array<std::int64_t, kAxisCount>& out) {
    const SampleJob job = crested_job(profile, 0.0);
    PerfectMachine machine(job);
    machine.approach();
    for (std::uint32_t step = 1; step < 5; ++step) machine.to_point(0, step);
    std::array<std::int64_t, kAxisCount> back{};
    for (std::size_t k = 0; k < kAxisCount; ++k) back[k] = -out[k];
    machine.wait(kRest_ns).line(out).wait(kRest_ns).line(back).wait(kRest_ns);
    for (std::uint32_t step = 5; step < kPoints; ++step) machine.to_point(0, step);
    machine.finish();
    return verified(job, machine);
}

TEST(LiftFilter, ALiftIsNoPathOnAMachineThatLifts) {
    EXPECT_TRUE(held_on_the_way(machine_that(true), {800, 800, 0, 0}).ok);
    EXPECT_EQ(first_of(held_on_the_way(machine_that(false), {800, 800, 0, 0}), 1).fault, "off-the-line");
}

// Slowly, the path itself goes out from a rest: what follows may be a lift all the same.
TEST(LiftFilter, ALiftBeginsBehindASlowPulseOutwards) {
    const Profile profile = machine_that(true);
    const SampleJob job = crested_job(profile, 0.0025);
    PerfectMachine machine(job);
    machine.approach();
    for (std::uint32_t step = 1; step < kCrest; ++step) machine.to_point(0, step);
    machine.move(Axis::psi, job.view().psi_pulses(0, kCrest) - machine.position[index_of(Axis::psi)]);
    machine.wait(kRest_ns).line({1, 1, 0, 0}).wait(kRest_ns);
    machine.line({800, 800, 0, 0}).wait(kRest_ns).line({-800, -800, 0, 0}).wait(kRest_ns);
    for (std::uint32_t step = kCrest + 1; step < kPoints; ++step) machine.to_point(0, step);
    machine.finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
}

/// Heads that come back from a lift are stopped on the way, and retract.
VerifyReport stopped_on_the_way_back(const Profile& profile, std::int64_t back_pulses) {
    const SampleJob job = crested_job(profile, 0.0);
    PerfectMachine machine(job);
    machine.approach();
    for (std::uint32_t step = 1; step < 5; ++step) machine.to_point(0, step);
    machine.wait(kRest_ns).line({800, 800, 0, 0}).wait(kRest_ns);
    machine.line({-back_pulses, -back_pulses, 0, 0}).wait(kRest_ns).line({800, 800, 0, 0});
    machine.set(Signal::spindle, false).line({100, 100, 50, 0});
    return verified(job, machine);
}

TEST(LiftFilter, ALiftThatAStopEndsIsNoPathEither) {
    for (const std::int64_t back_pulses : {10, 400, 799}) {
        const VerifyReport stopped = stopped_on_the_way_back(machine_that(true), back_pulses);
        EXPECT_EQ(stopped.rules[0].offences, 1U) << report_text(stopped);
        EXPECT_EQ(first_of(stopped, 1).fault, "ends-early");
        EXPECT_LT(stopped.max_line_deviation_mm, 0.01);
    }
    EXPECT_EQ(first_of(stopped_on_the_way_back(machine_that(true), 820), 1).fault, "off-the-line")
        << "further in than the path came";
    EXPECT_EQ(first_of(stopped_on_the_way_back(machine_that(false), 400), 1).fault, "off-the-line");
}

TEST(LiftFilter, WhatElseLeavesThePathIsAnOffenceThereToo) {
    EXPECT_EQ(first_of(held_on_the_way(machine_that(true), {-80, -80, 0, 0}), 1).fault, "off-the-line")
        << "inwards";
    EXPECT_EQ(first_of(held_on_the_way(machine_that(true), {800, 0, 0, 0}), 1).fault, "off-the-line")
        << "one head";
    EXPECT_EQ(first_of(held_on_the_way(machine_that(true), {800, 800, 40, 0}), 1).fault, "off-the-line")
        << "with the table";
}

}  // namespace
}  // namespace psicarve::verify
