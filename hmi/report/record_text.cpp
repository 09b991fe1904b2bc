// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/record_text.hpp"

#include <nlohmann/json.hpp>

#include "hmi/report/program_record_text.hpp"
#include "hmi/report/status_json.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/machine_state.hpp"
#include "shared/machine/recorded_gaps.hpp"

namespace psicarve::report {
namespace {

using Json = nlohmann::ordered_json;

// A file is not trusted: numbers without a name are shown as numbers.
template <typename Name>
std::string named_or_number(std::uint16_t code, std::uint16_t count, Name name) {
    return code < count ? std::string{name(code)} : std::to_string(code);
}

std::string kind_text(RecordKind kind) {
    switch (kind) {
        case RecordKind::none:
            return "none";
        case RecordKind::command:
            return "command";
        case RecordKind::stop:
            return "stop";
        case RecordKind::emergency_stop:
            return "emergency stop";
        case RecordKind::input_edge:
            return "input edge";
        case RecordKind::state_change:
            return "state";
        case RecordKind::alarm:
            return "alarm";
        case RecordKind::job:
            return "job";
        case RecordKind::home_latch:
            return "home latch";
        case RecordKind::gap:
            return "ticks missed";
        case RecordKind::failure:
            return "failure";
        case RecordKind::order:
            return "order";
        case RecordKind::jog_end:
            return "jog end";
        case RecordKind::program:
            return "program";
    }
    return std::to_string(static_cast<unsigned>(kind));
}

std::string part_text(OrderPart part) {
    switch (part) {
        case OrderPart::target:
            return "target";
        case OrderPart::speed:
            return "speed";
        case OrderPart::shape:
            return "shape";
        case OrderPart::centre:
            return "centre";
    }
    return std::to_string(static_cast<unsigned>(part));
}

/// What the code means for this kind of record; empty when it means nothing.
std::string code_text(const FlightRecord& record) {
    switch (record.kind) {
        case RecordKind::command:
            return named_or_number(record.code, kCommandKindCount, [](std::uint16_t code) {
                return name_of(static_cast<CommandKind>(code));
            });
        case RecordKind::order:
            return part_text(static_cast<OrderPart>(record.code));
        case RecordKind::state_change:
            return named_or_number(record.code, kMachineStateCount, [](std::uint16_t code) {
                return name_of(static_cast<MachineState>(code));
            });
        case RecordKind::alarm:
        case RecordKind::failure:
            return named_or_number(record.code, kAlarmCauseCount,
                                   [](std::uint16_t code) { return name_of(static_cast<AlarmCause>(code)); });
        case RecordKind::program:
            return program_event_text(record);
        default:
            return {};
    }
}

std::string answer_text(const FlightRecord& record) {
    if (record.kind != RecordKind::command) return {};
    if (record.answer == static_cast<std::uint32_t>(AnswerKind::done)) return "done";
    return record.answer == static_cast<std::uint32_t>(AnswerKind::refused) ? "refused" : "unanswered";
}

}  // namespace

std::string record_text(const FlightRecord& record) {
    std::string text = "tick " + std::to_string(record.tick) + "  " + kind_text(record.kind);
    const bool is_program = record.kind == RecordKind::program;
    for (const std::string& word :
         {is_program ? program_record_text(record) : code_text(record), answer_text(record)}) {
        if (!word.empty()) text += " " + word;
    }
    const bool has_axis = record.axis < kAxisCount && !is_program;
    if (has_axis) text += " " + std::string{name_of(static_cast<Axis>(record.axis))};
    if (record.kind == RecordKind::input_edge)
        text += " tripped: " + signals_text(record.signals, kInputMask);
    const bool is_target =
        record.kind == RecordKind::order && static_cast<OrderPart>(record.code) == OrderPart::target;
    const bool is_override = record.kind == RecordKind::command &&
                             (static_cast<CommandKind>(record.code) == CommandKind::override ||
                              static_cast<CommandKind>(record.code) == CommandKind::rapid_override);
    if (record.kind == RecordKind::command &&
        (static_cast<CommandKind>(record.code) == CommandKind::single ||
         static_cast<CommandKind>(record.code) == CommandKind::optional_stop))
        text += record.value != 0 ? " on" : " off";
    if (record.kind == RecordKind::alarm || record.kind == RecordKind::job ||
        record.kind == RecordKind::home_latch || is_target || is_override) {
        text += " " + std::to_string(record.value);
    }
    text += " ";
    for (const Axis axis : kAllAxes) {
        text +=
            " " + std::string{name_of(axis)} + " " + std::to_string(record.position_pulses[index_of(axis)]);
    }
    return text;
}

nlohmann::ordered_json record_json(const FlightRecord& record) {
    const std::string code = code_text(record);
    const std::string answer = answer_text(record);
    Json positions;
    for (const Axis axis : kAllAxes)
        positions[std::string{name_of(axis)}] = record.position_pulses[index_of(axis)];
    // Those of a machine at rest, in one number: more than a reader of JSON takes as such.
    const bool tells_gaps = record.kind == RecordKind::state_change;
    Json json{{"tick", record.tick},
              {"kind", kind_text(record.kind)},
              {"code", code.empty() ? Json(record.code) : Json(code)},
              {"axis", record.axis < kAxisCount && record.kind != RecordKind::program
                           ? Json(std::string{name_of(static_cast<Axis>(record.axis))})
                           : Json(nullptr)},
              {"answer", answer.empty() ? Json(nullptr) : Json(answer)},
              {"signals", record.signals},
              {"value", tells_gaps ? 0 : record.value},
              {"program", program_record_json(record)},
              {"position_pulses", positions}};
    if (tells_gaps && record.value != 0) {
        const GapsLeft left = gaps_left(record.value);
        for (const Axis axis : kAllAxes)
            json["gaps_left_pulses"][std::string{name_of(axis)}] = left[index_of(axis)];
    }
    return json;
}

}  // namespace psicarve::report
