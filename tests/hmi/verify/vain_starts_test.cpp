// SPDX-License-Identifier: GPL-3.0-or-later
// A start whose heads go in to the first point and are stopped there has carved nothing: what was carved
// before is still there, right or wrong.
#include <gtest/gtest.h>

#include <cstdint>

#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

constexpr std::uint32_t kVainPoints = 21;
constexpr std::uint32_t kVainLayers = 4;
constexpr std::int64_t kClear_pulses = 2000;

void go_out(PerfectMachine& machine) {
    machine.move(Axis::r1, kClear_pulses).move(Axis::r2, kClear_pulses);
}

void start_in_vain(PerfectMachine& machine) {
    go_out(machine);
    machine.approach().finish();
}

/// From the job's first point, or within its layer, to before this point of the layer behind.
void carve_on_to(PerfectMachine& machine, const SampleJob& job, std::uint32_t step, std::uint32_t end_step) {
    machine.approach(0, step);
    for (++step; step < kVainPoints; ++step) machine.to_point(0, step);
    if (!job.view().is_joint(1, 0)) machine.link_to(1);
    for (std::uint32_t next = 1; next < end_step; ++next) machine.to_point(1, next);
}

/// All of it, R1 once beside its line in the second layer.
PerfectMachine wrongly_carved(const SampleJob& job) {
    PerfectMachine machine(job);
    carve_on_to(machine, job, 0, 8);
    machine.line({0, 0, 40, 0}).move(Axis::r1, -60).move(Axis::r1, 60);
    for (std::uint32_t step = 8; step < kVainPoints; ++step) machine.to_point(1, step);
    for (std::uint32_t layer = 2; layer < kVainLayers; ++layer) {
        if (!job.view().is_joint(layer, 0)) machine.link_to(layer);
        machine.layer(layer);
    }
    return machine.finish();
}

VerifyReport as_far_as_it_went(const SampleJob& job, const PerfectMachine& machine) {
    auto sut = Verifier::make_for(job.view(), job.profile, {.layers = {}, .may_end_early = true});
    EXPECT_TRUE(sut);
    EXPECT_TRUE(sut->begin(machine.start));
    sut->feed(machine.events);
    return sut->finish();
}

class VainStarts : public ::testing::TestWithParam<Joining> {
protected:
    const SampleJob job = wavy_job(GetParam());
};

TEST_P(VainStarts, LeaveACompleteCarvingSo) {
    PerfectMachine machine(job);
    machine.carve_job();
    const VerifyReport alone = verified(job, machine);
    for (int vain = 0; vain < 2; ++vain) {
        start_in_vain(machine);
        const VerifyReport report = verified(job, machine);
        EXPECT_TRUE(report.ok) << report_text(report);
        EXPECT_TRUE(report.is_complete);
        EXPECT_EQ(report.points_visited, report.points_total);
        EXPECT_EQ(report.max_deviation_pulses, 0);
        EXPECT_DOUBLE_EQ(report.carve_seconds, alone.carve_seconds);
        EXPECT_DOUBLE_EQ(report.max_line_deviation_mm, alone.max_line_deviation_mm);
    }
}

TEST_P(VainStarts, HideNothingThatWasWrong) {
    PerfectMachine machine = wrongly_carved(job);
    const VerifyReport alone = verified(job, machine);
    ASSERT_EQ(first_of(alone, 1).fault, "off-the-line") << report_text(alone);
    start_in_vain(machine);
    const VerifyReport report = verified(job, machine);
    EXPECT_FALSE(report.ok);
    EXPECT_EQ(report.rules[0].offences, alone.rules[0].offences);
    EXPECT_EQ(first_of(report, 1).sentence, first_of(alone, 1).sentence);
    EXPECT_EQ(first_of(report, 1).time_ns, first_of(alone, 1).time_ns);
    EXPECT_DOUBLE_EQ(report.max_line_deviation_mm, alone.max_line_deviation_mm);
    // Carved anew from the first layer on, it does not count.
    go_out(machine);
    machine.carve_job();
    EXPECT_TRUE(verified(job, machine).ok) << report_text(verified(job, machine));
}

TEST_P(VainStarts, AreWrongWhereTheyCutTooDeep) {
    PerfectMachine machine(job);
    machine.carve_job();
    go_out(machine);
    machine.approach().move(Axis::r1, -300).move(Axis::r1, 300).finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_FALSE(report.ok);
    EXPECT_EQ(report.rules[0].offences, 2U) << "off its line and too deep\n" << report_text(report);
    EXPECT_EQ(first_of(report, 1).axis, Axis::r1);
}

