// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "hmi/cam/job_pulses.hpp"
#include "hmi/cam/least_time.hpp"
#include "hmi/cam/path_length.hpp"
#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/machine/planned_time.hpp"
#include "hmi/piece/expected_piece.hpp"
#include "hmi/report/job_passes.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr CommandText kEstimateText{
    "estimate", "How long a job takes, and what it removes, without carving it",
    "A private core plans the job from end to end, as it will when it carves; nothing moves and no running "
    "core is disturbed.\nWhat it removes is what the profile's tool takes off the blank along the tables.",
    "psicarve estimate figurine.stl --layers 500 --points 500 --tool ball:3\n"
    "psicarve estimate figurine.job --json"};

constexpr std::size_t kColumns = 720;

struct EstimateOptions {
    std::string path;
    ModelOptions model;
};

struct Estimate {
    machine::PlannedTime planned;
    cam::LeastTime least;
    std::vector<cam::LayerPath> layer_paths;
    cam::LayerPath path;  ///< of all layers
    cam::PulseCounts pulses{};
    double removed_mm3 = 0.0;

    /// The time beyond straight ways at full speed: acceleration, and links between layers.
    double changes_seconds() const { return std::max(0.0, planned.carve_seconds - least.total()); }
    double share(double seconds) const {
        return planned.carve_seconds > 0.0 ? std::min(1.0, seconds / planned.carve_seconds) : 0.0;
    }
};

Result<Estimate> estimate_of(const PreparedJob& job, const std::string& path) {
    Estimate estimate;
    const auto planned = machine::planned_time(job.blob, job.view, job.profile);
    if (!planned) return planned.error();
    estimate.planned = *planned;
    estimate.least = cam::least_time_of(job.view, job.profile);
    estimate.layer_paths = cam::layer_paths(job.view, job.profile, estimate.least);
    for (const cam::LayerPath& layer : estimate.layer_paths) estimate.path += layer;
    estimate.pulses = cam::pulses_to_end(job.view, job.profile).front();
    const auto geometry = verify::JobGeometry::make(job.view, job.profile);
    if (!geometry) return bad_input(path + ": " + geometry.error().message);
    estimate.removed_mm3 = piece::expected_piece(*geometry, job.profile, kColumns).removed_mm3();
    return estimate;
}

std::string json_of(const PreparedJob& job, const Estimate& estimate) {
    Json bound{{"feed", estimate.share(estimate.least.feed_seconds)}};
    Json pulses;
    for (const Axis axis : kAllAxes) {
        pulses[std::string{name_of(axis)}] = estimate.pulses[index_of(axis)];
        if (axis != Axis::y)
            bound[std::string{name_of(axis)}] = estimate.share(estimate.least.axis_seconds[index_of(axis)]);
    }
    bound["acceleration"] = estimate.share(estimate.changes_seconds());
    const auto& reference = estimate.planned.reference_seconds;
    const Json object{
        {"source", std::string{job.view.source_name()}},
        {"layers", job.view.layer_count()},
        {"points", job.view.point_count()},
        {"carve_seconds", estimate.planned.carve_seconds},
        {"reference_seconds", reference ? Json(*reference) : Json(nullptr)},
        {"least_seconds", estimate.least.total()},
        {"passes", report::passes_json(job.view, estimate.planned.layer_seconds, estimate.layer_paths)},
        {"bound_by", bound},
        {"path_mm", report::heads_json(estimate.path.cutting_mm)},
        {"links_mm", report::heads_json(estimate.path.link_mm)},
        {"total_mm", report::heads_json(estimate.path.total_mm())},
        {"pulses", pulses},
        {"removed_mm3", estimate.removed_mm3}};
    return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string bound_text(const Estimate& estimate) {
    std::string text;
    const auto add = [&text, &estimate](const std::string& what, double seconds) {
        const auto percent = std::llround(100.0 * estimate.share(seconds));
        if (percent > 0) text += (text.empty() ? "" : ", ") + what + " " + std::to_string(percent) + " %";
    };
    add("feed", estimate.least.feed_seconds);
    for (const Axis axis : {Axis::r1, Axis::r2, Axis::psi})
        add("top speed of " + std::string{name_of(axis)}, estimate.least.axis_seconds[index_of(axis)]);
    add("acceleration and links between layers", estimate.changes_seconds());
    return text;
}

/// "R1 120 mm, R2 118 mm".
std::string lengths_text(const std::array<double, 2>& by_head_mm) {
    return "R1 " + std::to_string(std::llround(by_head_mm[0])) + " mm, R2 " +
           std::to_string(std::llround(by_head_mm[1])) + " mm";
}

std::string text_of(const PreparedJob& job, const Estimate& estimate) {
    std::string text = "job        " + std::string{job.view.source_name()} + ": " +
                       std::to_string(job.view.layer_count()) + " layers x " +
                       std::to_string(job.view.point_count()) + " points\n";
    text +=
        "carving    " + clock_text(estimate.planned.carve_seconds) + ", without approach and retraction\n";
    const auto passes = report::passes_of(job.view, estimate.planned.layer_seconds, estimate.layer_paths);
    for (const report::PassLayers& pass : passes) {
        if (passes.size() > 1)
            text += "pass       " + pass.name + ": " + std::to_string(pass.layers) + " layers, " +
                    clock_text(pass.seconds) + ", path " + lengths_text(pass.path.cutting_mm) + ", links " +
                    lengths_text(pass.path.link_mm) + "\n";
    }
    if (const auto& reference = estimate.planned.reference_seconds)
        text += "reference  " + clock_text(*reference) + "\n";
    text += "bound by   " + bound_text(estimate) + "\n";
    text += "path       " + lengths_text(estimate.path.cutting_mm) + " over the surface\n";
    text += "links      " + lengths_text(estimate.path.link_mm) + " between layers and passes\n";
    text += "total      " + lengths_text(estimate.path.total_mm()) + ", without approach and retraction\n";
    return text + "removed    " + std::to_string(std::llround(estimate.removed_mm3)) + " mm3\n";
}

Result<int> run_estimate(const CommonOptions& common, const EstimateOptions& options) {
    const auto job = prepare_job(options.path, options.model, common);
    if (!job) return job.error();
    const auto estimate = estimate_of(*job, options.path);
    if (!estimate) return estimate.error();
    clear_progress_line();
    std::printf("%s", (common.json ? json_of(*job, *estimate) + "\n" : text_of(*job, *estimate)).c_str());
    return kExitDone;
}

}  // namespace

void add_estimate(CommandSet& commands) {
    const auto options = std::make_shared<EstimateOptions>();
    Syntax syntax = commands.add(
        kEstimateText, [options](const CommonOptions& common) { return run_estimate(common, *options); });
    syntax.input("MODEL|JOB", options->path,
                 "A mesh, drawing, picture or table, as slice takes them, or a job or snapshot file");
    add_model_options(syntax, options->model);
}

}  // namespace psicarve::cli
