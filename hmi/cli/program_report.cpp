// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_report.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/gcode_problems.hpp"
#include "hmi/cli/progress_bar.hpp"

namespace psicarve::cli {
namespace {

constexpr std::size_t kShownLowered = 3;

nlohmann::ordered_json run_json(const std::string& name, const ProgramRun& run, const PinsVerdict& pins) {
    nlohmann::ordered_json json{{"file", name},
                                {"ok", true},
                                {"line", run.program.line},
                                {"seconds", run.seconds},
                                {"starvations", run.program.starvations},
                                {"simulated", pins.is_simulated}};
    const auto& seen = pins.verification;
    json["verified"] = seen ? nlohmann::ordered_json(seen->ok) : nlohmann::ordered_json(nullptr);
    if (seen) {
        json["ok"] = seen->ok;
        json["lowered"] = verify::lowered_json(seen->lowered);
        json["verification"] = verify::program_report_json(*seen);
    } else {
        json["unverified_reason"] = pins.unverified_reason;
    }
    if (!pins.trace_path.empty()) json["trace"] = pins.trace_path;
    return json;
}

void print_text(const std::string& name, const ProgramRun& run, const PinsVerdict& pins) {
    std::printf("%s: done%s, up to line %llu, %s of machine time\n", name.c_str(),
                pins.is_simulated ? " on the simulated machine" : "",
                static_cast<unsigned long long>(run.program.line), clock_text(run.seconds).c_str());
    if (const auto& seen = pins.verification) {
        if (!seen->lowered.empty())
            std::printf("feed       lowered feeds cost %s, most in %s\n",
                        clock_text(seen->lowered_seconds).c_str(),
                        verify::lowered_text(seen->lowered, kShownLowered).c_str());
        const verify::Offence* const first = verify::first_offence_of(seen->rules);
        std::printf("verified   %s\n", first == nullptr
                                           ? ("yes: " + count_text(seen->ways_done, "way")).c_str()
                                           : ("NO: " + first->sentence).c_str());
    } else if (!pins.trace_path.empty()) {
        std::printf("verified   not verified: %s\n", pins.unverified_reason.c_str());
    }
    if (!pins.trace_path.empty()) std::printf("trace      %s\n", pins.trace_path.c_str());
}

}  // namespace

int report_program_run(const CommonOptions& common, const std::string& name, const ProgramRun& run,
                       const PinsVerdict& pins) {
    clear_progress_line();
    if (common.json)
        print_json_line(run_json(name, run, pins));
    else
        print_text(name, run, pins);
    if (run.program.starvations > 0)
        print_warning("the machine had to wait for the program " +
                      count_text(run.program.starvations, "time"));
    return pins.verification && !pins.verification->ok ? kExitDifference : kExitDone;
}

}  // namespace psicarve::cli
