// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/replay_script.hpp"

#include <algorithm>
#include <iterator>

#include "shared/command.hpp"

namespace psicarve::supervisor {
namespace {

bool is_homed_rest(const FlightRecord& record) {
    return record.kind == RecordKind::state_change &&
           static_cast<MachineState>(record.code) == MachineState::ready;
}

std::optional<cycle::RequestKind> request_of(const FlightRecord& record) {
    using C = CommandKind;
    using R = cycle::RequestKind;
    if (static_cast<AnswerKind>(record.answer) != AnswerKind::done) return std::nullopt;
    switch (static_cast<C>(record.code)) {
        case C::home:
            return R::home;
        case C::start:
            return R::start;
        case C::start_interpolation:
            return R::start_interpolation;
        case C::hold:
            return R::hold;
        case C::resume:
            return R::resume;
        case C::reset_alarm:
            return R::reset_alarm;
        case C::back_off:
            return R::back_off;
        case C::reset_height:
            return R::reset_height;
        default:
            return std::nullopt;
    }
}

std::optional<ReplayStep> step_of(const FlightRecord& record) {
    ReplayStep step{};
    step.axis = static_cast<std::uint8_t>(record.axis);
    switch (record.kind) {
        case RecordKind::command:
            if (const auto request = request_of(record)) {
                step.kind = ReplayStep::Kind::request;
                step.request = *request;
                return step;
            }
            return std::nullopt;
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

}  // namespace

std::optional<ReplayScript> script_from_records(const std::vector<FlightRecord>& records) {
    const auto first = std::ranges::find_if(records, is_homed_rest);
    if (first == records.end() || std::next(first) == records.end()) return std::nullopt;
    ReplayScript script;
    script.first_tick = first->tick;
    script.start_inputs = first->signals & kInputMask;
    std::ranges::copy(first->position_pulses, script.start_position_pulses.begin());
    for (auto record = std::next(first); record != records.end(); ++record) {
        if (record->tick < first->tick) continue;
        script.end_tick = std::max(script.end_tick, record->tick - first->tick);
        if (auto step = step_of(*record)) {
            step->tick = record->tick - first->tick;
            script.steps.push_back(*step);
        }
    }
    if (script.steps.empty()) return std::nullopt;
    return script;
}

}  // namespace psicarve::supervisor
