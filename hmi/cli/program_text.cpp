// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_text.hpp"

#include <nlohmann/json.hpp>

namespace psicarve::cli {
namespace {

/// What has to be done to go on.
std::string way_on(ProgramHold hold) {
    if (hold == ProgramHold::starved) return "it goes on when more of the program comes";
    if (hold == ProgramHold::feeder_lost) return "psicarve stop ends it";
    return "psicarve resume goes on";
}

}  // namespace

std::string program_place_text(const ProgramStatus& program) {
    const std::string line = "line " + std::to_string(program.line);
    if (program.hold == ProgramHold::none) return line;
    return line + ": held, " + std::string{name_of(program.hold)} + "; " + way_on(program.hold);
}

std::string program_text(const ProgramStatus& program) {
    return program.is_running == 0 ? std::string{} : "program    " + program_place_text(program) + "\n";
}

nlohmann::ordered_json program_json(const ProgramStatus& program) {
    using Json = nlohmann::ordered_json;
    if (program.is_running == 0) return Json(nullptr);
    return Json{{"number", program.program},
                {"line", program.line},
                {"hold", program.hold == ProgramHold::none ? Json(nullptr) : Json(name_of(program.hold))},
                {"single", program.is_single != 0},
                {"starvations", program.starvations}};
}

}  // namespace psicarve::cli
