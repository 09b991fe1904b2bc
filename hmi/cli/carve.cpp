// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "hmi/cli/carve_queue.hpp"
#include "hmi/cli/carved_piece.hpp"
#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/judged_pins.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/run_report.hpp"
#include "hmi/cli/run_watch.hpp"
#include "hmi/cli/simulated_run.hpp"
#include "hmi/cli/sliced_model.hpp"
#include "hmi/machine/job_run.hpp"
#include "hmi/machine/machine_link.hpp"
#include "hmi/machine/recorded_pins.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kCarveText{
    "carve", "The main job: slice if needed, publish, home if needed, carve, verify, report",
    "Uses the core that serves the segment. When none does, starts one on the "
    "simulated machine with the virtual\n"
    "clock, and ends it. Either way its pins are verified while it runs. Ctrl-C stops "
    "the machine; twice is an\nemergency stop. "
    "Of several workpieces --json prints one object a line, each when its workpiece is done.",
    "psicarve carve figurine.stl --picture carved.png --trace pins.vcd --json\n"
    "  psicarve carve figurine.job letter.job"};

struct CarveOptions {
    std::vector<std::string> paths;
    std::string path;  ///< the one of these that is carved
    bool unattended = false;
    std::string picture;
    std::string trace;
    bool real_time = false;
    ModelOptions model;
    PieceFiles files;
    bool no_deviation = false;
};

/// The segment, if a core serves it. A segment that we may not use is an error, none at all is not.
Result<std::optional<machine::MachineLink>> running_core(const CommonOptions& common) {
    auto link = machine::MachineLink::attach(common.segment, common.group);
    if (!link && link.error().code == ErrorCode::no_core) return std::optional<machine::MachineLink>{};
    if (!link) return link.error();
    if (!link->core_pid()) return std::optional<machine::MachineLink>{};
    return std::optional{std::move(link).value()};
}

Result<void> check_options_for_running_core(const CarveOptions& options, const machine::MachineLink& link) {
    if (!options.real_time) return {};
    return Error{
        ErrorCode::machine_refused,
        "segment " + link.segment_name() + " is served by a running core (pid " +
            std::to_string(link.core_pid().value_or(0)) +
            "): it was started with its clock, and --real-time is for a core of our own; or carve on "
            "a core of our own with another --segment"};
}

machine::JobRun watched_run(machine::MachineLink& link, const PreparedJob& job,
                            OperatorBreak& operator_break) {
    RunWatch watch{link, job.view, operator_break};
    machine::JobRun run = machine::run_job(link, job.blob, watch.watch());
    if (watch.was_stopped() && run.failure) run.failure = watch.stop_error(run.after);
    operator_break.let_third_end_us();
    return run;
}

/// Without its pins a job is carved all the same, unless they were asked for.
Result<int> carve_unseen(machine::MachineLink& link, const PreparedJob& job, const Error& why,
                         const CommonOptions& common) {
    OperatorBreak operator_break;
    RunReport report = report_of(job.view, watched_run(link, job, operator_break));
    report.unverified_reason = why.message;
    return print_run(report, common.json);
}

/// The piece to carve beside the run, compared with the model wherever there is one. An ideal point leaves
/// the table's own surface, and a figure must not hold up a core that does not wait for us: in these cases
/// the piece is calculated only on request.
Result<std::unique_ptr<CarvedPiece>> piece_beside(const PreparedJob& job, const CarveOptions& options,
                                                  bool waits_for_us) {
    auto model = job.mesh;
    const bool is_asked_for = options.files.any();
    if (!is_asked_for && (job.profile.tool.shape == ToolShape::point || !waits_for_us)) model.reset();
    if (!options.files.model.empty()) {
        auto read = model_of_job(options.files.model, job);
        if (!read) return read.error();
        model = std::move(*read);
    }
    auto made = CarvedPiece::make(job, std::move(model), options.files);
    if (made || is_asked_for) return made;
    // A comparison that was not asked for does not keep a job from being carved.
    print_warning("the piece is not compared with the model: " + made.error().message);
    return std::unique_ptr<CarvedPiece>{};
}

Result<int> carve_on_running_core(machine::MachineLink& link, const PreparedJob& job,
                                  const CarveOptions& options, const CommonOptions& common) {
    const auto piece = piece_beside(job, options, false);
    if (!piece) return piece.error();
    auto pins = machine::RecordedPins::start(link, job.view, job.profile, options.trace, follower_of(*piece));
    if (!pins) {
        if (!options.trace.empty() || !options.picture.empty() || options.files.any()) return pins.error();
        return carve_unseen(link, job, pins.error(), common);
    }
    OperatorBreak operator_break;
    RunReport report = report_of(job.view, watched_run(link, job, operator_break));
    add_verification(report, (*pins)->finish());
    if (const auto& failed = (*pins)->trace_failure(); failed && !report.failure) report.failure = *failed;
    warn_of_lost_pins(report);
    add_picture(report, job.view, (*pins)->surface(), options.picture);
    add_piece(report, *piece);
    return print_run(report, common.json);
}

