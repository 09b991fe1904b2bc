// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/program_record_text.hpp"

#include <nlohmann/json.hpp>

#include "shared/machine/command.hpp"

namespace psicarve::report {
namespace {

using Json = nlohmann::ordered_json;

/// Why it is held, how it ended; empty for all else, and where a command holds it.
std::string detail_text(const FlightRecord& record) {
    const std::uint8_t detail = program_detail_of(record);
    if (is_of_program(record, ProgramEvent::held)) {
        return detail < kProgramHoldCount ? std::string{name_of(static_cast<ProgramHold>(detail))}
                                          : std::to_string(detail);
    }
    if (!is_of_program(record, ProgramEvent::ended)) return {};
    return detail < kProgramEndingCount ? std::string{name_of(static_cast<ProgramEnding>(detail))}
                                        : std::to_string(detail);
}

std::string place_text(const FlightRecord& record) {
    if (record.value == 0) return "before its first line";
    std::string text = "line " + std::to_string(record.value);
    if (record.answer != 0) text += " (record " + std::to_string(record.answer) + ")";
    return text;
}

bool is_single(const FlightRecord& record) {
    return (program_detail_of(record) & kProgramIsSingle) != 0;
}

bool stops_at_optional(const FlightRecord& record) {
    return (program_detail_of(record) & kProgramStopsAtOptional) != 0;
}

std::string begun_text(const FlightRecord& record) {
    std::string text = "begun no. " + std::to_string(record.value);
    if (is_single(record)) text += ", " + std::string{name_of(ProgramHold::single)};
    if (stops_at_optional(record)) text += ", " + std::string{name_of(ProgramHold::optional)};
    return text;
}

}  // namespace

// A file is not trusted: numbers without a name are shown as numbers.
std::string program_event_text(const FlightRecord& record) {
    if (static_cast<std::uint8_t>(program_event_of(record)) >= kProgramEventCount)
        return std::to_string(record.code);
    return std::string{name_of(program_event_of(record))};
}

std::string program_record_text(const FlightRecord& record) {
    if (is_of_program(record, ProgramEvent::begun)) return begun_text(record);
    if (is_of_program(record, ProgramEvent::line)) return place_text(record);
    const std::string detail = detail_text(record);
    const std::uint32_t starvations = recorded_starvations(record);
    return place_text(record) + ": " + program_event_text(record) +
           (detail.empty() ? detail : ", " + detail) +
           (starvations > 1 ? " " + std::to_string(starvations) + " times" : std::string{});
}

Json program_record_json(const FlightRecord& record) {
    if (record.kind != RecordKind::program) return Json(nullptr);
    if (is_of_program(record, ProgramEvent::begun))
        return Json{{"number", record.value},
                    {"single", is_single(record)},
                    {"optional_stop", stops_at_optional(record)}};
    Json object{{"line", record.value}, {"sequence", record.answer}};
    const std::string detail = detail_text(record);
    const Json told = detail.empty() ? Json(nullptr) : Json(detail);
    if (is_of_program(record, ProgramEvent::held)) object["hold"] = told;
    if (const std::uint32_t starvations = recorded_starvations(record); starvations > 0)
        object["starvations"] = starvations;
    if (is_of_program(record, ProgramEvent::ended)) object["how"] = told;
    return object;
}

}  // namespace psicarve::report
