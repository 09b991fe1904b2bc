// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/simulated_run.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/judged_pins.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/cli/run_report.hpp"
#include "hmi/cli/run_watch.hpp"
#include "shared/base/printable.hpp"

namespace psicarve::cli {
namespace {

machine::JobRun watched_run(machine::VerifiedCore& core, const JobView& job, const SimulatedRun& what,
                            OperatorBreak& operator_break) {
    RunWatch watch{core.link(), job, operator_break};
    machine::JobRun run = what.run(core, watch.watch());
    const bool was_cut_short = run.failure || !machine::figures_of(run).is_complete;
    if (watch.was_stopped() && was_cut_short) run.failure = watch.stop_error(run.after);
    return run;
}

/// An operator who has stopped the run may need an emergency stop while the core ends and its trace is read.
Result<verify::VerifyReport> finish(machine::VerifiedCore& core, const machine::JobRun& run,
                                    OperatorBreak& operator_break, RunReport& report) {
    const bool was_stopped = operator_break.was_asked() && run.failure;
    operator_break.let_third_end_us();
    auto verified = core.finish([&] { (void)operator_break.pass_on(core.link()).has_value(); });
    if (was_stopped) report.failure = operator_break.error(run.after);
    return verified;
}

/// The recording may end in an alarm; any other failure is the replay's own.
bool is_recording_repeated(const RunReport& report) {
    return !report.failure || report.last.state == MachineState::alarm;
}

/// The core's messages during the run: warnings, and traces that could not be written. The first of these is
/// the run's failure, and reported as such.
void pass_on_messages(const std::string& said, const std::vector<std::string>& trace_paths,
                      RunReport& report) {
    std::istringstream lines{said};
    for (std::string line; std::getline(lines, line);) {
        const bool is_about_trace = std::any_of(
            trace_paths.begin(), trace_paths.end(),
            [&line](const std::string& path) { return line.find(path + ": ") != std::string::npos; });
        if (is_about_trace && !report.failure) {
            report.failure = Error{ErrorCode::out_of_room, line};
            continue;
        }
        clear_progress_line();
        std::fprintf(stderr, "%s\n", printable(line).c_str());
    }
}

}  // namespace

Result<int> simulated_run(machine::CoreLaunch launch, const PreparedJob& job, const SimulatedRun& what) {
    const std::vector<std::string> trace_paths = launch.trace_paths;
    OperatorBreak operator_break;
    // On the real clock the pins may be too fast for this computer.
    const bool must_be_verified = !launch.on_real_clock;
    auto core = machine::VerifiedCore::start(
        std::move(launch), job.view, job.profile,
        what.piece != nullptr ? follower_of(*what.piece) : verify::Verifier::Follower{},
        what.asked.value_or(verify::AskedCarving{}));
    if (!core) return core.error();
    const machine::JobRun run = watched_run(*core, job.view, what, operator_break);
    RunReport report = report_of(job.view, run);
    auto verification = finish(*core, run, operator_break, report);
    if (what.asked && is_recording_repeated(report))
        add_recorded_verification(report, std::move(verification));
    else
        add_verification(report, std::move(verification));
    pass_on_messages(core->core().messages(), trace_paths, report);
    warn_of_lost_pins(report);
    add_picture(report, job.view, core->surface(), what.picture_path);
    if (what.piece != nullptr) add_piece(report, *what.piece);
    if (must_be_verified) require_verification(report);
    return print_run(report, what.as_json);
}

}  // namespace psicarve::cli
