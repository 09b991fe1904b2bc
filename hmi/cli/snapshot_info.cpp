// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "hmi/cli/checkpoint_text.hpp"
#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_facts.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/model_report.hpp"
#include "hmi/cli/program_text.hpp"
#include "hmi/cli/source_text.hpp"
#include "hmi/cli/status_text.hpp"
#include "hmi/report/job_passes.hpp"
#include "hmi/report/record_text.hpp"
#include "hmi/report/status_json.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/recorded_program.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr CommandText kSnapshotInfoText{
    "info", "What a snapshot or job file holds",
    "--records says how much of the flight recorder is listed (the newest), 0 for none.",
    "psicarve snapshot info before-repair.snap --records 100"};
constexpr std::uint32_t kMostRecords = 1'000'000;

struct SnapshotInfoOptions {
    std::string path;
    std::uint32_t record_count = 20;
    std::string picture;
    bool wants_time = false;
};

/// The job and the values calculated from it.
struct InfoJob {
    JobView view;  ///< into the snapshot
    Result<Profile> profile;
    std::optional<machine::PlannedTime> planned;
};

struct Extent {
    std::int32_t least = 0;
    std::int32_t greatest = 0;
};

Extent radius_extent(const JobView& job) {
    Extent extent{job.r_left_pulses(0)[0], job.r_left_pulses(0)[0]};
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        for (const auto row : {job.r_left_pulses(layer), job.r_right_pulses(layer)}) {
            const auto [least, greatest] = std::minmax_element(row.begin(), row.end());
            extent.least = std::min(extent.least, *least);
            extent.greatest = std::max(extent.greatest, *greatest);
        }
    }
    return extent;
}

Json job_json(const InfoJob& shown) {
    const JobView& job = shown.view;
    const Extent extent = radius_extent(job);
    const auto heights = job.layer_heights_pulses();
    const auto& profile = shown.profile;
    const Json slicer = Json::parse(job.report_json(), nullptr, false);
    Json object{{"source", std::string{job.source_name()}},
                {"source_hash", hash_text(job.header().source_hash)},
                {"layers", job.layer_count()},
                {"points", job.point_count()},
                {"psi_sweep_pulses", job.psi_sweep_pulses()},
                {"joining", name_of(job.joining())},
                {"passes", report::passes_json(job)},
                {"feed_mm_s", job.header().feed_mm_s},
                {"y_pulses", {heights.front(), heights.back()}},
                {"r_pulses", {extent.least, extent.greatest}},
                {"size", profile ? size_json(job_size(job, *profile)) : Json(nullptr)},
                {"profile_name", profile ? Json(profile->name) : Json(nullptr)},
                {"profile", std::string{job.profile_toml()}},
                {"slice_report", slicer.is_discarded() ? Json(nullptr) : slicer}};
    object.update(time_json(shown.planned));
    return object;
}

bool is_of_job(const Snapshot& snapshot) {
    return snapshot.checkpoint && snapshot.checkpoint->job_checksum == job_checksum(snapshot.job_blob);
}

ProgramStatus program_of(const Snapshot& snapshot) {
    return recorded_program(snapshot.records, snapshot.status ? &*snapshot.status : nullptr);
}

Json info_json(const Snapshot& snapshot, const std::optional<InfoJob>& job, std::size_t first_record) {
    auto records = Json::array();
    for (std::size_t i = first_record; i < snapshot.records.size(); ++i) {
        records.push_back(report::record_json(snapshot.records[i]));
    }
    return {{"kind", snapshot.status || !snapshot.records.empty() ? "snapshot" : "job"},
            {"generation", snapshot.generation},
            {"capacity_layers", snapshot.capacity_layers},
            {"capacity_points", snapshot.capacity_points},
            {"job", job ? job_json(*job) : Json(nullptr)},
            {"status", snapshot.status ? report::status_json(*snapshot.status) : Json(nullptr)},
            {"checkpoint", checkpoint_json(snapshot.checkpoint, is_of_job(snapshot))},
            {"program", recorded_program_json(program_of(snapshot))},
            {"program_source", source_json(snapshot.source.get())},
            {"record_count", snapshot.records.size()},
            {"records", records}};
}

