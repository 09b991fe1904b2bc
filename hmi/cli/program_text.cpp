// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "hmi/cli/progress_bar.hpp"
#include "hmi/report/message_json.hpp"
#include "hmi/report/program_modes.hpp"
#include "hmi/report/program_origin.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;
using ByAxis = std::array<double, kAxisCount>;
using report::word_text;

/// "r1 12.000 mm, r2 0.000 mm, psi 90.000 deg, y 5.000 mm"
std::string by_axis_text(const ByAxis& values) {
    std::string text;
    for (const Axis axis : kAllAxes) {
        char number[32];
        // No zero has a sign.
        const double shown = std::abs(values[index_of(axis)]) < 0.0005 ? 0.0 : values[index_of(axis)];
        std::snprintf(number, sizeof number, " %.3f", shown);
        text += (text.empty() ? "" : ", ") + std::string{name_of(axis)} + number +
                (axis == Axis::psi ? " deg" : " mm");
    }
    return text;
}

Json by_axis_json(const std::optional<ByAxis>& values) {
    if (!values || !report::has_numbers(*values)) return Json(nullptr);
    const auto of = [&](Axis axis) { return (*values)[index_of(axis)]; };
    return Json{
        {"r1_mm", of(Axis::r1)}, {"r2_mm", of(Axis::r2)}, {"psi_deg", of(Axis::psi)}, {"y_mm", of(Axis::y)}};
}

std::optional<ByAxis> to_go(const ProgramReport& report, const CoreStatus& machine, const Profile* profile) {
    if (!report.modes || profile == nullptr) return std::nullopt;
    return report::to_go(*report.modes, report.status, machine, *profile);
}

/// Nothing: it is not known what holds.
std::string modes_text(const ProgramReport& report) {
    const std::string codes = report.modes ? report::codes_text(*report.modes) : std::string{};
    if (codes.empty()) return {};
    const ProgramModes& modes = *report.modes;
    std::string text = "modes      " + codes;
    if (const std::string words = report::words_text(modes, ", "); !words.empty()) text += "; " + words;
    if (!report::is_at_hand(modes, report.status)) text += " (of line " + std::to_string(modes.line) + ")";
    text += "\n";
    const std::string system = report::system_text(modes);
    if (system.empty() || !report::has_numbers(modes.zero)) return text;
    text += "zero       " + system + ": " + by_axis_text(modes.zero);
    if (const auto turn_deg = report::shown_number(modes.rotation_deg); turn_deg.value_or(0.0) != 0.0)
        text += ", turned by " + word_text(*turn_deg) + " deg";
    return text + "\n";
}

template <typename Number>
Json known_json(const std::optional<Number>& number) {
    return number ? Json(*number) : Json(nullptr);
}

Json modes_json(const ProgramReport& report) {
    if (!report.modes || report::codes_text(*report.modes).empty()) return Json(nullptr);
    const ProgramModes& modes = *report.modes;
    const std::string system = report::system_text(modes);
    return Json{{"line", modes.line},
                {"is_at_hand", report::is_at_hand(modes, report.status)},
                {"codes", report::codes_text(modes)},
                {"feed", known_json(report::shown_number(modes.feed))},
                {"speed_rpm", known_json(report::shown_number(modes.speed_rpm))},
                {"tool", known_json(report::shown_tool(modes))},
                {"system", system.empty() ? Json(nullptr) : Json(system)},
                {"zero", by_axis_json(modes.zero)},
                {"rotation_deg", known_json(report::shown_number(modes.rotation_deg))}};
}

std::string numbered_name(const ProgramReport& report) {
    const std::string number = "no. " + std::to_string(report.status.program);
    return report.origin ? report::origin_text(*report.origin) + " (" + number + ")" : number;
}

std::string switches_text(const ProgramReport& report) {
    const auto names = report::switch_names(report.status, report.origin ? &*report.origin : nullptr);
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    if (!report.origin) text += text.empty() ? "not told how it is read" : "; not told how it is read";
    return "switches   " + (text.empty() ? "none" : text) + "\n";
}

/// How its text is read cannot be switched: it was before it began. Null: nobody has told.
Json origin_json(const ProgramReport& report) {
    if (!report.origin)
        return Json{{"name", nullptr},         {"source", nullptr},  {"from_line", nullptr},
                    {"block_delete", nullptr}, {"dry_run", nullptr}, {"dialect", nullptr}};
    const ProgramOrigin& origin = *report.origin;
    constexpr std::array kKinds{"file", "stream", "typed"};
    const auto kind = report::kind_of(origin);
    const auto has = [&](std::uint32_t flag) { return (origin.flags & flag) != 0; };
    return Json{
        {"name", kind == report::OriginKind::file ? Json(report::file_name_of(origin)) : Json(nullptr)},
        {"source", kKinds[static_cast<std::size_t>(kind)]},
        {"from_line", std::max<std::uint64_t>(origin.from_line, 1)},
        {"block_delete", has(kSourceSkipsDeleted)},
        {"dry_run", has(kSourceIsDry)},
        {"dialect", has(kSourceIsIso) ? "iso" : "ngc"}};
}

