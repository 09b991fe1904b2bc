// SPDX-License-Identifier: GPL-3.0-or-later
// Which of rule 1's findings count: those of attempts, of retractions and of links.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "hmi/verify/attempt_ledger.hpp"
#include "hmi/verify/carve_times.hpp"
#include "hmi/verify/offence_log.hpp"
#include "hmi/verify/path/point_way.hpp"
#include "hmi/verify/path_offences.hpp"
#include "hmi/verify/pending_findings.hpp"
#include "tests/hmi/verify/perfect_machine.hpp"

namespace psicarve::verify {
namespace {

Offence at_time(Offence offence, std::int64_t time_ns) {
    offence.time_ns = time_ns;
    return offence;
}

class PathFindings : public testing::Test {
protected:
    void breach(std::int64_t time_ns) {
        if (log_.count(1, time_ns)) log_.describe(at_time(layers_left_out(3, 2), time_ns), {});
    }
    std::uint64_t offences() const { return log_.result(1).offences; }
    std::int64_t first_ns() const { return log_.result(1).first ? log_.result(1).first->time_ns : -1; }

    OffenceLog log_;
};

using AttemptLedgerTest = PathFindings;
using PendingFindingsTest = PathFindings;

TEST_F(AttemptLedgerTest, AnAttemptThatIsBegunAnewDropsTheOneBefore) {
    AttemptLedger ledger(log_);
    breach(1);
    ledger.begin_anew();
    breach(5);
    ledger.end();
    EXPECT_EQ(offences(), 1U) << "held back until it is known what follows";
    ledger.begin_anew();
    ledger.end();
    ledger.count_held();
    EXPECT_EQ(offences(), 1U);
    EXPECT_EQ(first_ns(), 1);
}

TEST_F(AttemptLedgerTest, AllThatGoOnFromOneAnotherCount) {
    AttemptLedger ledger(log_);
    ledger.begin_anew();
    breach(7);
    breach(8);
    ledger.end();
    EXPECT_EQ(offences(), 0U);
    ledger.go_on();
    breach(9);
    ledger.end();
    EXPECT_EQ(offences(), 0U) << "one that begins anew may drop them yet";
    ledger.count_held();
    EXPECT_EQ(offences(), 3U);
    EXPECT_EQ(first_ns(), 7);
}

TEST_F(AttemptLedgerTest, BegunAnewAllThatWentOnFromOneAnotherIsDropped) {
    AttemptLedger ledger(log_);
    ledger.begin_anew();
    breach(7);
    ledger.end();
    breach(8);
    ledger.go_on();
    breach(9);
    ledger.end();
    ledger.begin_anew();
    breach(10);
    ledger.end();
    ledger.count_held();
    EXPECT_EQ(offences(), 2U);
    EXPECT_EQ(first_ns(), 8) << "between two attempts";
}

TEST_F(AttemptLedgerTest, OfOneInVainCountsWhatItDidAndWhatWasBefore) {
    AttemptLedger ledger(log_);
    ledger.begin_anew();
    breach(7);
    ledger.end();
    const auto before = ledger.kept();
    ledger.begin_anew();
    breach(9);
    ledger.end_in_vain(before);
    EXPECT_EQ(offences(), 0U);
    ledger.count_held();
    EXPECT_EQ(offences(), 2U);
    EXPECT_EQ(first_ns(), 7);
}

TEST_F(AttemptLedgerTest, IsAsItWasWhereNothingHadBegun) {
    AttemptLedger ledger(log_);
    ledger.begin_anew();
    breach(7);
    ledger.end();
    const auto kept = ledger.kept();
    ledger.begin_anew();
    breach(9);
    ledger.restore(kept);
    EXPECT_EQ(offences(), 0U);
    ledger.count_held();
    EXPECT_EQ(offences(), 1U);
    EXPECT_EQ(first_ns(), 7);
}

PathLine::Distance distance(double mm) {
    return {mm, mm, false, mm, 0.5};
}

TEST_F(PendingFindingsTest, WhatIsFoundOnTheWayOutCountsIfItWasNoRetraction) {
    PendingFindings findings(log_);
    findings.set_outward(true);
    findings.note_distance(distance(2.0), 0.5);
    findings.stray(at_time(off_the_line(Axis::r1, distance(2.0)), 4), {});
    EXPECT_EQ(offences(), 0U);
    EXPECT_EQ(findings.line_extent().mm, 0.0);
    findings.set_outward(false);
    EXPECT_EQ(offences(), 1U);
    EXPECT_EQ(findings.line_extent().mm, 2.0);
    EXPECT_EQ(findings.line_extent().pulses, 4.0);
}

TEST_F(PendingFindingsTest, OfARetractionNothingCounts) {
    PendingFindings findings(log_);
    findings.set_outward(true);
    findings.note_distance(distance(2.0), 0.5);
    findings.stray(at_time(off_the_line(Axis::r1, distance(2.0)), 4), {});
    findings.forget_retraction();
    findings.set_outward(false);
    EXPECT_EQ(offences(), 0U);
    EXPECT_EQ(findings.line_extent().mm, 0.0);
}

TEST_F(PendingFindingsTest, AStayTooDeepIsToldOnce) {
    PendingFindings findings(log_);
    EXPECT_TRUE(findings.goes_too_deep(0, 3));
    EXPECT_FALSE(findings.goes_too_deep(0, 5));
    EXPECT_TRUE(findings.goes_too_deep(1, 1)) << "the other head's own";
    EXPECT_FALSE(findings.goes_too_deep(0, 0));
    EXPECT_TRUE(findings.goes_too_deep(0, 1));
}

TEST_F(PendingFindingsTest, ADepthOnALinkIsExcusedByTheAxisThatLostItsWay) {
    const auto counted = [this](Axis lost, std::int64_t deepest) {
        const std::uint64_t before = offences();
        PendingFindings findings(log_);
        EXPECT_TRUE(findings.goes_too_deep(0, 3));
        findings.add_depth(at_time(too_deep(Axis::r1, 100, 3, 2), 4), {}, 3, true);
        EXPECT_FALSE(findings.goes_too_deep(0, deepest));
        EXPECT_EQ(offences(), before) << "the link's end is awaited";
        findings.excuse_depths(lost);
        findings.count_depths();
        return offences() - before;
    };
    EXPECT_EQ(counted(Axis::r1, kNearPulses), 0U);
    EXPECT_EQ(counted(Axis::psi, kNearPulses), 0U);
    EXPECT_EQ(counted(Axis::y, kNearPulses), 0U);
    EXPECT_EQ(counted(Axis::r2, kNearPulses), 1U);
    EXPECT_EQ(counted(Axis::r1, kNearPulses + 1), 1U);
}

TEST_F(PendingFindingsTest, ADepthOffALinkCountsAtOnce) {
    PendingFindings findings(log_);
    EXPECT_TRUE(findings.goes_too_deep(0, 3));
    findings.add_depth(at_time(too_deep(Axis::r1, 100, 3, 2), 4), {}, 3, false);
    EXPECT_EQ(offences(), 1U);
}

TEST(CarveTimesTest, CountFromLeavingTheFirstPointToTheLast) {
    CarveTimes times;
    times.arrive(1'000);
    EXPECT_EQ(times.carve_seconds(), 0.0);
    times.leave(1'000'000'000);
    EXPECT_EQ(times.carve_seconds(), 0.0) << "nothing was reached since";
    times.leave(2'000'000'000);
    times.arrive(4'000'000'000);
    EXPECT_EQ(times.carve_seconds(), 3.0);
    EXPECT_EQ(times.arrived_ns(), 4'000'000'000);
    times.begin_anew();
    EXPECT_EQ(times.carve_seconds(), 0.0);
    const SampleJob job = wavy_job();
    EXPECT_TRUE(times.pass_times(job.view()).empty()) << "a job of one pass";
}

}  // namespace
}  // namespace psicarve::verify