Result<int> carve(const CommonOptions& common, const CarveOptions& options) {
    for (const std::string& path : {options.picture, options.trace}) {
        if (const auto writable = check_output_folder(path); !writable) return writable.error();
    }
    if (const auto writable = check_piece_files(options.files); !writable) return writable.error();
    std::error_code unknown;
    if (!options.files.model.empty() && std::filesystem::exists(options.path, unknown) &&
        !is_snapshot_file(options.path)) {
        return Error{ErrorCode::bad_usage, "--model " + options.files.model + " is for a job file, and " +
                                               options.path + " is none: a model is compared with itself"};
    }
    auto running = running_core(common);
    if (!running) return running.error();
    if (*running) {
        const auto fits = check_options_for_running_core(options, **running);
        if (!fits) return fits.error();
    }
    ModelOptions model = options.model;
    model.keeps_mesh = !options.no_deviation;
    const auto job = prepare_job(options.path, model, common);
    if (!job) return job.error();
    if (*running) return carve_on_running_core(**running, *job, options, common);
    machine::CoreLaunch launch;
    launch.segment_name = common.segment;
    launch.group = common.group;
    launch.on_real_clock = options.real_time;
    // It runs as fast as possible: the part that is done predicts the rest.
    launch.no_estimate = !options.real_time;
    // A core on the real clock is a machine at work: it goes on without us.
    launch.outlives_us = options.real_time;
    launch.capacity_layers = std::max(launch.capacity_layers, job->view.layer_count());
    launch.capacity_points = std::max(launch.capacity_points, job->view.point_count());
    if (!options.trace.empty()) launch.trace_paths.push_back(options.trace);
    const auto run_it = [&job](machine::VerifiedCore& core, const machine::StatusWatch& watch) {
        return machine::run_job(core.link(), job->blob, watch);
    };
    const auto piece = piece_beside(*job, options, !options.real_time);
    if (!piece) return piece.error();
    return simulated_run(std::move(launch), *job, {run_it, options.picture, common.json, &*piece});
}

/// Checks all before the first is carved, so that a fault in the last is not reported hours later. Warnings
/// about a job come when it is carved.
Result<void> check_queue(const CommonOptions& common, const CarveOptions& options) {
    if (options.paths.size() == 1) {
        if (!options.unattended) return {};
        return Error{ErrorCode::bad_usage, "--unattended is for several workpieces"};
    }
    if (!options.picture.empty() || !options.trace.empty() || options.files.any())
        return Error{ErrorCode::bad_usage,
                     "carve: --picture, --trace, --piece, --deviation and --model are of one workpiece"};
    for (const std::string& path : options.paths)
        if (const auto job = prepare_unsaid(path, options.model, common); !job) return job.error();
    return {};
}

Result<int> carve_all(const CommonOptions& common, const CarveOptions& options) {
    return carve_in_turn(options.paths, options.unattended,
                         [&, is_checked = false](const std::string& path) mutable -> Result<int> {
                             if (!is_checked) {
                                 if (const auto good = check_queue(common, options); !good)
                                     return good.error();
                                 is_checked = true;
                             }
                             CarveOptions one = options;
                             one.path = path;
                             return carve(common, one);
                         });
}

}  // namespace

void add_carve(CommandSet& commands) {
    const auto options = std::make_shared<CarveOptions>();
    Syntax syntax = commands.add(
        kCarveText, [options](const CommonOptions& common) { return carve_all(common, *options); });
    syntax
        .inputs(
            "MODEL|JOB", options->paths,
            "A mesh, drawing, picture or table, as slice takes them, or a job or snapshot file; several are "
            "carved one after the other, each once you say that its blank is in")
        .flag("--unattended", options->unattended, "Several: ask nobody for the next blank")
        .picture_option(options->picture)
        .option("--trace", options->trace, "OUT.vcd", "Record every pin: .vcd, or compact binary")
        .flag("--real-time", options->real_time, "A core of our own runs by the wall clock");
    add_piece_options(syntax, options->files);
    syntax
        .flag("--no-deviation", options->no_deviation,
              "Leave out how far the piece that a tool with a size leaves is from the model, for speed")
        .excludes("--no-deviation", "--deviation")
        .excludes("--no-deviation", "--model");

    add_model_options(syntax, options->model);
}

}  // namespace psicarve::cli
