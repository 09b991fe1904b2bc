// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_verify.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/gcode_problems.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/gcode/machine_check.hpp"
#include "hmi/gcode/program_check.hpp"
#include "hmi/verify/judged_trace.hpp"

namespace psicarve::cli {
namespace {

constexpr double kPercent = 100.0;

/// A wrong program judges nothing. False: that was told.
Result<bool> is_right(const ProgramVerifyOptions& options, const gcode::InterpreterOptions& language,
                      const Profile& profile, const CommonOptions& common) {
    gcode::InterpreterOptions how = language;
    how.is_start_known = false;
    gcode::ProblemList problems;
    gcode::MachineCheck machine{profile, problems};
    auto bytes = gcode::open_program(options.program);
    if (!bytes) return bytes.error();
    gcode::LineSource lines{std::move(bytes).value()};
    const auto facts = gcode::interpret_program(lines, how, machine, problems);
    if (!facts) return facts.error();
    if (problems.error_count() == 0) return true;
    print_problems(options.program, problems);
    if (common.json) print_json_line(check_json(options.program, *facts, problems));
    return false;
}

}  // namespace

Result<verify::JudgedProgram> program_of_file(const std::string& path,
                                              const gcode::InterpreterOptions& language,
                                              std::uint32_t override_percent) {
    const auto state = gcode::state_of_program(path);
    if (!state) return state.error();
    verify::JudgedProgram program;
    program.open = [path, state = *state] { return gcode::open_unchanged_program(path, state); };
    program.language = language;
    program.override_ratio = override_percent / kPercent;
    return program;
}

Result<int> verify_program(const CommonOptions& common, const std::string& trace_path,
                           const ProgramVerifyOptions& options) {
    const auto profile = chosen_profile(common);
    if (!profile) return profile.error();
    gcode::InterpreterOptions language;
    language.dialect = options.dialect == "iso" ? gcode::Dialect::iso : gcode::Dialect::ngc;
    language.skips_deleted = options.skips_deleted;
    language.reference = gcode::MachineCheck::reference_of(*profile);
    auto program = program_of_file(options.program, language, options.override_percent);
    if (!program) return program.error();
    const auto right = is_right(options, language, *profile, common);
    if (!right) return right.error();
    if (!*right) return kExitBadInput;
    const auto trace = verify::open_trace(trace_path);
    if (!trace) return trace.error();
    if (!(*trace)->start().has_positions)
        print_warning(trace_path + ": does not say where the axes stood at its begin; all are taken to be 0");
    verify::ProgramVerifier verifier{std::move(*program), *profile};
    const auto report = verify::judged_trace(verifier, **trace, {});
    if (!report) return report.error();
    if (report->failure) return *report->failure;
    const std::string text = common.json ? verify::program_report_json(*report).dump(2) + "\n"
                                         : verify::program_report_text(*report);
    std::printf("%s", text.c_str());
    return report->ok ? kExitDone : kExitDifference;
}

}  // namespace psicarve::cli
