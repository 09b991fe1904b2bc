// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_verify.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/gcode/drawing_machine.hpp"
#include "hmi/gcode/machine_check.hpp"
#include "hmi/verify/judged_trace.hpp"

namespace psicarve::cli {
namespace {

constexpr double kPercent = 100.0;

}  // namespace

verify::JudgedProgram program_of_file(const std::string& path, const gcode::FileState& state,
                                      const gcode::InterpreterOptions& language,
                                      std::uint32_t override_percent) {
    verify::JudgedProgram program;
    program.open = [path, state] { return gcode::open_unchanged_program(path, state); };
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
    language.drawing = gcode::drawing_machine_of(*profile);
    const auto state = gcode::state_of_program(options.program);
    if (!state) return state.error();
    const auto trace = verify::open_trace(trace_path);
    if (!trace) return trace.error();
    if (!(*trace)->start().has_positions)
        print_warning(trace_path + ": does not say where the axes stood at its begin; all are taken to be 0");
    verify::ProgramVerifier verifier{
        program_of_file(options.program, *state, language, options.override_percent), *profile};
    const auto report = verify::judged_trace(verifier, **trace, {});
    if (!report) return report.error();
    if (report->failure) {
        Error failure = *report->failure;
        if (failure.message.starts_with("line ")) failure.message = options.program + ": " + failure.message;
        return failure;
    }
    const std::string text = common.json ? verify::program_report_json(*report).dump(2) + "\n"
                                         : verify::program_report_text(*report);
    std::printf("%s", text.c_str());
    return report->ok ? kExitDone : kExitDifference;
}

}  // namespace psicarve::cli
