// SPDX-License-Identifier: GPL-3.0-or-later
// Carving that goes on from a layer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "tests/hmi/verify/pulse_faults.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

constexpr std::uint32_t kPointsALayer = 21;
constexpr std::uint32_t kLayers = 4;

/// Layers [first, end), from outside the blank, and the retraction.
void carve_range(PerfectMachine& machine, const SampleJob& job, std::uint32_t first, std::uint32_t end) {
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const std::int64_t way = job.view().max_radius_pulses(head) - machine.position[index_of(head)];
        machine.move(head, std::max<std::int64_t>(way, 0));
    }
    machine.approach(first).layer(first);
    for (std::uint32_t layer = first + 1; layer < end; ++layer) {
        if (!job.view().is_joint(layer, 0)) machine.link_to(layer);
        machine.layer(layer);
    }
    machine.finish();
}

/// Carves into a layer, and stops there.
void carve_into(PerfectMachine& machine, const SampleJob& job, std::uint32_t layer) {
    machine.approach();
    for (std::uint32_t before = 0; before < layer; ++before) {
        machine.layer(before);
        if (!job.view().is_joint(before + 1, 0)) machine.link_to(before + 1);
    }
    for (std::uint32_t step = 1; step < kPointsALayer / 2; ++step) machine.to_point(layer, step);
    machine.finish();
}

class Attempts : public ::testing::TestWithParam<Joining> {};

TEST_P(Attempts, FromALayerOnAreJudgedWhenThatWasAskedFor) {
    const SampleJob job = wavy_job(GetParam());
    PerfectMachine machine(job);
    carve_range(machine, job, 2, kLayers);
    const VerifyReport report = verified(job, machine, {2, 0});
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_EQ(report.points_visited, 2U * kPointsALayer);
    EXPECT_EQ(report.points_total, 2U * kPointsALayer);
    EXPECT_EQ(report.max_deviation_pulses, 0);
    EXPECT_NE(report_text(report).find("in layers 2 to 3"), std::string::npos);
}

TEST_P(Attempts, OfSomeLayersEndWithTheLastOfThem) {
    const SampleJob job = wavy_job(GetParam());
    PerfectMachine machine(job);
    carve_range(machine, job, 1, 2);
    EXPECT_TRUE(verified(job, machine, {1, 1}).ok) << report_text(verified(job, machine, {1, 1}));
    const VerifyReport longer = verified(job, machine, {1, 2});
    EXPECT_EQ(first_of(longer, 1).fault, "ends-early");
    EXPECT_EQ(longer.points_visited, kPointsALayer + (GetParam() == Joining::spiral ? 1U : 0U));
}

TEST_P(Attempts, AtOtherLayersAreNotJudged) {
    const SampleJob job = wavy_job(GetParam());
    PerfectMachine machine(job);
    carve_range(machine, job, 2, kLayers);
    carve_range(machine, job, 0, 2);
    EXPECT_TRUE(verified(job, machine, {2, 2}).ok) << report_text(verified(job, machine, {2, 2}));
    EXPECT_TRUE(verified(job, machine, {0, 2}).ok) << report_text(verified(job, machine, {0, 2}));
    EXPECT_FALSE(verified(job, machine).ok);
}

TEST_P(Attempts, ThatLeaveOutLayersSaySo) {
    const SampleJob job = wavy_job(GetParam());
    PerfectMachine machine(job);
    carve_range(machine, job, 2, kLayers);
    const VerifyReport report = verified(job, machine);
    EXPECT_FALSE(report.ok);
    EXPECT_EQ(report.rules[0].offences, 1U) << report_text(report);
    EXPECT_EQ(first_of(report, 1).fault, "layers-left-out");
    EXPECT_EQ(first_of(report, 1).measured, 2.0);
    EXPECT_EQ(first_of(report, 1).allowed, 0.0);
}

TEST_P(Attempts, GoOnWithTheLayerThatWasNotFinished) {
    const SampleJob job = wavy_job(GetParam());
    PerfectMachine machine(job);
    carve_into(machine, job, 2);
    carve_range(machine, job, 2, kLayers);
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_EQ(report.points_visited, report.points_total);
    EXPECT_EQ(report.max_deviation_pulses, 0);
}

TEST_P(Attempts, GoOnAfterHomingToo) {
    const SampleJob job = wavy_job(GetParam());
    PerfectMachine machine(job);
    carve_into(machine, job, 1);
    auto turned = machine.position;
    turned[index_of(Axis::psi)] += 2 * job.profile.psi.pulses_per_rev;
    machine.define_positions(turned);
    machine.position = turned;
    machine.position[index_of(Axis::psi)] -= 2 * job.profile.psi.pulses_per_rev;
    carve_range(machine, job, 1, kLayers);
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
}

