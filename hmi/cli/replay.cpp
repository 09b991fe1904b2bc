// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/replay_program.hpp"
#include "hmi/cli/simulated_run.hpp"
#include "hmi/machine/private_segment.hpp"
#include "hmi/machine/unique_fd.hpp"
#include "hmi/trace/carried_job.hpp"
#include "hmi/verify/asked_carving.hpp"
#include "shared/machine/unreplayed_program.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kReplayText{
    "replay", "A job or a recorded snapshot again, through a private core on the virtual clock",
    "Begins homed at the home positions. A job, and that of a trace, is run whole; of a snapshot, what its "
    "flight recorder holds\n"
    "from a moment on at which the machine was homed and at rest; without one it is refused, and carve\n"
    "carves its job. The same file gives the same pins to the last bit.\n"
    "With --program, of a snapshot, its last program in G-code from the rest before it on: FILE is the text\n"
    "that was run, and is refused where it is another one.",
    "psicarve replay figurine.job --trace pins.vcd --json\n"
    "  psicarve replay run.snap --program pocket.ngc"};

struct ReplayOptions {
    std::string path;
    std::string trace;
    std::string picture;
    std::string program;
    bool real_time = false;
};

Result<int> replay(const CommonOptions& common, const ReplayOptions& options) {
    for (const std::string& path : {options.picture, options.trace}) {
        if (const auto writable = check_output_folder(path); !writable) return writable.error();
    }
    const bool is_trace = verify::is_binary_trace(options.path);
    auto snapshot = load_job_file(options.path, "name a job or snapshot file instead");
    if (!snapshot) return snapshot.error();
    if (!options.program.empty()) {
        if (!snapshot->status && snapshot->records.empty())
            return bad_input(options.path + ": --program is for a snapshot of a machine");
        return replay_program(common, {options.path, options.program, options.trace}, *snapshot);
    }
    const std::string program = unreplayed_program_text(snapshot->records);
    if (snapshot->job_blob.empty() && !program.empty()) return bad_input(options.path + ": " + program);
    Result<machine::UniqueFd> file = machine::UniqueFd{};
    if (is_trace) file = machine::open_memory_file("job", snapshot_bytes(*snapshot));
    if (!file) return file.error();
    const std::vector<FlightRecord> records = snapshot->records;
    const std::uint64_t points_done = snapshot->status ? snapshot->status->points_done : 0;
    const auto job = job_of_snapshot(std::move(snapshot).value(), options.path, common);
    if (!job) return job.error();
    for (const std::string& warning : job->warnings) print_warning(warning);
    machine::CoreLaunch launch;
    // Private: a core on the named segment is not disturbed.
    machine::remove_stale_private_segments();
    launch.segment_name = machine::private_segment_name();
    launch.is_private = true;
    launch.on_real_clock = options.real_time;
    launch.replay_path = is_trace ? "/proc/self/fd/" + std::to_string(file->get()) : options.path;
    if (is_trace) launch.inherited_fds.push_back(file->get());
    launch.capacity_layers = job->view.layer_count();
    launch.capacity_points = job->view.point_count();
    if (!options.trace.empty()) launch.trace_paths.push_back(options.trace);
    const auto run_it = [](machine::VerifiedCore& core, const machine::StatusWatch& watch) {
        return machine::follow_replay(core.link(), core.core(), watch);
    };
    return simulated_run(std::move(launch), *job,
                         {run_it, options.picture, common.json, nullptr,
                          verify::asked_carving(job->view, records, points_done)});
}

}  // namespace

void add_replay(CommandSet& commands) {
    const auto options = std::make_shared<ReplayOptions>();
    commands.add(kReplayText, [options](const CommonOptions& common) { return replay(common, *options); })
        .input("JOB|TRACE", options->path, "A job or snapshot file, or a trace that carries its job")
        .option("--trace", options->trace, "FILE", "Record every pin: .vcd, or compact binary")
        .picture_option(options->picture)
        .option("--program", options->program, "FILE",
                "Of a snapshot, its program in G-code, whose text is in this file")
        .flag("--real-time", options->real_time, "By the wall clock, to watch with psicarve status")
        .excludes("--program", "--picture")
        .excludes("--program", "--real-time");
}

}  // namespace psicarve::cli
