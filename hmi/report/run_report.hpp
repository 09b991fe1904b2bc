// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hmi/machine/job_run.hpp"
#include "hmi/piece/piece_deviation.hpp"
#include "hmi/report/lost_steps.hpp"
#include "hmi/verify/verify_report.hpp"
#include "shared/job/job.hpp"

namespace psicarve::report {

/// The result of a run: what `carve` and `replay` print in the end, and the window's report.
struct RunReport {
    std::string source_name;
    std::uint32_t layer_count = 0;
    std::uint32_t point_count = 0;
    machine::RunFigures figures;
    std::optional<double> seconds_so_far;  ///< carved before it was cut short, as the pins tell
    bool has_started = false;              ///< the machine has begun to work on the job
    double wall_seconds = 0.0;
    std::optional<double> reference_seconds;
    std::optional<verify::VerifyReport>
        verification;  ///< nothing: not verified, `unverified_reason` says why
    std::string unverified_reason;
    std::optional<double> undercut_share;  ///< as the slicer measured it; nothing: the job does not say
    std::optional<std::uint64_t> open_points;
    std::optional<Error> failure;
    std::string picture_path;  ///< if it was written
    std::string piece_path;    ///< if it was written
    std::string deviation_path;
    std::optional<piece::PieceDeviation> deviation;  ///< of the piece from the model, if asked for
    CoreStatus before{};                             ///< the core's status when the run began
    CoreStatus last{};
    TableSize table;
    std::string lost_steps;  ///< what the simulated machine did not do in this run, in words; empty: nothing
};

/// Begins a report with what the job says about itself.
RunReport report_of(const JobView& job, const machine::JobRun& run);

/// The error that ends the command: the failure, else a difference that verification found.
std::optional<Error> verdict_of(const RunReport& report);

/// Correct pins do not make the piece when the machine did not follow them; nothing: not verified.
std::optional<bool> is_verified(const RunReport& report);

/// The first difference that verification found.
std::string difference_text(const verify::VerifyReport& seen);

/// The exit code of an error. "Bad input" promises that nothing was changed, which no longer holds once a job
/// has started: a file that could not be written after that gets the code of a machine's failure.
int run_exit_code(const RunReport& report, const Error& error);

/// As `carve --json` prints it.
std::string run_json(const RunReport& report);

}  // namespace psicarve::report