TEST_P(VainStarts, LetCarvingGoOnWhereItWasStopped) {
    for (const bool is_whole : {true, false}) {
        PerfectMachine machine(job);
        machine.approach();
        for (std::uint32_t step = 1; step < 9; ++step) machine.to_point(0, step);
        machine.finish();
        start_in_vain(machine);
        go_out(machine);
        carve_on_to(machine, job, is_whole ? 8 : 10, kVainPoints);
        for (std::uint32_t layer = 2; layer < kVainLayers; ++layer) {
            if (!job.view().is_joint(layer, 0)) machine.link_to(layer);
            machine.layer(layer);
        }
        machine.finish();
        const VerifyReport report = verified(job, machine);
        EXPECT_EQ(report.ok, is_whole) << report_text(report);
        if (is_whole) continue;
        EXPECT_EQ(first_of(report, 1).fault, "points-left-out") << report_text(report);
    }
}

TEST_P(VainStarts, LeaveWhatARunCutShortCarved) {
    PerfectMachine machine(job);
    carve_on_to(machine, job, 0, 6);
    machine.finish();
    const VerifyReport alone = as_far_as_it_went(job, machine);
    const Offence end = first_of(verified(job, machine), 1);
    start_in_vain(machine);
    const VerifyReport report = as_far_as_it_went(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_TRUE(report.is_cut);
    EXPECT_EQ(report.points_visited, alone.points_visited);
    EXPECT_DOUBLE_EQ(report.carve_seconds, alone.carve_seconds);
    // Where the rest was asked for, it is missing from there on.
    const VerifyReport whole = verified(job, machine);
    EXPECT_EQ(first_of(whole, 1).sentence, end.sentence);
    EXPECT_EQ(first_of(whole, 1).layer, end.layer);
    EXPECT_EQ(first_of(whole, 1).point, end.point);
    EXPECT_EQ(whole.rules[0].offences, 1U) << report_text(whole);
}

// Psi turned: that is carving anew, and was not brought to its end.
TEST_P(VainStarts, AreNoneWhereTheFirstPointWasLeft) {
    for (const std::int64_t turned_pulses : {1, 40}) {
        for (const bool comes_back : {true, false}) {
            PerfectMachine machine(job);
            machine.carve_job();
            go_out(machine);
            machine.approach().move(Axis::psi, turned_pulses);
            if (comes_back) machine.move(Axis::psi, -turned_pulses);
            machine.finish();
            const VerifyReport report = verified(job, machine);
            EXPECT_FALSE(report.ok) << report_text(report);
            EXPECT_EQ(report.points_visited, 1U);
        }
    }
}

// The first point is missed by a pulse, and left.
TEST_P(VainStarts, AreNoneWhereTheFirstPointIsMissedAndLeft) {
    PerfectMachine machine(job);
    machine.carve_job();
    go_out(machine);
    machine.approach();
    machine.events.resize(machine.events.size() - 2);  // the last pulse inward of the head that goes in last
    machine.move(Axis::psi, 40).finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_FALSE(report.ok) << report_text(report);
    EXPECT_LT(report.points_visited, 2U);
}

TEST_P(VainStarts, CarveNothingWhereNothingWasCarved) {
    PerfectMachine machine(job);
    machine.approach().finish();
    const VerifyReport once = verified(job, machine);
    start_in_vain(machine);
    const VerifyReport twice = verified(job, machine);
    for (const VerifyReport* const report : {&once, &twice}) {
        EXPECT_EQ(first_of(*report, 1).fault, "ends-early") << report_text(*report);
        EXPECT_EQ(report->points_visited, 1U);
        EXPECT_EQ(report->carve_seconds, 0.0);
    }
}

// What went on from an attempt that went wrong is dropped with it.
TEST_P(VainStarts, CarvedAnewNothingOfBeforeCounts) {
    for (const bool goes_on : {false, true}) {
        PerfectMachine machine = wrongly_carved(job);
        go_out(machine);
        if (goes_on) {
            machine.approach(1);
            machine.to_point(1, 1).finish();
            go_out(machine);
        }
        machine.carve_job();
        const VerifyReport report = verified(job, machine);
        EXPECT_TRUE(report.ok) << report_text(report);
        EXPECT_EQ(report.rules[0].offences, 0U);
    }
}

// The same where another goes on from what it did.
TEST_P(VainStarts, WhatGoesOnFromAWrongAttemptIsWrong) {
    PerfectMachine machine = wrongly_carved(job);
    const VerifyReport alone = verified(job, machine);
    for (std::uint32_t layer = 3; layer > 1; --layer) {
        go_out(machine);
        machine.approach(layer);
        machine.layer(layer);
        for (std::uint32_t next = layer + 1; next < kVainLayers; ++next) {
            if (!job.view().is_joint(next, 0)) machine.link_to(next);
            machine.layer(next);
        }
        machine.finish();
        const VerifyReport report = verified(job, machine);
        EXPECT_FALSE(report.ok);
        EXPECT_EQ(report.rules[0].offences, alone.rules[0].offences) << report_text(report);
        EXPECT_EQ(first_of(report, 1).sentence, first_of(alone, 1).sentence);
    }
}

INSTANTIATE_TEST_SUITE_P(Verify, VainStarts,
                         ::testing::Values(Joining::continuous, Joining::zigzag, Joining::spiral),
                         [](const auto& named) { return "Case" + std::to_string(named.index); });

}  // namespace
}  // namespace psicarve::verify
