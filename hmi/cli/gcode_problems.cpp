// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/gcode_problems.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "hmi/cli/exit_code.hpp"
#include "hmi/model/source_name.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;

Json problems_json(const std::vector<gcode::Problem>& problems) {
    auto list = Json::array();
    for (const gcode::Problem& problem : problems) {
        Json row{{"line", problem.line},
                 {"column", problem.column},
                 {"code", gcode::name_of(problem.code)},
                 {"what", gcode::what_text(problem)},
                 {"remedy", gcode::remedy_of(problem.code)}};
        if (problem.times > 1) row["times"] = problem.times;
        list.push_back(std::move(row));
    }
    return list;
}

}  // namespace

bool is_standard_input(const std::string& path) {
    return path == "-" || path.starts_with(model::kDescriptorFolder);
}

std::string program_name(const std::string& path) {
    return is_standard_input(path) ? "standard input" : path;
}

std::string count_text(std::uint64_t count, const char* one) {
    return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

void print_problems(const std::string& name, const gcode::ProblemList& problems) {
    for (const gcode::Problem& problem : problems.warnings())
        print_warning(gcode::problem_text(problem, name));
    if (const auto more = problems.warning_count() - problems.warnings().size(); more > 0)
        print_warning(name + ": and " + count_text(more, "warning") + " more");
    for (const gcode::Problem& problem : problems.errors())
        print_error(bad_input(gcode::problem_text(problem, name)));
    if (const auto more = problems.error_count() - problems.errors().size(); more > 0)
        print_error(bad_input(name + ": and " + count_text(more, "error") + " more"));
}

Json check_json(const std::string& name, const gcode::ProgramFacts& facts,
                const gcode::ProblemList& problems) {
    Json object{{"file", name},
                {"ok", problems.error_count() == 0},
                {"lines", facts.line_count},
                {"motions", facts.motion_count},
                {"error_count", problems.error_count()},
                {"errors", problems_json(problems.errors())},
                {"warning_count", problems.warning_count()},
                {"warnings", problems_json(problems.warnings())}};
    if (problems.error_count() > 0) {
        const std::string message = gcode::problem_text(problems.errors().front(), name);
        object["error"] = Json::parse(error_json(bad_input(message)));
    }
    return object;
}

void print_json_line(const Json& object) {
    std::printf("%s\n", object.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
}

}  // namespace psicarve::cli
