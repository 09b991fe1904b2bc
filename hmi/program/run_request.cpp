// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/run_request.hpp"

#include <algorithm>
#include <filesystem>

namespace psicarve::program {

bool is_program_file(const std::string& path) {
    std::string ending = std::filesystem::path{path}.extension().string();
    for (char& letter : ending) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    constexpr const char* kEndings[] = {".ngc", ".nc", ".gcode", ".tap", ".cnc"};
    return std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

std::vector<std::string> arguments_of(const std::string& psicarve, const RunRequest& request) {
    std::vector<std::string> arguments{psicarve,     "gcode",     "run",
                                       request.file, "--segment", request.segment_name};
    const auto add = [&arguments](const char* name, const std::string& value) {
        if (value.empty()) return;
        arguments.emplace_back(name);
        arguments.push_back(value);
    };
    add("--group", request.group);
    add("--profile", request.profile_path);
    const RunSwitches& how = request.switches;
    if (how.from_line > 1) {
        add("--from-line", std::to_string(how.from_line));
        arguments.emplace_back("--unattended");  // the card has been confirmed
    }
    if (how.is_single) arguments.emplace_back("--single");
    if (how.stops_at_optional) arguments.emplace_back("--optional-stop");
    if (how.skips_deleted) arguments.emplace_back("--block-delete");
    if (how.is_dry) arguments.emplace_back("--dry-run");
    if (request.is_typed) arguments.emplace_back("--mdi");
    return arguments;
}

}  // namespace psicarve::program
