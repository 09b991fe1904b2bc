// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/asked_carving.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "shared/machine/command.hpp"
#include "shared/machine/recorded_start.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

constexpr std::uint64_t kPointShift = 20;
constexpr std::uint64_t kLayersShift = 32;

FlightRecord record_of(RecordKind kind, std::uint16_t code = 0, std::uint64_t value = 0) {
    FlightRecord record{};
    record.kind = kind;
    record.code = code;
    record.value = static_cast<std::int64_t>(value);
    record.answer = static_cast<std::uint32_t>(AnswerKind::done);
    return record;
}
FlightRecord command(CommandKind kind, std::uint64_t value = 0) {
    return record_of(RecordKind::command, static_cast<std::uint16_t>(kind), value);
}
FlightRecord start(std::uint64_t layer, std::uint64_t layers = 0, std::uint64_t point_number = 0) {
    return command(CommandKind::start, layer | layers << kLayersShift | point_number << kPointShift);
}
FlightRecord carve() {
    return command(CommandKind::start_interpolation);
}
FlightRecord ready() {
    return record_of(RecordKind::state_change, static_cast<std::uint16_t>(MachineState::ready));
}

// Four layers of twenty-one points.
class AskedCarvingOf : public testing::Test {
protected:
    std::optional<AskedCarving> asked(const std::vector<FlightRecord>& records) const {
        return asked_carving(job_.view(), records);
    }
    const SampleJob job_ = wavy_job();
};

TEST_F(AskedCarvingOf, NothingWhereNothingWasCarved) {
    EXPECT_FALSE(asked({}));
    EXPECT_FALSE(asked({ready(), start(0), ready()})) << "it was never told to carve";
    EXPECT_FALSE(asked({start(0), carve(), ready()})) << "a replay begins behind it";
    EXPECT_FALSE(asked({ready(), start(0), carve(), ready(), command(CommandKind::program), ready()}));
    EXPECT_FALSE(asked({ready(), start(0), carve(), ready(), record_of(RecordKind::job), ready()}));
    auto refused = start(0);
    refused.answer = static_cast<std::uint32_t>(AnswerKind::refused);
    EXPECT_FALSE(asked({ready(), refused, carve()}));
}

TEST_F(AskedCarvingOf, NumbersThatNoCoreTakesAreNoStart) {
    EXPECT_FALSE(asked({ready(), start(4), carve(), ready()}));
    EXPECT_FALSE(asked({ready(), start(1, 0, 21), carve(), ready()}))
        << "a layer's last point begins nothing";
    EXPECT_FALSE(asked({ready(), start(1, 0, 4000), carve(), ready()}));
}

TEST_F(AskedCarvingOf, OneStartIsWhatItSays) {
    const auto whole = asked({ready(), start(0), carve(), ready()});
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->layers.first, 0U);
    EXPECT_EQ(whole->layers.count, 0U);
    EXPECT_FALSE(whole->layers.first_point);
    EXPECT_FALSE(whole->may_end_early);
    EXPECT_TRUE(whole->carves);
    const auto part = asked({record_of(RecordKind::job), start(1, 2, 8), carve(), ready()});
    ASSERT_TRUE(part);
    EXPECT_EQ(part->layers.first, 1U);
    EXPECT_EQ(part->layers.count, 2U);
    EXPECT_EQ(part->layers.first_point, 7U);
}

TEST_F(AskedCarvingOf, OneThatWasStoppedMayEndEarly) {
    for (const RecordKind kind : {RecordKind::stop, RecordKind::emergency_stop, RecordKind::alarm}) {
        const auto cut = asked({ready(), start(0), carve(), record_of(kind), ready()});
        ASSERT_TRUE(cut);
        EXPECT_TRUE(cut->may_end_early) << static_cast<int>(kind);
    }
    EXPECT_TRUE(asked({ready(), start(0), carve()})->may_end_early) << "the recording ends";
    EXPECT_FALSE(asked({ready(), start(0), carve(), ready(), record_of(RecordKind::stop)})->may_end_early);
}

TEST_F(AskedCarvingOf, StartsThatGoOnCountTogether) {
    const auto both = asked(
        {ready(), start(1), carve(), record_of(RecordKind::stop), ready(), start(2, 2, 6), carve(), ready()});
    ASSERT_TRUE(both);
    EXPECT_EQ(both->layers.first, 1U);
    EXPECT_EQ(both->layers.count, 3U);
    EXPECT_FALSE(both->may_end_early) << "the last one came to its end";
    const auto apart = asked({ready(), start(0, 1), carve(), ready(), start(2), carve(), ready()});
    ASSERT_TRUE(apart);
    EXPECT_EQ(apart->layers.first, 2U) << "layer 1 was never asked for";
    const auto anew = asked({ready(), start(1), carve(), ready(), start(1, 1), carve(), ready()});
    ASSERT_TRUE(anew);
    EXPECT_EQ(anew->layers.count, 1U);
}

TEST_F(AskedCarvingOf, ALayerDoneAgainTakesNothingOutOfWhatWasAskedForBefore) {
    for (const bool was_cut : {false, true}) {
        std::vector<FlightRecord> records{ready(), start(0), carve()};
        if (was_cut) records.push_back(record_of(RecordKind::stop));
        for (const FlightRecord& next : {ready(), start(1, 1), carve(), ready()}) records.push_back(next);
        const auto both = asked(records);
        ASSERT_TRUE(both);
        EXPECT_EQ(both->layers.first, 0U);
        EXPECT_EQ(both->layers.count, 4U);
        EXPECT_TRUE(both->may_end_early) << "the last one ended before the first would have";
    }
}

