// SPDX-License-Identifier: GPL-3.0-or-later
// What is told of a carving that was stopped on its way.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "shared/base/units.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

constexpr AskedCarving kMayEndEarly{.layers = {}, .may_end_early = true};
constexpr double kEachPulse_s = 0.0025;

VerifyReport judged(const SampleJob& job, const PerfectMachine& machine,
                    const AskedCarving& asked = kMayEndEarly) {
    auto sut = Verifier::make_for(job.view(), job.profile, asked);
    EXPECT_TRUE(sut);
    EXPECT_TRUE(sut->begin(machine.start).has_value());
    sut->feed(machine.events);
    return sut->finish();
}

nlohmann::json json_of(const VerifyReport& report) {
    return nlohmann::json::parse(report_json(report));
}

/// A cylinder: each pulse of psi is an iteration of its own, 800 from point to point.
SampleJob cylinder(std::uint32_t layers = 2) {
    return SampleJob(Profile{}, layers, 5, Joining::continuous, [](double, double) { return 8.0; });
}

// A tip that goes out above a layer that is not begun leaves most of the blank there.
TEST(CutShort, IsToldOfCarvedCellsAlone) {
    const SampleJob job(Profile{}, 2, 33, Joining::continuous,
                        [](double angle, double layer) { return 8.0 - layer + 0.3 * std::cos(angle); });
    PerfectMachine machine(job);
    machine.approach().layer(0).link_to(1).to_point(1, 1).to_point(1, 2).line({0, 0, 60, 0});
    machine.finish();
    const VerifyReport report = judged(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_TRUE(report.is_cut);
    EXPECT_EQ(report.max_deviation_pulses, 0);
    EXPECT_EQ(json_of(report)["max_deviation_pulses"], 0);
    EXPECT_NE(report_text(report).find("largest deviation 0 pulses at points"), std::string::npos);
    EXPECT_GT(verified(job, machine).max_deviation_pulses, 100) << "the rest was asked for";
}

// What was carved counts, and so does what was cut too deep anywhere.
TEST(CutShort, IsToldOfTheDeviationOfWhatWasCarved) {
    const SampleJob job = cylinder();
    PerfectMachine shallow(job);
    shallow.approach().to_point(0, 1);
    shallow.line({30, 0, 800, 0}).line({-30, 0, 800, 0}).finish();
    EXPECT_EQ(judged(job, shallow).max_deviation_pulses, 30);
    PerfectMachine deep(job);
    deep.approach().to_point(0, 1).move(Axis::r1, -40).finish();
    EXPECT_EQ(judged(job, deep).max_deviation_pulses, 40);
}

TEST(CutShort, TookAsLongAsItCarved) {
    const SampleJob job = cylinder();
    PerfectMachine machine(job);
    machine.approach().wait(5 * kNsPerS).layer(0).link_to(1).to_point(1, 1).line({0, 0, 100, 0});
    machine.wait(5 * kNsPerS).finish();
    const VerifyReport report = judged(job, machine);
    ASSERT_TRUE(report.is_cut) << report_text(report);
    // A layer of four ways, Y's 80 pulses, a way and a bit: from the first pulse to the last.
    EXPECT_DOUBLE_EQ(report.carve_seconds, (4 * 800 + 80 + 800 + 100 - 1) * kEachPulse_s);
    EXPECT_DOUBLE_EQ(json_of(report)["carve_seconds"].get<double>(), report.carve_seconds);
    EXPECT_NE(report_text(report).find("  carved for 10.4475 s; pulses"), std::string::npos)
        << report_text(report);
    PerfectMachine at_point(job);
    at_point.approach().layer(0).finish();
    EXPECT_DOUBLE_EQ(judged(job, at_point).carve_seconds, (4 * 800 - 1) * kEachPulse_s);
}

TEST(CutShort, HasCarvedNothingWhereItOnlyWentIn) {
    const SampleJob job = cylinder();
    PerfectMachine machine(job);
    machine.approach().finish();
    const VerifyReport report = judged(job, machine);
    ASSERT_TRUE(report.is_cut) << report_text(report);
    EXPECT_EQ(report.carve_seconds, 0.0);
    EXPECT_EQ(json_of(report)["carve_seconds"], nullptr);
    EXPECT_NE(report_text(report).find("  nothing was carved; pulses"), std::string::npos)
        << report_text(report);
}

// As of a carving that came to its end.
TEST(CutShort, TookAsLongAsItsLastAttemptThatCarved) {
    const SampleJob job = cylinder();
    PerfectMachine machine(job);
    machine.approach().layer(0).link_to(1).to_point(1, 1).finish();
    machine.approach(1, 1).to_point(1, 2).finish();
    EXPECT_DOUBLE_EQ(judged(job, machine).carve_seconds, (800 - 1) * kEachPulse_s);
    machine.approach(1, 2).finish();
    const VerifyReport report = judged(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_DOUBLE_EQ(report.carve_seconds, (800 - 1) * kEachPulse_s);
    EXPECT_EQ(report.points_visited, 8U);
}

// It went in once more, and was stopped there: all was carved, and still is.
TEST(CutShort, BehindACompleteCarvingItTakesNothingBack) {
    const SampleJob job = cylinder();
    PerfectMachine machine(job);
    machine.carve_job();
    const double whole_s = verified(job, machine).carve_seconds;
    PerfectMachine half_a_way = machine;
    machine.approach(1).finish();
    half_a_way.approach(1).line({0, 0, 100, 0}).finish();
    for (PerfectMachine* const behind : {&machine, &half_a_way}) {
        for (const bool may_end_early : {true, false}) {
            const VerifyReport report = judged(job, *behind, {.layers = {}, .may_end_early = may_end_early});
            EXPECT_TRUE(report.ok) << report_text(report);
            EXPECT_EQ(report.points_visited, report.points_total);
            EXPECT_DOUBLE_EQ(report.carve_seconds, whole_s);
            EXPECT_NE(report_text(report).find("  carved in "), std::string::npos) << report_text(report);
        }
    }
}

// Beside the line all along: no point but the first was reached, but it carved.
TEST(CutShort, CarvedForAsLongAsItDidWhereNothingWasReached) {
    const SampleJob job = cylinder();
    PerfectMachine machine(job);
    machine.approach().move(Axis::r1, 100).line({0, 0, 3200, 0});
    machine.move(Axis::y, SampleJob::kLayerPulses).finish();
    for (const std::uint32_t count : {1U, 2U}) {
        const VerifyReport report = verified(job, machine, {0, count, {}});
        EXPECT_FALSE(report.ok);
        EXPECT_EQ(report.points_visited, 1U);
        // One layer's end is missed with the second pulse of Y; of two, Y is on its way to the next one.
        const int way_pulses = 100 + 3200 + (count == 1 ? 1 : 80);
        EXPECT_DOUBLE_EQ(report.carve_seconds, (way_pulses - 1) * kEachPulse_s);
        EXPECT_FALSE(report.is_complete);
        EXPECT_NE(report_text(report).find("  carved for "), std::string::npos) << report_text(report);
    }
}

TEST(CutShort, OfADryRunNothingWasCarved) {
    const SampleJob job = cylinder();
    PerfectMachine machine(job);
    machine.move(Axis::psi, 100);
    const VerifyReport report = judged(job, machine, {.carves = false});
    EXPECT_NE(report_text(report).find("  nothing was carved; pulses"), std::string::npos)
        << report_text(report);
}

}  // namespace
}  // namespace psicarve::verify
