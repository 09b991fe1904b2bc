// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/reporter.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <memory>
#include <optional>

#include "shared/machine/command.hpp"

namespace psicarve::cycle {
namespace {

struct ReporterRig {
    CycleConfig config;
    std::unique_ptr<CycleIo> io = std::make_unique<CycleIo>();
    TickClock clock{50'000};
    PulseStage pulses{config};
    Inputs inputs{config};
    Reporter sut{*io, clock, pulses, inputs};

    std::optional<Report> next() {
        Report report;
        if (!io->reports.pop_into(report)) return std::nullopt;
        return report;
    }
    Report answered(const Request& request, Verdict verdict) {
        sut.answer(request, verdict);
        return next().value();
    }
};

Request request_of(RequestKind kind, std::uint64_t value = 0) {
    Request request{};
    request.kind = kind;
    request.value = value;
    request.sequence = 42;
    return request;
}

TEST(Reporter, TellsTickLevelsAndPositionsOfTheMoment) {
    ReporterRig rig;
    rig.clock.advance(9);
    rig.pulses.set_spindle(true);
    rig.pulses.set_position(kY, -5);
    rig.sut.report(RecordKind::home_latch, 3, 1, -77);
    const Report report = rig.next().value();
    EXPECT_EQ(report.kind, Report::Kind::event);
    EXPECT_EQ(report.record.tick, 9U);
    EXPECT_EQ(report.record.kind, RecordKind::home_latch);
    EXPECT_EQ(report.record.code, 3);
    EXPECT_EQ(report.record.axis, 1U);
    EXPECT_EQ(report.record.value, -77);
    EXPECT_EQ(report.record.signals, bit_of(Signal::spindle));
    EXPECT_EQ(report.record.position_pulses[kY], -5);
    EXPECT_FALSE(rig.next().has_value());
}

TEST(Reporter, TellsAnAlarmWithItsCountsAndLayers) {
    ReporterRig rig;
    rig.sut.report_alarm(AlarmCause::steps_lost, 2, 100, 103, {.first_layer = 4, .layer_count = 2});
    const Report report = rig.next().value();
    EXPECT_EQ(report.record.kind, RecordKind::alarm);
    EXPECT_EQ(report.record.code, static_cast<std::uint16_t>(AlarmCause::steps_lost));
    EXPECT_EQ(report.record.axis, 2U);
    EXPECT_EQ(report.record.value, 103);
    EXPECT_EQ(report.expected_pulses, 100);
    EXPECT_EQ(report.first_layer, 4U);
    EXPECT_EQ(report.layer_count, 2);
}

TEST(Reporter, AnswersWithTheRequestsNumberAndTheAxisOfTheRefusal) {
    ReporterRig rig;
    Report report = rig.answered(request_of(RequestKind::jog), {Refusal::outside_travel, 3});
    EXPECT_EQ(report.kind, Report::Kind::answer);
    EXPECT_EQ(report.sequence, 42U);
    EXPECT_EQ(report.refusal, Refusal::outside_travel);
    EXPECT_EQ(report.record.kind, RecordKind::command);
    EXPECT_EQ(report.record.code, static_cast<std::uint16_t>(CommandKind::jog));
    EXPECT_EQ(report.record.axis, 3U);
    EXPECT_EQ(report.record.answer, static_cast<std::uint32_t>(AnswerKind::refused));
    report = rig.answered(request_of(RequestKind::hold), {Refusal::none});
    EXPECT_EQ(report.record.axis, kNoAxis);
    EXPECT_EQ(report.record.answer, static_cast<std::uint32_t>(AnswerKind::done));
}

TEST(Reporter, RecordsBackOffWithItsAxisAJobAsSuchAndAFailureByItsCause) {
    ReporterRig rig;
    Request back_off = request_of(RequestKind::back_off);
    back_off.axis = 1;
    EXPECT_EQ(rig.answered(back_off, {Refusal::none}).record.axis, 1U);
    const Report job = rig.answered(request_of(RequestKind::job_loaded, 5), {Refusal::none});
    EXPECT_EQ(job.record.kind, RecordKind::job);
    EXPECT_EQ(job.record.value, 5);
    const auto cause = static_cast<std::uint16_t>(AlarmCause::port_error);
    const Report failure = rig.answered(request_of(RequestKind::fail, cause), {Refusal::none});
    EXPECT_EQ(failure.record.kind, RecordKind::failure);
    EXPECT_EQ(failure.record.code, cause);
}

TEST(Reporter, RecordsNoCommandThatIsRecordedOtherwiseOrMovesNothing) {
    ReporterRig rig;
    for (const RequestKind kind : {RequestKind::end_jog, RequestKind::record}) {
        const Report report = rig.answered(request_of(kind), {Refusal::none});
        EXPECT_EQ(report.record.kind, RecordKind::none);
        EXPECT_EQ(report.sequence, 42U) << "it is answered all the same";
    }
}

TEST(Reporter, NamesTheLongestHarmlessGapOrThatItWasLonger) {
    ReporterRig rig;
    rig.sut.report_gap(5, 5);
    Report report = rig.next().value();
    EXPECT_EQ(report.record.kind, RecordKind::gap);
    EXPECT_EQ(report.record.code, 1);
    EXPECT_EQ(report.record.value, 5);
    EXPECT_EQ(report.record.answer, 5U);
    rig.sut.report_gap(6, 5);
    report = rig.next().value();
    EXPECT_EQ(report.record.value, 6);
    EXPECT_EQ(report.record.answer, kAlarmingGap);
}

TEST(Reporter, KeepsHalfOfTheRingFreeOfHarmlessGaps) {
    ReporterRig rig;
    const std::size_t half = ReportRing::capacity() / 2;
    for (std::size_t i = 0; i < half; ++i) rig.sut.report_gap(1, kAnyGap);
    EXPECT_EQ(rig.sut.lost(), 0U);
    rig.sut.report_gap(1, kAnyGap);
    EXPECT_EQ(rig.sut.lost(), 1U);
    EXPECT_EQ(rig.io->reports.size(), half);
    rig.sut.report_gap(9, 3);
    EXPECT_EQ(rig.io->reports.size(), half + 1) << "one that does harm is told";
}

TEST(Reporter, TellsOfAProgramWithItsLineAndAsMuchOfItsSequenceAsFits) {
    ReporterRig rig;
    ProgramStatus program{};
    program.program = 70'000'000'000;
    program.line = 12;
    program.sequence = 34;
    rig.sut.report_program(ProgramEvent::begun, 1, program);
    Report report = rig.next().value();
    EXPECT_EQ(report.record.kind, RecordKind::program);
    EXPECT_EQ(report.record.value, 70'000'000'000);
    rig.sut.report_program(ProgramEvent::held, 3, program);
    report = rig.next().value();
    EXPECT_EQ(report.record.code, 0x302);
    EXPECT_EQ(report.record.value, 12);
    EXPECT_EQ(report.record.answer, 34U);
    program.sequence = 1ULL << 32U;
    rig.sut.report_program(ProgramEvent::line, 0, program);
    EXPECT_EQ(rig.next().value().record.answer, 0xFFFF'FFFFU);
}

TEST(Reporter, KeepsHalfOfTheRingFreeOfLines) {
    ReporterRig rig;
    const std::size_t half = ReportRing::capacity() / 2;
    for (std::size_t i = 0; i <= half; ++i) rig.sut.report_program(ProgramEvent::line, 0, {});
    EXPECT_EQ(rig.io->reports.size(), half);
    EXPECT_EQ(rig.sut.lost(), 0U) << "the next one tells more";
    rig.sut.report_program(ProgramEvent::held, 0, {});
    EXPECT_EQ(rig.io->reports.size(), half + 1);
}

TEST(Reporter, CountsWhatFindsTheRingFull) {
    ReporterRig rig;
    for (std::size_t i = 0; i < ReportRing::capacity(); ++i) rig.sut.report(RecordKind::stop, 0);
    EXPECT_EQ(rig.sut.lost(), 0U);
    rig.sut.report(RecordKind::stop, 0);
    rig.sut.answer(request_of(RequestKind::hold), {Refusal::none});
    EXPECT_EQ(rig.sut.lost(), 2U);
}

TEST(Reporter, TellsAnOrderInPartsOfWhichAReplayMakesItAgain) {
    ReporterRig rig;
    MotionOrder order{};
    order.axes = 0b1001;
    order.target_pulses = {11, 22, 33, 44};
    rig.sut.report_order(order);
    const auto expect = [&](OrderPart part, std::uint8_t axis, std::int64_t value) {
        const Report report = rig.next().value();
        EXPECT_EQ(report.record.kind, RecordKind::order);
        EXPECT_EQ(report.record.code, static_cast<std::uint16_t>(part));
        EXPECT_EQ(report.record.axis, axis);
        EXPECT_EQ(report.record.value, value);
    };
    expect(OrderPart::target, 0, 11);
    expect(OrderPart::target, 3, 44);
    EXPECT_FALSE(rig.next().has_value()) << "no other axis, no shape, no speed";
    order.shape = OrderShape::clockwise;
    order.centre_pulses = {5, 6};
    order.speed_pps = 1.5;
    order.axes = 0b0010;
    rig.sut.report_order(order);
    expect(OrderPart::target, 1, 22);
    expect(OrderPart::shape, kNoAxis, static_cast<std::int64_t>(OrderShape::clockwise));
    expect(OrderPart::centre, 0, 5);
    expect(OrderPart::centre, 1, 6);
    expect(OrderPart::speed, kNoAxis, std::bit_cast<std::int64_t>(1.5));
    EXPECT_FALSE(rig.next().has_value());
}

}  // namespace
}  // namespace psicarve::cycle