TEST_P(Attempts, GoOnButNotBeyondWhatWasCarved) {
    const SampleJob job = wavy_job(GetParam());
    PerfectMachine machine(job);
    carve_into(machine, job, 2);
    carve_range(machine, job, 3, kLayers);
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(first_of(report, 1).fault, "layers-left-out");
    EXPECT_EQ(first_of(report, 1).measured, 3.0);
    EXPECT_EQ(first_of(report, 1).allowed, 2.0);
    EXPECT_LT(report.points_visited, report.points_total);
}

TEST_P(Attempts, AreAnsweredForByWhatGoesOnFromThem) {
    const SampleJob job = wavy_job(GetParam());
    PerfectMachine machine(job);
    carve_into(machine, job, 2);
    drop_pulse(machine, Axis::psi, 100);
    machine.position[index_of(Axis::psi)] -= 1;
    machine.move(Axis::psi, 1);
    carve_range(machine, job, 2, kLayers);
    EXPECT_GT(verified(job, machine).rules[0].offences, 0U);
    // Carved anew from the first layer, they are not.
    PerfectMachine again(job);
    carve_into(again, job, 2);
    drop_pulse(again, Axis::psi, 100);
    again.position[index_of(Axis::psi)] -= 1;
    again.move(Axis::psi, 1);
    carve_range(again, job, 0, kLayers);
    EXPECT_TRUE(verified(job, again).ok) << report_text(verified(job, again));
}

constexpr std::uint32_t kStopped = kPointsALayer / 2 - 1;  ///< step in which carve_into() ends

/// From a point within a layer to the job's end.
void carve_from(PerfectMachine& machine, const SampleJob& job, std::uint32_t first, std::uint32_t begin) {
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const std::int64_t way = job.view().max_radius_pulses(head) - machine.position[index_of(head)];
        machine.move(head, std::max<std::int64_t>(way, 0));
    }
    machine.approach(first, begin);
    for (std::uint32_t step = begin + 1; step < kPointsALayer; ++step) machine.to_point(first, step);
    for (std::uint32_t layer = first + 1; layer < kLayers; ++layer) {
        if (!job.view().is_joint(layer, 0)) machine.link_to(layer);
        machine.layer(layer);
    }
    machine.finish();
}

TEST_P(Attempts, FromAPointOnAreJudgedWhenThatWasAskedFor) {
    const SampleJob job = wavy_job(GetParam());
    for (const std::uint32_t layer : {0U, 1U, 3U}) {
        for (const std::uint32_t step : {1U, 2U, 9U, kPointsALayer - 2}) {
            PerfectMachine machine(job);
            carve_from(machine, job, layer, step);
            const LayerRange range{layer, 0, carved_point(GetParam(), kPointsALayer, layer, step)};
            const VerifyReport report = verified(job, machine, range);
            EXPECT_TRUE(report.ok) << layer << " " << step << "\n" << report_text(report);
            EXPECT_EQ(report.points_visited, (kLayers - layer) * kPointsALayer - step);
            EXPECT_EQ(report.max_deviation_pulses, 0);
            EXPECT_FALSE(verified(job, machine).ok) << "the points before it were not carved";
        }
    }
}

TEST_P(Attempts, ThatBeginOnePointLateSaySo) {
    const SampleJob job = wavy_job(GetParam());
    const LayerRange range{1, 0, carved_point(GetParam(), kPointsALayer, 1, 7)};
    PerfectMachine late(job);
    carve_from(late, job, 1, 8);
    const VerifyReport report = verified(job, late, range);
    EXPECT_EQ(first_of(report, 1).fault, "points-left-out") << report_text(report);
    EXPECT_EQ(first_of(report, 1).measured, 8.0);
    EXPECT_EQ(first_of(report, 1).allowed, 7.0);
    PerfectMachine early(job);
    carve_from(early, job, 1, 6);
    // What lies before is not judged; but amid a spiral no attempt begins.
    EXPECT_EQ(verified(job, early, range).ok, GetParam() != Joining::spiral);
}

TEST_P(Attempts, GoOnWithinTheLayer) {
    const SampleJob job = wavy_job(GetParam());
    for (const std::uint32_t step : {1U, kStopped - 1, kStopped}) {
        PerfectMachine machine(job);
        carve_into(machine, job, 2);
        carve_from(machine, job, 2, step);
        const VerifyReport report = verified(job, machine);
        EXPECT_TRUE(report.ok) << step << "\n" << report_text(report);
        EXPECT_EQ(report.points_visited, report.points_total);
        EXPECT_EQ(report.max_deviation_pulses, 0);
    }
}

