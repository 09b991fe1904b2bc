// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "rtcore/cycle/cycle.hpp"
#include "rtcore/cycle/request_command.hpp"
#include "shared/command.hpp"

namespace psicarve::cycle {
Sample Cycle::sample() const noexcept {
    Sample sample{};
    sample.tick = tick_;
    sample.state = state_;
    sample.alarm_cause = alarm_cause_;
    sample.alarm_axis = alarm_axis_;
    sample.homed_mask = homed_.mask();
    sample.signals = pulses_.levels() | inputs_.raw();
    // Samples come in step with its toggling: what they show is whether it does.
    const bool toggles = config_.has_charge_pump && state_ != MachineState::alarm && port_->is_healthy();
    if (toggles) sample.signals |= kChargePumpBit;
    sample.is_port_silent = port_->is_silent() ? 1 : 0;
    sample.signals |= port_->stuck_outputs();
    sample.move_end = move_end_;
    sample.position_pulses = pulses_.positions();
    sample.emitted_pulses = pulses_.emitted();
    sample.layer = executor_.layer();
    sample.point = executor_.point();
    sample.points_done = executor_.points_reached();
    job_.show_in(sample);
    sample.missed_ticks = missed_ticks_;
    sample.waited_ticks = executor_.waited_ticks();
    sample.trace_lost = trace_lost_;
    sample.reports_lost = reports_lost_;
    sample.increments_lost = increments_lost_;
    return sample;
}

FlightRecord Cycle::record_of(RecordKind kind, std::uint16_t code, std::uint8_t axis,
                              std::int64_t value) const noexcept {
    FlightRecord record{};
    record.tick = tick_;
    record.kind = kind;
    record.code = code;
    record.axis = axis;
    record.signals = pulses_.levels() | inputs_.raw();
    record.value = value;
    std::ranges::copy(pulses_.positions(), record.position_pulses);
    return record;
}

void Cycle::report(const FlightRecord& record) noexcept {
    Report entry{};
    entry.record = record;
    entry.kind = Report::Kind::event;
    push_report(entry);
}

void Cycle::answer(const Request& request, Refusal refusal) noexcept {
    Report entry{};
    const bool is_job = request.kind == RequestKind::job_loaded;
    entry.record = record_of(is_job ? RecordKind::job : RecordKind::command,
                             static_cast<std::uint16_t>(command_of(request.kind)), kNoAxis,
                             static_cast<std::int64_t>(request.value));
    if (request.kind == RequestKind::back_off) entry.record.axis = request.axis;
    if (refusal != Refusal::none && refused_axis_ != kNoAxis) entry.record.axis = refused_axis_;
    // A jog's end recorded itself; who watches the pins is no part of what the machine did.
    const bool is_told = request.kind == RequestKind::end_jog || request.kind == RequestKind::record;
    if (is_told) entry.record.kind = RecordKind::none;
    if (request.kind == RequestKind::fail) {
        entry.record.kind = RecordKind::failure;
        entry.record.code = static_cast<std::uint16_t>(request.value);
    }
    entry.record.answer =
        static_cast<std::uint32_t>(refusal == Refusal::none ? AnswerKind::done : AnswerKind::refused);
    entry.sequence = request.sequence;
    entry.kind = Report::Kind::answer;
    entry.refusal = refusal;
    push_report(entry);
    next_publish_tick_ = tick_;  // nobody is told of an answer before what it led to is there to be read
}

void Cycle::push_report(const Report& report) noexcept {
    if (!io_->reports.push(report)) ++reports_lost_;
}

// Each by itself, at once: whoever looks at the recorder finds there what the status has counted. Half of the
// ring is for whatever else happens while nobody empties it.
void Cycle::report_gap(std::uint64_t ticks) noexcept {
    const std::uint32_t longest = longest_harmless_gap();
    FlightRecord record = record_of(RecordKind::gap, 1, kNoAxis, static_cast<std::int64_t>(ticks));
    record.answer = ticks > longest ? kAlarmingGap : longest;
    if (record.answer != kAlarmingGap && io_->reports.size() >= ReportRing::capacity() / 2) {
        ++reports_lost_;
        return;
    }
    report(record);
}

/// Missed ticks after which no rotor that turns now has lost its steps: as check_gap() has it.
std::uint32_t Cycle::longest_harmless_gap() const noexcept {
    constexpr std::int64_t kNoRotorTurns = std::numeric_limits<std::int64_t>::max();
    std::int64_t least_ticks = kNoRotorTurns;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const std::int64_t coast_ticks = config_.axes[k].coast_ticks;
        if (pulses_.stepped_within(k, coast_ticks, tick_)) least_ticks = std::min(least_ticks, coast_ticks);
    }
    if (least_ticks == kNoRotorTurns) return kAnyGap;
    const std::int64_t step_ticks = config_.has_two_timers() ? config_.io_ticks : 1;
    return static_cast<std::uint32_t>(
        std::clamp<std::int64_t>(least_ticks / step_ticks - 1, 0, std::int64_t{kAnyGap} - 1));
}

// After the pins of the same tick: what is counted from here on includes their pulses.
void Cycle::trace_position() noexcept {
    has_new_position_ = false;
    if (is_tracing()) trace_all(trace::TraceEntry::Kind::position, 0);
}

}  // namespace psicarve::cycle
