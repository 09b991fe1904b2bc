// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "shared/snapshot_file.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kText{"slice", "Model to job, nothing else", "",
                            "psicarve slice figurine.stl -o figurine.job --layers 500 --points 500"};

struct Options {
    std::string path;
    std::string output;
    ModelOptions model;
};

std::string report_text(const PreparedJob& job, const std::string& output) {
    const auto report = nlohmann::json::parse(job.view.report_json(), nullptr, false);
    const double undercut = report.is_object() ? report.value("undercut_share", 0.0) : 0.0;
    const std::uint64_t open = report.is_object() ? report.value("open_points", std::uint64_t{0}) : 0;
    char line[160];
    std::snprintf(line, sizeof line, ": %u layers x %u points, undercut %.2f %%, open points %llu",
                  job.view.layer_count(), job.view.point_count(), 100.0 * undercut,
                  static_cast<unsigned long long>(open));
    return output + line;
}

std::string report_json(const PreparedJob& job, const std::string& output) {
    using Json = nlohmann::ordered_json;
    const Json slicer = Json::parse(job.view.report_json(), nullptr, false);
    const Json object{{"job", output},
                      {"source", std::string{job.view.source_name()}},
                      {"layers", job.view.layer_count()},
                      {"points", job.view.point_count()},
                      {"psi_sweep_pulses", job.view.psi_sweep_pulses()},
                      {"joining", name_of(job.view.joining())},
                      {"undercut_share", slicer.is_object() ? slicer.value("undercut_share", 0.0) : 0.0},
                      {"open_points", slicer.is_object() ? slicer.value("open_points", std::uint64_t{0}) : 0},
                      {"report", slicer.is_discarded() ? Json(nullptr) : slicer}};
    return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<int> slice(const CommonOptions& common, const Options& options) {
    if (const auto writable = check_output_folder(options.output); !writable) return writable.error();
    if (is_snapshot_file(options.path)) return bad_input(options.path + ": is a job already, not a model");
    auto job = prepare_job(options.path, options.model, common);
    if (!job) return job.error();
    // A job file is a snapshot without a status. The blob moves, the view's pointers into it stay good.
    Snapshot file;
    file.job_blob = std::move(job->blob);
    if (const auto saved = save_snapshot(file, options.output); !saved) return saved.error();
    const std::string report =
        common.json ? report_json(*job, options.output) : report_text(*job, options.output);
    std::printf("%s\n", report.c_str());
    return kExitDone;
}

}  // namespace

void add_slice(CommandSet& commands) {
    const auto options = std::make_shared<Options>();
    Syntax syntax =
        commands.add(kText, [options](const CommonOptions& common) { return slice(common, *options); });
    syntax.argument("MODEL", options->path, "A mesh: STL, OBJ, PLY, 3MF or OFF")
        .required_option("-o,--output", options->output, "JOB", "The job file to write");
    add_model_options(syntax, options->model);
}

}  // namespace psicarve::cli