TEST_P(Attempts, GoOnWithinTheLayerButNotBeyondWhatWasCarvedOfIt) {
    const SampleJob job = wavy_job(GetParam());
    PerfectMachine machine(job);
    carve_into(machine, job, 2);
    carve_from(machine, job, 2, kStopped + 1);
    const VerifyReport report = verified(job, machine);
    EXPECT_FALSE(report.ok);
    EXPECT_EQ(first_of(report, 1).fault, "points-left-out") << report_text(report);
    EXPECT_EQ(first_of(report, 1).allowed, kStopped + 1.0);
}

// The operator stops it where it waits: it was the wrong point.
TEST_P(Attempts, ThatOnlyGoInTakeNothingBack) {
    const SampleJob job = wavy_job(GetParam());
    PerfectMachine machine(job);
    carve_into(machine, job, 2);
    for (const Axis head : {Axis::r1, Axis::r2})
        machine.move(head, job.view().max_radius_pulses(head) - machine.position[index_of(head)]);
    machine.approach(2, 2).finish();
    carve_from(machine, job, 2, kStopped);
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_EQ(report.points_visited, report.points_total);
}

TEST_P(Attempts, ThatOnlyGoInLeaveNothingOut) {
    const SampleJob job = wavy_job(GetParam());
    for (const bool carves : {false, true}) {
        PerfectMachine machine(job);
        carve_into(machine, job, 2);
        for (const Axis head : {Axis::r1, Axis::r2})
            machine.move(head, job.view().max_radius_pulses(head) - machine.position[index_of(head)]);
        machine.approach(2, kStopped + 5);
        if (carves) machine.to_point(2, kStopped + 6);
        machine.finish();
        carve_from(machine, job, 2, kStopped);
        const VerifyReport report = verified(job, machine);
        EXPECT_EQ(report.ok, !carves) << report_text(report);
        if (carves) {
            EXPECT_EQ(first_of(report, 1).fault, "points-left-out");
            EXPECT_EQ(first_of(report, 1).point, carved_point(GetParam(), kPointsALayer, 2, kStopped + 5));
        }
    }
}

TEST_P(Attempts, WithinALayerAreJudgedAllAlong) {
    const SampleJob job = wavy_job(GetParam());
    PerfectMachine machine(job);
    carve_into(machine, job, 2);
    carve_from(machine, job, 2, kStopped);
    const std::size_t all = pulses_before(machine, Axis::psi);
    drop_pulse(machine, Axis::psi, all - 20);
    EXPECT_GT(verified(job, machine).rules[0].offences, 0U);
}

INSTANTIATE_TEST_SUITE_P(Verify, Attempts,
                         ::testing::Values(Joining::continuous, Joining::zigzag, Joining::spiral),
                         [](const auto& named) { return "Case" + std::to_string(named.index); });

/// Psi turns through all of the second layer before Y has come to its height: its points are missed at once.
TEST(LayerRange, MissedAtTheirEndAreNotMeasuredAgainstLinesBehindThem) {
    const SampleJob job = wavy_job(Joining::continuous);
    PerfectMachine machine(job);
    machine.approach().layer(0);
    machine.move(Axis::r1, 2000).move(Axis::r2, 2000);
    const std::int64_t layers_turn_pulses = job.profile.psi.pulses_per_rev / 2;
    machine.move(Axis::psi, layers_turn_pulses + 400).move(Axis::y, SampleJob::kLayerPulses);
    machine.move(Axis::psi, 1).finish();
    const VerifyReport report = verified(job, machine, {0, 2});
    EXPECT_EQ(report.points_visited, kPointsALayer);
    EXPECT_EQ(first_of(report, 1).fault, "point-missed");
    EXPECT_LT(report.max_line_deviation_mm, 0.1);
}

TEST(LayerRange, OfALayerThatTheJobHasNotAreRefused) {
    const SampleJob job = wavy_job();
    const auto refused = Verifier::make(job.view(), job.profile, {4, 0});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("none is 4"), std::string::npos) << refused.error().message;
}

TEST(LayerRange, OfAPointThatNoCarvingBeginsWithAreRefused) {
    const SampleJob zigzag = wavy_job(Joining::zigzag);
    for (const LayerRange& range :
         {LayerRange{1, 0, kPointsALayer}, LayerRange{1, 0, 0}, LayerRange{0, 0, kPointsALayer - 1}}) {
        const auto refused = Verifier::make(zigzag.view(), zigzag.profile, range);
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().message.find("21 points"), std::string::npos) << refused.error().message;
    }
}

}  // namespace
}  // namespace psicarve::verify
