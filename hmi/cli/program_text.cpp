// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_text.hpp"

#include <nlohmann/json.hpp>

#include "hmi/report/message_json.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {
namespace {

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

}  // namespace

std::string program_place_text(const ProgramReport& report) {
    const ProgramStatus& program = report.status;
    const std::string line = "line " + std::to_string(program.line);
    if (program.hold == ProgramHold::none) return line;
    std::string reason{name_of(program.hold)};
    if (tells_why(report)) reason += " (" + in_words(report.refusal->said) + ")";
    return line + ": held, " + reason + "; " + way_on(program.hold);
}

std::string program_text(const ProgramReport& report) {
    return report.status.is_running == 0 ? std::string{} : "program    " + program_place_text(report) + "\n";
}

nlohmann::ordered_json program_json(const ProgramReport& report) {
    using Json = nlohmann::ordered_json;
    const ProgramStatus& program = report.status;
    if (program.is_running == 0) return Json(nullptr);
    Json refusal = nullptr;
    if (tells_why(report))
        refusal = Json{{"line", report.refusal->line},
                       {"what", in_words(report.refusal->said)},
                       {"message", report::message_json(report.refusal->said)}};
    return Json{{"number", program.program},
                {"line", program.line},
                {"hold", program.hold == ProgramHold::none ? Json(nullptr) : Json(name_of(program.hold))},
                {"refusal", refusal},
                {"single", program.is_single != 0},
                {"starvations", program.starvations}};
}

}  // namespace psicarve::cli
