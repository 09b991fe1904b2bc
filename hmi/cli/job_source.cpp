// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/job_source.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <thread>
#include <utility>

#include "hmi/cam/job_builder.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/model/load_mesh.hpp"

namespace psicarve::cli {
namespace {

constexpr std::uint32_t kMostLayers = 1'000'000;
constexpr std::uint32_t kMostPoints = 1'000'000;
constexpr std::uint32_t kLeastPoints = 2;
constexpr std::uint32_t kMostThreads = 256;

bool parse_number(std::string_view text, double& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

/// "X,Y", "origin", "best" or "centre".
Result<void> read_axis_at(const std::string& text, cam::JobOptions& options) {
    if (text.empty() || text == "centre") return {};
    if (text == "origin") {
        options.axis_at = cam::AxisAt::origin;
        return {};
    }
    if (text == "best") {
        options.axis_at = cam::AxisAt::best;
        return {};
    }
    const std::size_t comma = text.find(',');
    const std::string_view all{text};
    if (comma == std::string::npos || !parse_number(all.substr(0, comma), options.axis_x) ||
        !parse_number(all.substr(comma + 1), options.axis_y)) {
        return Error{ErrorCode::bad_usage,
                     "--axis-at: '" + text + "' is none of X,Y (as in 1.5,-2), origin, best"};
    }
    options.axis_at = cam::AxisAt::point;
    return {};
}

Result<cam::JobOptions> job_options(const ModelOptions& options) {
    cam::JobOptions job;
    if (options.layer_count > 0) job.layer_count = options.layer_count;
    if (options.point_count > 0) job.point_count = options.point_count;
    if (options.up == "x") job.up = slice::Up::x;
    if (options.up == "y") job.up = slice::Up::y;
    if (const auto read = read_axis_at(options.axis_at, job); !read) return read.error();
    job.height_mm = options.height_mm;
    job.scale = options.scale;
    job.joining = joining_from_name(options.joining);
    job.thread_count =
        options.thread_count > 0 ? options.thread_count : std::max(1U, std::thread::hardware_concurrency());
    return job;
}

bool has_any(const ModelOptions& options) {
    return options.layer_count > 0 || options.point_count > 0 || !options.up.empty() ||
           !options.axis_at.empty() || !options.joining.empty() || options.height_mm || options.scale;
}

Result<PreparedJob> slice_model(const std::string& path, const ModelOptions& options,
                                const CommonOptions& common) {
    auto how = job_options(options);
    if (!how) return how.error();
    const auto profile = chosen_profile(common);
    if (!profile) return profile.error();
    const auto mesh = model::load_mesh(path);
    if (!mesh) return mesh.error();
    auto built = [&] {
        ProgressBar bar{"slicing"};
        const auto show = [&bar](const char* phase) {
            return [&bar, phase](double done_ratio) {
                bar.relabel(phase);
                bar.update(done_ratio);
                return true;
            };
        };
        how->progress = show("slicing");
        how->search_progress = show("finding the best axis");
        return cam::build_job(*mesh, *profile, *how);
    }();
    if (!built) return built.error();
    auto job = cam::prepare_blob(job_blob_from_table(built->table), *profile, path);
    if (job) job->warnings = std::move(built->report.warnings);
    if (job) job->notes = std::move(built->report.notes);
    return job;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

}  // namespace

void add_model_options(Syntax& syntax, ModelOptions& options) {
    syntax
        .option("--layers", options.layer_count, 1, kMostLayers,
                "Layers over the model's height (default 500)")
        .option("--points", options.point_count, kLeastPoints, kMostPoints,
                "Points per head and layer, half a turn (default 500)")
        .choice("--up", options.up, {"x", "y", "z"}, "The model's axis that stands upright (default z)")
        .option("--axis-at", options.axis_at, "X,Y|origin|best",
                "Where the rotation axis passes through the model (default: the middle of its bounding box)")
        .option("--height", options.height_mm, "MM", "Scale the model, uniformly, to this height")
        .option("--scale", options.scale, "F", "Scale the model, uniformly, by this factor")
        .excludes("--height", "--scale")
        .choice("--joining", options.joining, {"continuous", "zigzag", "spiral"},
                "How one layer follows another (default: the profile's); a spiral rises as it turns")
        .option("--threads", options.thread_count, 1, kMostThreads,
                "Threads that slice (default: one a processor); the job is the same for any number");
}

Result<Profile> chosen_profile(const CommonOptions& common) {
    if (common.profile.empty()) return Profile{};
    if (!is_snapshot_file(common.profile)) return load_profile(common.profile);
    const auto snapshot = load_snapshot(common.profile);
    if (!snapshot) return snapshot.error();
    const auto job = JobView::check(snapshot->job_blob);
    if (!job) return bad_input(common.profile + ": holds no job, and so no profile");
    return job_profile(*job);
}

Result<PreparedJob> job_of_snapshot(Snapshot snapshot, const std::string& path, const CommonOptions& common) {
    auto job = cam::prepare_snapshot(std::move(snapshot), path);
    if (!job || common.profile.empty()) return job;
    auto other = chosen_profile(common);
    if (!other) return other.error();
    const auto differing = motion_differences(job->profile, *other);
    if (!differing.empty()) {
        return bad_input(path + ": made for another machine than " + common.profile + ": " +
                         joined(differing) + " differ; slice the model again with that profile");
    }
    return cam::prepare_blob(std::move(job->blob), std::move(other).value(), path);
}

Result<PreparedJob> prepare_job(const std::string& path, const ModelOptions& options,
                                const CommonOptions& common) {
    auto job = [&]() -> Result<PreparedJob> {
        if (!is_snapshot_file(path)) return slice_model(path, options, common);
        if (has_any(options)) {
            return Error{ErrorCode::bad_usage,
                         path + " is a job and already sliced: options for models do not apply"};
        }
        auto snapshot = load_snapshot(path);
        if (!snapshot) return snapshot.error();
        return job_of_snapshot(std::move(snapshot).value(), path, common);
    }();
    if (job) {
        for (const std::string& warning : job->warnings) print_warning(warning);
        for (const std::string& note : job->notes) print_note(note);
    }
    return job;
}

Result<void> check_output_folder(const std::string& path) {
    namespace fs = std::filesystem;
    if (path.empty()) return {};
    std::error_code error;
    if (fs::is_directory(path, error)) return bad_input(path + ": is a folder, not a file to write");
    const fs::path folder = fs::path{path}.has_parent_path() ? fs::path{path}.parent_path() : fs::path{"."};
    if (access(folder.c_str(), W_OK | X_OK) == 0) return {};
    return bad_input(path + ": cannot be written: " + std::strerror(errno));
}

}  // namespace psicarve::cli