TEST_F(AskedCarvingOf, OneThatWasStoppedHasCarvedWhatItsStatusSays) {
    const std::vector<FlightRecord> cut{ready(), start(1, 0, 8), carve(), record_of(RecordKind::stop),
                                        ready()};
    EXPECT_EQ(asked_carving(job_.view(), cut, 21 + 7 + 5)->least_points, 5U);
    EXPECT_EQ(asked_carving(job_.view(), cut)->least_points, 0U) << "not known";
    const std::vector<FlightRecord> whole{ready(), start(1), carve(), ready()};
    EXPECT_EQ(asked_carving(job_.view(), whole, 84)->least_points, 0U);
    EXPECT_TRUE(asked_carving(job_.view(), whole, 84)->ends_there);
}

TEST_F(AskedCarvingOf, ItsPointsAreOfTheStartThatTheStatusIsOf) {
    const std::vector<FlightRecord> called_off{ready(), start(0), carve(), record_of(RecordKind::stop),
                                               ready(), start(3), ready()};
    EXPECT_EQ(asked_carving(job_.view(), called_off, 3 * 21 + 1)->least_points, 0U)
        << "they are those before the layer that was to be carved next";
}

TEST_F(AskedCarvingOf, DryRunsCountAlone) {
    const auto dry = command(CommandKind::start, kRecordedDryRun | 1U);
    const auto alone = asked({ready(), dry, carve(), ready()});
    ASSERT_TRUE(alone);
    EXPECT_FALSE(alone->carves);
    for (const bool is_first : {true, false}) {
        const auto both = asked({ready(), is_first ? dry : start(2), carve(), ready(),
                                 is_first ? start(2) : dry, carve(), ready()});
        ASSERT_TRUE(both);
        EXPECT_TRUE(both->carves);
        EXPECT_EQ(both->layers.first, 2U);
    }
}

// The rest of the job is no breach; a breach on the way is one.
TEST(JudgedAsAsked, AsFarAsItWent) {
    const SampleJob job = wavy_job();
    for (const bool is_wrong : {false, true}) {
        PerfectMachine machine{job};
        machine.approach().layer(0).link_to(1);
        if (is_wrong) machine.move(Axis::r1, -60).move(Axis::r1, 60);
        machine.to_point(1, 1).to_point(1, 2).finish();
        auto sut = Verifier::make_for(job.view(), job.profile, {{}, true, true});
        ASSERT_TRUE(sut);
        EXPECT_TRUE(sut->begin(machine.start).has_value());
        sut->feed(machine.events);
        const VerifyReport report = sut->finish();
        EXPECT_EQ(report.ok, !is_wrong) << report_text(report);
        EXPECT_TRUE(report.is_cut);
        EXPECT_FALSE(verified(job, machine).ok);
    }
}

VerifyReport judged_as(const SampleJob& job, const PerfectMachine& machine, const AskedCarving& asked) {
    auto sut = Verifier::make_for(job.view(), job.profile, asked);
    EXPECT_TRUE(sut);
    EXPECT_TRUE(sut->begin(machine.start).has_value());
    sut->feed(machine.events);
    return sut->finish();
}

// A trace of something else is none that was cut short.
TEST(JudgedAsAsked, NotLessThanTheMachineIsKnownToHaveCarved) {
    const SampleJob job = wavy_job();
    PerfectMachine carved{job};
    carved.approach().layer(0).finish();
    EXPECT_TRUE(judged_as(job, carved, {.may_end_early = true}).ok);
    EXPECT_TRUE(judged_as(job, carved, {.may_end_early = true, .least_points = 21}).ok);
    const VerifyReport less = judged_as(job, carved, {.may_end_early = true, .least_points = 22});
    EXPECT_FALSE(less.ok);
    EXPECT_EQ(first_of(less, 1).fault, "ends-early");
    PerfectMachine nothing{job};
    nothing.move(Axis::r1, 500);
    const VerifyReport none = judged_as(job, nothing, {.may_end_early = true});
    EXPECT_FALSE(none.ok);
    EXPECT_EQ(first_of(none, 1).fault, "no-carving");
}

TEST(JudgedAsAsked, ADryRunMovesNothingWithTheSpindleOn) {
    const SampleJob job = wavy_job();
    PerfectMachine dry{job};
    for (const Axis axis : kAllAxes) dry.set(enable_of(axis), true);
    dry.move(Axis::r1, 24000).move(Axis::r2, 24000).move(Axis::psi, 400);
    const VerifyReport right = judged_as(job, dry, {.carves = false});
    EXPECT_TRUE(right.ok) << report_text(right);
    EXPECT_FALSE(right.rules[0].judged);
    PerfectMachine carving{job};
    carving.approach().layer(0).finish();
    const VerifyReport wrong = judged_as(job, carving, {.carves = false});
    EXPECT_FALSE(wrong.ok);
    EXPECT_EQ(first_of(wrong, 1).fault, "dry-run-carves");
}

// The recorded starts asked for no more: what comes behind is judged as behind a whole job.
TEST(JudgedAsAsked, BehindTheLastLayerNoHeadGoesIn) {
    const SampleJob job = wavy_job();
    PerfectMachine machine{job};
    machine.approach().layer(0);
    machine.move(Axis::r1, -150).move(Axis::r1, 150).finish();
    EXPECT_TRUE(judged_as(job, machine, {.layers = {0, 1}}).ok) << "other layers may follow";
    const VerifyReport report = judged_as(job, machine, {.layers = {0, 1}, .ends_there = true});
    EXPECT_FALSE(report.ok);
    EXPECT_EQ(first_of(report, 1).fault, "too-deep");
}

}  // namespace
}  // namespace psicarve::verify
