// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_facts.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/model_report.hpp"
#include "hmi/cli/standard_streams.hpp"
#include "hmi/machine/planned_time.hpp"
#include "hmi/report/job_passes.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr CommandText kSliceText{"slice", "Model to job, nothing else", "",
                                 "psicarve slice figurine.stl -o figurine.job --layers 500 --points 500"};

struct SliceOptions {
    std::string path;
    std::string output;
    std::string preview;
    bool wants_time = false;
    ModelOptions model;
};

using PlannedTime = std::optional<machine::PlannedTime>;

std::string report_text(const PreparedJob& job, const std::string& output, const PlannedTime& planned) {
    const auto report = nlohmann::json::parse(job.view.report_json(), nullptr, false);
    char line[160];
    int used = std::snprintf(line, sizeof line, ": %u layers x %u points", job.view.layer_count(),
                             job.view.point_count());
    if (report.is_object() && report.contains("undercut_share")) {
        std::snprintf(line + used, sizeof line - static_cast<std::size_t>(used),
                      ", undercut %.2f %%, open points %llu", 100.0 * report.value("undercut_share", 0.0),
                      static_cast<unsigned long long>(report.value("open_points", std::uint64_t{0})));
    }
    const std::string passes =
        job.view.passes().size() > 1 ? "\npasses: " + report::passes_text(job.view) : std::string{};
    return output + line + passes + "\nsize: " + size_text(job_size(job.view, job.profile)) +
           (planned ? "\ncarving: " + time_text(*planned) : "");
}

std::string report_json(const PreparedJob& job, const std::string& output, const PlannedTime& planned) {
    const Json slicer = Json::parse(job.view.report_json(), nullptr, false);
    const auto told = [&slicer](const char* key) {
        return slicer.is_object() && slicer.contains(key) ? slicer[key] : Json(nullptr);
    };
    Json object{{"job", output},
                {"source", std::string{job.view.source_name()}},
                {"layers", job.view.layer_count()},
                {"points", job.view.point_count()},
                {"psi_sweep_pulses", job.view.psi_sweep_pulses()},
                {"joining", name_of(job.view.joining())},
                {"passes", report::passes_json(job.view)},
                {"undercut_share", told("undercut_share")},
                {"open_points", told("open_points")},
                {"report", slicer.is_discarded() ? Json(nullptr) : slicer}};
    object["size"] = size_json(job_size(job.view, job.profile));
    object.update(time_json(planned));
    return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<int> slice(const CommonOptions& common, const SliceOptions& options) {
    // A job replaces a file, which a pipe or a device is not.
    if (!is_standard_output(options.output)) {
        if (const auto writable = check_writable(options.output); !writable) return writable.error();
    }
    if (const auto writable = check_preview(options.preview); !writable) return writable.error();
    if (const auto good = check_standard_output(options.output, common.json); !good) return good.error();
    if (is_snapshot_file(options.path)) return bad_input(options.path + ": is a job already, not a model");
    ModelOptions model = options.model;
    model.keeps_mesh = !options.preview.empty();
    auto job = prepare_job(options.path, model, common);
    if (!job) return job.error();
    if (!options.preview.empty()) {
        const auto report = ModelReport::make(*job);
        if (!report) return report.error();
        if (const auto drawn = report->write_preview(options.preview); !drawn) return drawn.error();
    }
    PlannedTime planned;
    if (options.wants_time) {
        auto found = machine::planned_time(job->blob, job->view, job->profile);
        if (!found) return found.error();
        planned = std::move(*found);
    }
    // A job file is a snapshot without a status. The blob moves, the view's pointers into it stay valid.
    Snapshot file;
    file.job_blob = std::move(job->blob);
    const std::string report =
        common.json ? report_json(*job, options.output, planned) : report_text(*job, options.output, planned);
    if (is_standard_output(options.output)) {
        if (const auto written = write_snapshot(file, STDOUT_FILENO, "standard output"); !written)
            return written.error();
        print_note(report);
        return kExitDone;
    }
    if (const auto saved = save_snapshot(file, options.output); !saved) return saved.error();
    std::printf("%s\n", report.c_str());
    return kExitDone;
}

}  // namespace

void add_slice(CommandSet& commands) {
    const auto options = std::make_shared<SliceOptions>();
    Syntax syntax =
        commands.add(kSliceText, [options](const CommonOptions& common) { return slice(common, *options); });
    syntax
        .input("MODEL", options->path,
               "A mesh (STL, OBJ, PLY, 3MF, OFF), a drawing (SVG, DXF), a picture (PNG, JPEG, TIFF, BMP, "
               "PGM) or a table (CSV)")
        .required_option("-o,--output", options->output, "JOB",
                         "The job file to write; - writes to standard output")
        .option(
            "--preview,--picture", options->preview, "OUT.png",
            "Draw the piece that the profile's tool would leave, from two sides, with what inspect tells");
    add_time_option(syntax, options->wants_time);
    add_model_options(syntax, options->model);
}

}  // namespace psicarve::cli
