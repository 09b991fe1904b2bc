// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/replay/replay_script.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <iterator>
#include <utility>

#include "rtcore/cycle/request_command.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/recorded_gaps.hpp"
#include "shared/machine/recorded_program.hpp"
#include "shared/machine/replayed_part.hpp"

namespace psicarve::supervisor {
namespace {

bool is_done(const FlightRecord& record, RecordKind kind) {
    return record.kind == kind && static_cast<AnswerKind>(record.answer) == AnswerKind::done;
}

std::optional<cycle::RequestKind> request_of(const FlightRecord& record) {
    if (!is_done(record, RecordKind::command)) return std::nullopt;
    return cycle::request_of(static_cast<CommandKind>(record.code));
}

bool is_leased_look(cycle::RequestKind request) {
    return request == cycle::RequestKind::test_pin || request == cycle::RequestKind::record;
}

ReplayStep request_step(const FlightRecord& record, cycle::RequestKind request, std::uint64_t value) {
    ReplayStep step{};
    step.kind = ReplayStep::Kind::request;
    step.axis = static_cast<std::uint8_t>(record.axis);
    step.request = request;
    step.value = value;
    return step;
}

std::optional<ReplayStep> step_of(const FlightRecord& record) {
    const auto value = static_cast<std::uint64_t>(record.value);
    ReplayStep step{};
    step.axis = static_cast<std::uint8_t>(record.axis);
    switch (record.kind) {
        case RecordKind::command:
            // A test and a recording of pins move nothing, and their leases are not recorded.
            if (const auto request = request_of(record); request && !is_leased_look(*request))
                return request_step(record, *request, value);
            return std::nullopt;
        case RecordKind::jog_end:
            return request_step(record, cycle::RequestKind::end_jog, record.code);
        case RecordKind::failure:
            return request_step(record, cycle::RequestKind::fail, record.code);
        case RecordKind::gap:
            step.kind = ReplayStep::Kind::gap;
            step.value = value;
            step.gap_count = std::max<std::uint64_t>(1, record.code);
            return step;
        case RecordKind::stop:
            step.kind = ReplayStep::Kind::stop;
            return step;
        case RecordKind::emergency_stop:
            step.kind = ReplayStep::Kind::emergency_stop;
            return step;
        case RecordKind::input_edge:
            step.kind = ReplayStep::Kind::inputs;
            step.inputs = record.signals & kInputMask;
            return step;
        default:
            return std::nullopt;
    }
}

ReplayStep spindle_on() {
    ReplayStep step{};
    step.kind = ReplayStep::Kind::request;
    step.request = cycle::RequestKind::spindle;
    step.value = 1;
    return step;
}

/// One part of the order that the next command carries.
void add_part(cycle::MotionOrder& order, const FlightRecord& record) {
    switch (static_cast<OrderPart>(record.code)) {
        case OrderPart::target:
            if (record.axis >= kAxisCount) return;
            order.axes = static_cast<std::uint8_t>(order.axes | 1U << record.axis);
            order.target_pulses[record.axis] = record.value;
            return;
        case OrderPart::speed:
            order.speed_pps = std::bit_cast<double>(record.value);
            return;
        case OrderPart::shape:
            order.shape = static_cast<cycle::OrderShape>(record.value);
            return;
        case OrderPart::centre:
            if (record.axis < order.centre_pulses.size()) order.centre_pulses[record.axis] = record.value;
            return;
    }
}

using Records = std::vector<FlightRecord>;

bool is_command(const FlightRecord& record, CommandKind kind) {
    return is_done(record, RecordKind::command) && static_cast<CommandKind>(record.code) == kind;
}
bool is_program(const FlightRecord& record) {
    return is_command(record, CommandKind::program);
}

/// An override given between the job's loading and the script's begin still holds there.
std::optional<ReplayStep> override_before(const Records& records, Records::const_iterator first,
                                          CommandKind kind) {
    std::optional<ReplayStep> step;
    for (auto record = records.begin(); record != first; ++record) {
        if (is_done(*record, RecordKind::job)) step.reset();
        if (is_program_done(*record) && step && step->value > kFullFeed_percent) step.reset();
        if (!is_done(*record, RecordKind::command)) continue;
        if (static_cast<CommandKind>(record->code) == kind) step = step_of(*record);
    }
    return step;
}

/// A stop may have come in the midst of a gap: the record of the rest with which the script begins says so.
GapsLeft gaps_at(Records::const_iterator begin, Records::const_iterator first) {
    for (auto record = std::next(first); record != begin;) {
        --record;
        if (record->kind == RecordKind::state_change) return gaps_left(record->value);
    }
    return {};
}

bool is_override_step(const ReplayStep& step) {
    return step.kind == ReplayStep::Kind::request && (step.request == cycle::RequestKind::override ||
                                                      step.request == cycle::RequestKind::rapid_override);
}

ReplayScript script_of(const Records& records, Records::const_iterator first, Records::const_iterator last) {
    ReplayScript script;
    script.is_cut = last != records.end();
    script.first_tick = first->tick;
    script.start_levels = first->signals;
    script.start_gaps = gaps_at(records.begin(), first);
    std::ranges::copy(first->position_pulses, script.start_position_pulses.begin());
    cycle::MotionOrder order{};
    std::uint8_t begun_switches = 0;
    for (const CommandKind kind : {CommandKind::override, CommandKind::rapid_override}) {
        auto override_step = override_before(records, first, kind);
        if (!override_step) continue;
        override_step->tick = 0;
        script.steps.push_back(*override_step);
    }
    for (auto record = std::next(first); record != last; ++record) {
        if (record->tick < first->tick) continue;
        script.end_tick = std::max(script.end_tick, record->tick - first->tick);
        // A job that is loaded carves as planned, and is no step: it is not in the script's hands.
        if (is_done(*record, RecordKind::job)) std::erase_if(script.steps, is_override_step);
        if (is_of_program(*record, ProgramEvent::begun)) begun_switches = program_detail_of(*record);
        if (record->kind == RecordKind::order) {
            add_part(order, *record);
            continue;
        }
        if (auto step = step_of(*record)) {
            step->tick = record->tick - first->tick;
            if (record->kind == RecordKind::command) step->order = std::exchange(order, {});
            // A command's record has no room for it; the begin is told before the answer.
            if (is_program(*record)) step->axis = begun_switches;
            script.steps.push_back(*step);
        }
    }
    return script;
}

}  // namespace

std::optional<ReplayScript> script_from_records(const std::vector<FlightRecord>& records) {
    const auto begin = replay_begin(records);
    if (!begin || *begin + 1 == records.size()) return std::nullopt;
    const auto first = records.begin() + static_cast<std::ptrdiff_t>(*begin);
    ReplayScript script = script_of(records, first, records.end());
    if (script.steps.empty()) return std::nullopt;
    return script;
}

std::optional<ReplayScript> script_of_program(const std::vector<FlightRecord>& records,
                                              std::uint64_t program) {
    const auto last_program = std::find_if(records.rbegin(), records.rend(), is_program);
    if (last_program == records.rend()) return std::nullopt;
    if (static_cast<std::uint64_t>(last_program->value) != program) return std::nullopt;
    const auto begin = program_replay_begin(records);
    if (!begin) return std::nullopt;
    const auto next_job = std::find_if(last_program.base(), records.end(), [](const FlightRecord& record) {
        return is_done(record, RecordKind::job) || is_command(record, CommandKind::start);
    });
    const auto first = records.begin() + static_cast<std::ptrdiff_t>(*begin);
    ReplayScript script = script_of(records, first, next_job);
    // What a homed machine has on at rest by a command that came before that.
    if ((first->signals & bit_of(Signal::spindle)) != 0)
        script.steps.insert(script.steps.begin(), spindle_on());
    return script;
}

}  // namespace psicarve::supervisor