/// What has to be done to go on.
std::string way_on(ProgramHold hold) {
    if (hold == ProgramHold::starved) return "it goes on when more of the program comes";
    if (is_for_good(hold)) return "psicarve stop ends it";
    return "psicarve resume goes on";
}

/// Only where the machine has come to it: the core reads ahead.
bool tells_why(const ProgramReport& report) {
    return is_for_good(report.status.hold) && report.refusal &&
           report.refusal->program == report.status.program;
}

/// Where the recorder has lost its beginning it has no number.
bool is_recorded(const ProgramStatus& program) {
    return program.program != 0 || program.line != 0;
}

}  // namespace

std::string program_place_text(const ProgramReport& report) {
    const ProgramStatus& program = report.status;
    const std::string line = "line " + std::to_string(program.line);
    if (program.hold == ProgramHold::none) return line;
    std::string reason{name_of(program.hold)};
    if (tells_why(report)) reason += " (" + in_words(report.refusal->said) + ")";
    return line + ": held, " + reason + "; " + way_on(program.hold);
}

std::string named_place_text(const ProgramReport& report) {
    const std::string name =
        report.origin ? report::origin_text(*report.origin) : "no. " + std::to_string(report.status.program);
    return name + ", " + program_place_text(report);
}

bool was_broken_off(const ProgramStatus& program) {
    return program.program != 0 && program.is_running == 0 && program.is_done == 0 && program.line != 0;
}

std::string broken_off_text(const ProgramStatus& program) {
    const std::string line = std::to_string(program.line);
    return "in line " + line + " of its program; gcode run FILE --from-line " + line +
           " begins where that line is reached first";
}

std::string program_text(const ProgramReport& report, const CoreStatus& machine, const Profile* profile) {
    if (was_broken_off(report.status) && !runs_job(machine.state)) {
        constexpr std::uint32_t kAllHomed = (1U << kAxisCount) - 1U;
        return "program    the last one" +
               (report.origin ? " (" + report::origin_text(*report.origin) + ")" : std::string{}) +
               " ended " + broken_off_text(report.status) +
               (machine.homed_mask == kAllHomed ? "\n" : ", once the machine is homed\n");
    }
    if (report.status.is_running == 0) return {};
    std::string text = "program    " + numbered_name(report) + ", " + program_place_text(report) + "\n" +
                       switches_text(report) + modes_text(report);
    if (const auto left = to_go(report, machine, profile)) text += "to go      " + by_axis_text(*left) + "\n";
    text += "queue      " + std::to_string(report.queued) + " of " + std::to_string(report.ring_records) +
            " records; it had to wait for more " + count_text(report.status.starvations, "time") + "\n";
    return text;
}

std::string recorded_program_text(const ProgramStatus& program, bool may_run) {
    if (!is_recorded(program)) return {};
    const std::string place =
        program.line == 0 ? "before its first line" : "line " + std::to_string(program.line);
    std::string text = "program    ";
    if (program.is_running != 0 && may_run) {
        const std::string reason{name_of(program.hold)};
        text += place + (reason.empty() ? reason : ": held, " + reason);
    } else if (program.is_done != 0) {
        text += "the last one was done, up to " + place;
    } else {
        text += "the last one ended " + (program.line == 0 ? place : broken_off_text(program));
    }
    return text + "\n";
}

Json recorded_program_json(const ProgramStatus& program) {
    if (!is_recorded(program)) return Json(nullptr);
    return Json{{"number", program.program == 0 ? Json(nullptr) : Json(program.program)},
                {"line", program.line},
                {"sequence", program.sequence},
                {"is_running", program.is_running != 0},
                {"hold", program.hold == ProgramHold::none ? Json(nullptr) : Json(name_of(program.hold))},
                {"is_done", program.is_done != 0}};
}

Json last_program_json(const ProgramReport& report) {
    const ProgramStatus& program = report.status;
    if (program.program == 0 || program.is_running != 0) return Json(nullptr);
    Json object{{"number", program.program}, {"line", program.line}, {"is_done", program.is_done != 0}};
    object.update(origin_json(report));
    return object;
}

Json program_json(const ProgramReport& report, const CoreStatus& machine, const Profile* profile) {
    const ProgramStatus& program = report.status;
    if (program.is_running == 0) return Json(nullptr);
    Json refusal = nullptr;
    if (tells_why(report))
        refusal = Json{{"line", report.refusal->line},
                       {"what", in_words(report.refusal->said)},
                       {"message", report::message_json(report.refusal->said)}};
    Json object{{"number", program.program}};
    object.update(origin_json(report));
    object.update(
        Json{{"line", program.line},
             {"sequence", program.sequence},
             {"hold", program.hold == ProgramHold::none ? Json(nullptr) : Json(name_of(program.hold))},
             {"refusal", refusal},
             {"single", program.is_single != 0},
             {"optional_stop", program.stops_at_optional != 0},
             {"starvations", program.starvations},
             {"queue", Json{{"records", report.queued}, {"of", report.ring_records}}},
             {"modes", modes_json(report)},
             {"to_go", by_axis_json(to_go(report, machine, profile))}});
    return object;
}

}  // namespace psicarve::cli
