// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_verify.hpp"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/run_offsets.hpp"
#include "hmi/cli/source_text.hpp"
#include "hmi/gcode/machine_options.hpp"
#include "hmi/verify/judged_trace.hpp"

namespace psicarve::cli {
namespace {

constexpr double kPercent = 100.0;

struct JudgedOffsets {
    gcode::KeptOffsets kept;
    std::string doubt;  ///< empty: the run began with them
    std::optional<offsets::ProfileMark> made_with{};
};

/// Those that a file says, that the run has left beside its trace, or that the machine has now.
Result<JudgedOffsets> offsets_of_trace(const CommonOptions& common, const Profile& profile,
                                       const std::string& trace_path, const std::string& named) {
    std::error_code none;
    offsets::OffsetsPlace place;
    place.path = named.empty() ? offsets::path_beside_trace(trace_path) : named;
    if (!named.empty() || std::filesystem::exists(place.path, none)) {
        if (named.empty() || std::filesystem::exists(named, none)) {
            const auto read = offsets::read_offsets(place, profile.gcode);
            if (!read) return read.error();
            return JudgedOffsets{read->kept, {}, read->profile};
        }
        return bad_input(named + ": there is no such file");
    }
    const auto now = kept_offsets(common, profile);
    if (!now) return now.error();
    return JudgedOffsets{now->kept, place.path +
                                        " is not there; judged by the work offsets of now, --offsets FILE "
                                        "names those that the program began with"};
}

/// Other limits judge any trace, but the way of its tips is that of its own machine: screws with play have
/// pulses that move none.
void tell_of_other_profile(const std::string& trace_path, const JudgedOffsets& offsets,
                           const Profile& profile, const verify::ProgramVerifyReport& report) {
    const auto& made_with = offsets.made_with;
    const bool is_its_own = !made_with || made_with->hash == profile_hash(profile);
    if (is_its_own || report.rules[0].offences == 0) return;
    print_warning(trace_path + ": another profile than the trace was made with, which was \"" +
                  made_with->name + "\" (" + hash_text(made_with->hash) +
                  "); it is not on its program's way by \"" + profile.name + "\" (" +
                  hash_text(profile_hash(profile)) + "): name the one that it was made with: --profile FILE");
}

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
    gcode::InterpreterOptions language = gcode::machine_options(*profile);
    language.dialect = options.dialect == "iso" ? gcode::Dialect::iso : gcode::Dialect::ngc;
    language.skips_deleted = options.skips_deleted;
    const auto offsets = offsets_of_trace(common, *profile, trace_path, options.offsets);
    if (!offsets) return offsets.error();
    language.offsets = offsets->kept;
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
    const bool is_sure = offsets->doubt.empty() || (report->ok && offsets->kept == gcode::KeptOffsets{});
    if (!is_sure) print_warning(offsets->doubt);
    if (report->failure) {
        Error failure = *report->failure;
        if (failure.message.starts_with("line ")) failure.message = options.program + ": " + failure.message;
        return failure;
    }
    tell_of_other_profile(trace_path, *offsets, *profile, *report);
    const std::string text = common.json ? verify::program_report_json(*report).dump(2) + "\n"
                                         : verify::program_report_text(*report);
    std::printf("%s", text.c_str());
    return report->ok ? kExitDone : kExitDifference;
}

}  // namespace psicarve::cli