void print_job(const InfoJob& shown) {
    const JobView& job = shown.view;
    const Extent extent = radius_extent(job);
    const auto heights = job.layer_heights_pulses();
    std::printf("source     %s (%s)\n", std::string{job.source_name()}.c_str(),
                hash_text(job.header().source_hash).c_str());
    std::printf("tables     %u layers x %u points, %s\n", job.layer_count(), job.point_count(),
                std::string{name_of(job.joining())}.c_str());
    if (job.passes().size() > 1) std::printf("passes     %s\n", report::passes_text(job).c_str());
    std::printf("sweep      %lld pulses of psi a layer\n", static_cast<long long>(job.psi_sweep_pulses()));
    if (shown.profile) std::printf("size       %s\n", size_text(job_size(job, *shown.profile)).c_str());
    if (shown.planned) std::printf("carving    %s\n", time_text(*shown.planned).c_str());
    std::printf("heights    %lld to %lld pulses\n", static_cast<long long>(heights.front()),
                static_cast<long long>(heights.back()));
    std::printf("radii      %d to %d pulses\n", extent.least, extent.greatest);
    std::printf("feed       %g mm/s\n", job.header().feed_mm_s);
    std::printf("profile    %s\n%s",
                shown.profile ? shown.profile->name.c_str() : shown.profile.error().message.c_str(),
                slicer_text(job).c_str());
}

void print_info(const Snapshot& snapshot, const std::optional<InfoJob>& job, std::size_t first_record) {
    if (job) {
        print_job(*job);
    } else {
        std::printf("no job\n");
    }
    if (snapshot.status) {
        // A core accepts no job of a machine with other counts.
        const bool is_jobs_machine = job && job->profile && snapshot.status->points_total > 0 &&
                                     snapshot.status->job_generation == snapshot.generation;
        std::printf("\ngeneration %llu of a segment for %u x %u\n%s",
                    static_cast<unsigned long long>(snapshot.generation), snapshot.capacity_layers,
                    snapshot.capacity_points,
                    status_text(*snapshot.status, is_jobs_machine ? &*job->profile : nullptr).c_str());
    }
    std::printf("%s", checkpoint_text(snapshot.checkpoint, is_of_job(snapshot)).c_str());
    const bool may_run = !snapshot.status || runs_job(snapshot.status->state);
    std::printf("%s", recorded_program_text(program_of(snapshot), may_run).c_str());
    std::printf("%s", source_text(snapshot.source.get()).c_str());
    if (snapshot.records.empty() || first_record == snapshot.records.size()) return;
    std::printf("\nflight recorder, the last %zu of %zu entries\n", snapshot.records.size() - first_record,
                snapshot.records.size());
    for (std::size_t i = first_record; i < snapshot.records.size(); ++i) {
        std::printf("%s\n", report::record_text(snapshot.records[i]).c_str());
    }
}

/// Nothing: it holds none.
Result<std::optional<InfoJob>> shown_job(const Snapshot& snapshot, const CommonOptions& common,
                                         const SnapshotInfoOptions& options) {
    if (snapshot.job_blob.empty()) {
        if (options.picture.empty() && !options.wants_time) return std::optional<InfoJob>{};
        return bad_input(options.path + ": holds no job, and so nothing to draw or to plan");
    }
    const auto view = JobView::check(snapshot.job_blob);
    if (!view) return bad_input(options.path + ": " + view.error().message);
    InfoJob shown{*view, job_profile(*view), {}};
    if (options.picture.empty() && !options.wants_time) return std::optional{std::move(shown)};
    // These two need a job that a machine can carve; the text does not.
    const auto job = job_of_snapshot(snapshot, options.path, common);
    if (!job) return job.error();
    if (options.wants_time) {
        auto planned = machine::planned_time(job->blob, job->view, job->profile);
        if (!planned) return planned.error();
        shown.planned = std::move(*planned);
    }
    if (options.picture.empty()) return std::optional{std::move(shown)};
    const auto model = ModelReport::make(*job);
    if (!model) return model.error();
    if (const auto drawn = model->write_preview(options.picture); !drawn) return drawn.error();
    return std::optional{std::move(shown)};
}

Result<int> info(const CommonOptions& common, const SnapshotInfoOptions& options) {
    if (const auto writable = check_preview(options.picture); !writable) return writable.error();
    const auto snapshot = load_snapshot(options.path);
    if (!snapshot) return snapshot.error();
    const auto job = shown_job(*snapshot, common, options);
    if (!job) return job.error();
    const std::size_t shown = std::min<std::size_t>(snapshot->records.size(), options.record_count);
    const std::size_t first_record = snapshot->records.size() - shown;
    if (common.json) {
        const Json object = info_json(*snapshot, *job, first_record);
        std::printf("%s\n", object.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
    } else {
        print_info(*snapshot, *job, first_record);
    }
    return kExitDone;
}

}  // namespace

void add_snapshot_info(CommandSet& commands) {
    const auto options = std::make_shared<SnapshotInfoOptions>();
    Syntax syntax = commands.add(kSnapshotInfoText,
                                 [options](const CommonOptions& common) { return info(common, *options); });
    add_time_option(syntax, options->wants_time);
    syntax
        .option("--picture", options->picture, "OUT.png",
                "Draw the piece that the job's tool would leave, from two sides")
        .input("FILE", options->path, "A snapshot or job file")
        .option("--records", options->record_count, 0, kMostRecords,
                "Entries of the flight recorder to list (default 20)");
}

}  // namespace psicarve::cli
