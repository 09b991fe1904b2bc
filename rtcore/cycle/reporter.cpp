// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/reporter.hpp"

#include <algorithm>
#include <bit>

#include "rtcore/cycle/request_command.hpp"
#include "shared/machine/command.hpp"

namespace psicarve::cycle {

FlightRecord Reporter::record_of(RecordKind kind, std::uint16_t code, std::uint8_t axis,
                                 std::int64_t value) const noexcept {
    FlightRecord record{};
    record.tick = clock_->tick();
    record.kind = kind;
    record.code = code;
    record.axis = axis;
    record.signals = pulses_->levels() | inputs_->raw();
    record.value = value;
    std::ranges::copy(pulses_->positions(), record.position_pulses);
    return record;
}

void Reporter::push(const Report& report) noexcept {
    if (!io_->reports.push(report)) ++lost_;
}

void Reporter::push_event(const FlightRecord& record) noexcept {
    Report entry{};
    entry.record = record;
    entry.kind = Report::Kind::event;
    push(entry);
}

void Reporter::report(RecordKind kind, std::uint16_t code, std::uint8_t axis, std::int64_t value) noexcept {
    push_event(record_of(kind, code, axis, value));
}

void Reporter::report_alarm(AlarmCause cause, std::uint8_t axis, std::int64_t expected_pulses,
                            std::int64_t seen_pulses, JobRun::Affected affected) noexcept {
    Report entry{};
    entry.record = record_of(RecordKind::alarm, static_cast<std::uint16_t>(cause), axis, seen_pulses);
    entry.expected_pulses = expected_pulses;
    entry.kind = Report::Kind::event;
    entry.first_layer = affected.first_layer;
    entry.layer_count = affected.layer_count;
    push(entry);
}

void Reporter::report_order(const MotionOrder& order) noexcept {
    const auto note = [&](OrderPart part, std::uint8_t axis, std::int64_t value) noexcept {
        report(RecordKind::order, static_cast<std::uint16_t>(part), axis, value);
    };
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if ((order.axes >> k & 1U) == 0) continue;
        note(OrderPart::target, static_cast<std::uint8_t>(k), order.target_pulses[k]);
    }
    if (order.shape != OrderShape::straight) {
        note(OrderPart::shape, kNoAxis, static_cast<std::int64_t>(order.shape));
        for (std::size_t i = 0; i < order.centre_pulses.size(); ++i) {
            note(OrderPart::centre, static_cast<std::uint8_t>(i), order.centre_pulses[i]);
        }
    }
    if (order.speed_pps > 0.0) {
        note(OrderPart::speed, kNoAxis, std::bit_cast<std::int64_t>(order.speed_pps));
    }
}

// Each by itself, at once: who looks at the recorder finds there what the status has counted.
void Reporter::report_gap(std::uint64_t ticks, std::uint32_t longest_harmless_ticks) noexcept {
    FlightRecord record = record_of(RecordKind::gap, 1, kNoAxis, static_cast<std::int64_t>(ticks));
    record.answer = ticks > longest_harmless_ticks ? kAlarmingGap : longest_harmless_ticks;
    if (record.answer != kAlarmingGap && io_->reports.size() >= ReportRing::capacity() / 2) {
        ++lost_;
        return;
    }
    push_event(record);
}

void Reporter::report_program(ProgramEvent event, std::uint8_t detail,
                              const ProgramStatus& program) noexcept {
    if (event == ProgramEvent::line && io_->reports.size() >= ReportRing::capacity() / 2) return;
    push_event(record_of_program(event, detail, program));
}

FlightRecord Reporter::record_of_program(ProgramEvent event, std::uint8_t detail,
                                         const ProgramStatus& program) const noexcept {
    const std::uint64_t value = event == ProgramEvent::begun ? program.program : program.line;
    FlightRecord record = record_of(RecordKind::program, recorded_code(event, detail), kNoAxis,
                                    static_cast<std::int64_t>(value));
    record.answer = recorded_sequence(program.sequence);
    return record;
}

void Reporter::report_starvations(std::uint32_t count, const ProgramStatus& program) noexcept {
    constexpr auto kStarved = static_cast<std::uint8_t>(ProgramHold::starved);
    FlightRecord record = record_of_program(ProgramEvent::held, kStarved, program);
    record.axis = count;
    push_event(record);
}

void Reporter::answer(const Request& request, Verdict verdict) noexcept {
    Report entry{};
    const bool is_done = verdict.refusal == Refusal::none;
    const bool is_job = request.kind == RequestKind::job_loaded;
    entry.record = record_of(is_job ? RecordKind::job : RecordKind::command,
                             static_cast<std::uint16_t>(command_of(request.kind)), kNoAxis,
                             static_cast<std::int64_t>(request.value));
    if (request.kind == RequestKind::back_off) entry.record.axis = request.axis;
    if (!is_done && verdict.axis != kNoAxis) entry.record.axis = verdict.axis;
    // A jog's end recorded itself; who watches the pins is no part of what the machine did.
    const bool is_told = request.kind == RequestKind::end_jog || request.kind == RequestKind::record;
    if (is_told) entry.record.kind = RecordKind::none;
    if (request.kind == RequestKind::fail) {
        entry.record.kind = RecordKind::failure;
        entry.record.code = static_cast<std::uint16_t>(request.value);
    }
    entry.record.answer = static_cast<std::uint32_t>(is_done ? AnswerKind::done : AnswerKind::refused);
    entry.sequence = request.sequence;
    entry.kind = Report::Kind::answer;
    entry.refusal = verdict.refusal;
    push(entry);
}

}  // namespace psicarve::cycle
