// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/job_source.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <thread>
#include <utility>

#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/job_plan.hpp"
#include "hmi/cam/table_job.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/cli/tool_choice.hpp"
#include "hmi/cli/turn_choice.hpp"
#include "hmi/flat/load_model.hpp"
#include "hmi/machine/core_profile.hpp"
#include "hmi/model/turned_mesh.hpp"
#include "hmi/rough/roughing.hpp"
#include "hmi/trace/carried_job.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/profile/profile_place.hpp"

namespace psicarve::cli {
namespace {

constexpr std::uint32_t kMostLayers = 1'000'000;
constexpr std::uint32_t kMostPoints = 1'000'000;
constexpr std::uint32_t kLeastPoints = 2;
constexpr std::uint32_t kMostThreads = 256;

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
    job.layer_height_mm = options.layer_height_mm;
    job.height_mm = options.height_mm;
    job.scale = options.scale;
    job.fits = options.fits;
    job.compares_axes = options.compares_axes;
    job.joining = joining_from_name(options.joining);
    job.thread_count =
        options.thread_count > 0 ? options.thread_count : std::max(1U, std::thread::hardware_concurrency());
    return job;
}

bool has_any(const ModelOptions& options) {
    return options.layer_count > 0 || options.layer_height_mm || options.point_count > 0 ||
           !options.up.empty() || !options.axis_at.empty() || !options.joining.empty() ||
           !options.tool.empty() || options.flute_mm || !options.blank.empty() || !options.blank_at.empty() ||
           options.depth_limit_mm || options.stepdown_mm || options.allowance_mm || options.stepover_mm ||
           options.finish_only || !options.rotate.empty() || !options.mirror.empty() || options.fits ||
           options.height_mm || options.scale || has_any(options.flat);
}

/// The roughing of the profile, changed by the options.
Result<void> read_roughing(const ModelOptions& options, Profile& profile) {
    RoughingProfile& roughing = profile.roughing;
    const bool has_details = options.allowance_mm || options.stepover_mm;
    if (options.finish_only && (options.stepdown_mm || has_details)) {
        return Error{ErrorCode::bad_usage,
                     "--finish-only excludes --stepdown, --allowance and --stepover: these are of roughing"};
    }
    if (options.finish_only) roughing.stepdown_mm = 0.0;
    roughing.stepdown_mm = options.stepdown_mm.value_or(roughing.stepdown_mm);
    roughing.allowance_mm = options.allowance_mm.value_or(roughing.allowance_mm);
    roughing.stepover_mm = options.stepover_mm.value_or(roughing.stepover_mm);
    auto wanted = rough::wanted_roughing(profile);
    if (!wanted && has_details) {
        return Error{ErrorCode::bad_usage,
                     "--allowance and --stepover are of roughing, which needs --stepdown MM or the profile's "
                     "roughing.stepdown_mm"};
    }
    if (!wanted) return {};
    if (options.stepover_mm) wanted->stepover_mm = options.stepover_mm;
    return rough::check_options(*wanted, profile);
}

/// The machine's profile, with the tool, the blank and the roughing that the options name.
Result<Profile> profile_for(const ModelOptions& options, const CommonOptions& common) {
    auto profile = chosen_profile(common);
    if (!profile) return profile;
    if (const auto read = read_tool(options.tool, profile->tool); !read) return read.error();
    if (const auto read = read_flute(options.flute_mm, profile->tool); !read) return read.error();
    if (const auto read = read_blank(options.blank, profile->blank); !read) return read.error();
    if (const auto read = read_blank_at(options.blank_at, profile->blank); !read) return read.error();
    if (const auto read = read_depth_limit(options.depth_limit_mm, profile->blank); !read)
        return read.error();
    if (const auto read = read_roughing(options, *profile); !read) return read.error();
    return profile;
}

Result<PreparedJob> prepared(cam::BuiltJob built, const Profile& profile, const std::string& path) {
    auto job = cam::prepare_blob(job_blob_from_table(built.table), profile, path);
    if (job) job->warnings = std::move(built.report.warnings);
    if (job) job->notes = std::move(built.report.notes);
    return job;
}

/// A table of radii is a job except for the machine.
Result<PreparedJob> job_of_table(const std::string& path, ModelOptions options, const Profile& profile) {
    const auto joining = joining_from_name(std::exchange(options.joining, {}));
    options.thread_count = 0;
    options.tool.clear();
    options.flute_mm.reset();
    options.blank.clear();
    options.blank_at.clear();
    options.depth_limit_mm.reset();
    options.stepdown_mm = options.allowance_mm = options.stepover_mm = std::nullopt;
    const bool is_finish_only = std::exchange(options.finish_only, false);
    if (has_any(options)) {
        return Error{ErrorCode::bad_usage,
                     path +
                         " is a table, whose layers and radii are taken as they stand: of the options for "
                         "models only --joining, --tool, --flute, those of the blank and of roughing apply"};
    }
    auto built = cam::job_from_table(path, profile, joining);
    if (!built) return built.error();
    if (is_finish_only && built->table.passes.size() > 1) {
        return Error{ErrorCode::bad_usage,
                     path +
                         ": a table with roughing passes is carved as it stands: slice the model with "
                         "--finish-only"};
    }
    return prepared(std::move(*built), profile, path);
}

/// The body, turned; leaves in `how` the rest about its size.
Result<std::shared_ptr<const model::Mesh>> body_of(const std::string& path, const ModelOptions& options,
                                                   const Profile& profile, cam::JobOptions& how) {
    // A drawing gets its size when it becomes a body, and keeps it.
    const flat::ModelKind kind = flat::kind_of_model(path);
    if (kind == flat::ModelKind::mesh && options.height_mm && options.scale) {
        return Error{ErrorCode::bad_usage, "--height excludes --scale: both set the size of a mesh"};
    }
    if (kind == flat::ModelKind::drawing && options.scale && options.flat.is_full_turn) {
        return Error{ErrorCode::bad_usage, "--full-turn excludes --scale: both set the drawing's size"};
    }
    if (kind == flat::ModelKind::picture && (options.fits || options.scale)) {
        return Error{ErrorCode::bad_usage,
                     "--fit and --scale are not for pictures: --diameter says how large a cylinder is"};
    }
    FlatChoice choice = options.flat;
    // For a model carved from its outside in, the size; for a picture or lines, that of the cylinder that
    // they are on.
    const bool is_body =
        kind == flat::ModelKind::mesh || (kind == flat::ModelKind::drawing && !choice.engrave_mm);
    if (is_body) how.diameter_mm = std::exchange(choice.diameter_mm, std::nullopt);
    if (how.diameter_mm &&
        (options.scale || options.fits || (options.height_mm && kind == flat::ModelKind::mesh)))
        return Error{ErrorCode::bad_usage,
                     "--diameter excludes --height, --scale and --fit: all set the size"};
    auto flat = flat_options(choice, kind, profile, path);
    if (!flat) return flat.error();
    if (kind != flat::ModelKind::mesh) flat->height_mm = std::exchange(how.height_mm, std::nullopt);
    if (kind == flat::ModelKind::drawing) flat->scale = std::exchange(how.scale, std::nullopt).value_or(1.0);
    auto loaded = flat::load_model(path, *flat);
    if (!loaded) return loaded.error();
    const auto turn = mesh_turn(options.rotate, options.mirror, how.up);
    if (!turn) return turn.error();
    return std::make_shared<const model::Mesh>(model::turned(std::move(loaded).value(), *turn));
}

Result<PreparedJob> slice_model(const std::string& path, const ModelOptions& options,
                                const CommonOptions& common) {
    auto how = job_options(options);
    if (!how) return how.error();
    const auto profile = profile_for(options, common);
    if (!profile) return profile.error();
    if (cam::is_table_file(path)) return job_of_table(path, options, *profile);
    const auto body = body_of(path, options, *profile, *how);
    if (!body) return body.error();
    const std::shared_ptr<const model::Mesh>& mesh = *body;
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
    auto job = prepared(std::move(*built), *profile, path);
    if (job && options.keeps_mesh) job->mesh = mesh;
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
        .option("--layer-height", options.layer_height_mm, "MM",
                "As many layers as it takes for none to be higher than this, instead of --layers")
        .excludes("--layer-height", "--layers")
        .option("--points", options.point_count, kLeastPoints, kMostPoints,
                "Points per head and layer, half a turn (default 500)")
        .choice("--up", options.up, {"x", "y", "z"}, "The model's axis that stands upright (default z)")
        .option("--axis-at", options.axis_at, "X,Y|origin|best",
                "Where the rotation axis passes through the model (default: the middle of a mesh's bounding "
                "box, the "
                "centroid of a drawing's area)")
        .option("--height", options.height_mm, "MM",
                "Scale a mesh, uniformly, to this height; make a drawing's or picture's body so high")
        .option("--scale", options.scale, "F", "Scale a mesh or a drawing, uniformly, by this factor")
        .flag("--fit", options.fits,
              "Scale a mesh or a drawing's body, uniformly, as large as travel and blank let it be")
        .option("--rotate", options.rotate, "DEG|X,Y,Z",
                "Turn the model by degrees about its upright axis, or about the file's x, y and z axis one "
                "after another")
        .choice("--mirror", options.mirror, {"x", "y", "z"},
                "Mirror the model along this axis of the file, before it is turned")
        .choice("--joining", options.joining, {"continuous", "zigzag", "spiral"},
                "How one layer follows another (default: the profile's); a spiral rises as it turns")
        .option("--tool", options.tool, "SHAPE:MM",
                "What both heads carve with (default: the profile's): point, ball:3, flat:2, vee:6:60; "
                "diameter in "
                "mm, angle between a vee's flanks in degrees")
        .option_from_zero("--flute", options.flute_mm, "MM",
                          "How deep that tool cuts: a job that goes deeper into the blank is warned of "
                          "(default: the profile's; 0: deeper than any cut)")
        .option("--blank", options.blank, "RADIUSxHEIGHT",
                "The cylinder that is carved, in mm (default: the profile's)")
        .option("--blank-at", options.blank_at, "X,Z",
                "Where its axis stands off the table's, in mm towards direction 0 and 90 degrees")
        .option("--depth-limit", options.depth_limit_mm, "MM",
                "No tip goes deeper than this below the blank's surface")
        .option("--stepdown", options.stepdown_mm, "MM",
                "Rough the blank down first, by passes that go so much further in each; needs a blank "
                "(default: the profile's, which may be none)")
        .option_from_zero("--allowance", options.allowance_mm, "MM",
                          "What roughing leaves for the finishing pass (default: the profile's)")
        .option("--stepover", options.stepover_mm, "MM",
                "Between roughing's layers (default: the profile's; where that says none, 3/4 of a flat "
                "tool's diameter, 1/2 of a ball's, 1/4 of a "
                "vee's; a point carves every layer)")
        .flag("--finish-only", options.finish_only, "No roughing: the finishing pass alone")
        .option("--threads", options.thread_count, 1, kMostThreads,
                "Threads that slice (default: one a processor); the job is the same for any number");
    add_flat_options(syntax, options.flat);
}

std::string chosen_profile_path(const CommonOptions& common) {
    return common.profile.empty() ? default_profile_path() : common.profile;
}

Result<Profile> chosen_profile(const CommonOptions& common) {
    const std::string path = chosen_profile_path(common);
    if (path.empty()) return Profile{};
    return machine::profile_in(path);
}

Result<std::optional<Profile>> readable_profile(const CommonOptions& common) {
    auto profile = chosen_profile(common);
    if (profile) return std::optional<Profile>{std::move(profile).value()};
    if (!common.profile.empty()) return profile.error();
    print_warning(profile.error().message + "; going on without a profile");
    return std::optional<Profile>{};
}

Result<Snapshot> load_job_file(const std::string& path, const std::string& remedy) {
    if (!verify::is_binary_trace(path)) return load_snapshot(path);
    if (const auto only = verify::only_carried_job(path, remedy); !only) return only.error();
    return load_carried_job(path, remedy);
}

Result<Snapshot> load_carried_job(const std::string& path, const std::string& remedy) {
    auto blob = verify::require_carried_job(path, remedy);
    if (!blob) return blob.error();
    if (const auto job = JobView::check(*blob); !job)
        return bad_input(path + ": the job that it carries: " + job.error().message);
    Snapshot snapshot;
    snapshot.job_blob = std::move(blob).value();
    return snapshot;
}

Result<PreparedJob> job_of_snapshot(Snapshot snapshot, const std::string& path, const CommonOptions& common,
                                    ProfileUse use) {
    auto job = cam::prepare_snapshot(std::move(snapshot), path);
    if (!job || common.profile.empty()) return job;
    auto other = chosen_profile(common);
    if (!other) return other.error();
    const auto differing = use == ProfileUse::judge ? place_differences(job->profile, *other)
                                                    : job_differences(job->profile, *other);
    if (!differing.empty()) {
        return bad_input(path + ": made for another machine than " + common.profile + ": " +
                         joined(differing) + " differ; slice the model again with that profile");
    }
    return cam::prepare_for(std::move(job).value(), std::move(other).value(), path);
}

Result<PlacedBody> place_body(const std::string& path, const ModelOptions& options,
                              const CommonOptions& common) {
    auto how = job_options(options);
    if (!how) return how.error();
    const auto profile = profile_for(options, common);
    if (!profile) return profile.error();
    if (cam::is_table_file(path)) return bad_input(path + ": is a table, which has no body");
    auto body = body_of(path, options, *profile, *how);
    if (!body) return body.error();
    cam::SliceReport report;
    const auto plan = cam::plan_job(**body, *profile, *how, report);
    if (!plan) return plan.error();
    return PlacedBody{*profile,
                      {std::move(body).value(), plan->placement, plan->scale, profile->job.base_height_mm,
                       profile->core_radius_mm}};
}

Result<PreparedJob> prepare_unsaid(const std::string& path, const ModelOptions& options,
                                   const CommonOptions& common) {
    if (!is_snapshot_file(path)) return slice_model(path, options, common);
    if (has_any(options)) {
        return Error{ErrorCode::bad_usage,
                     path + " is a job and already sliced: options for models do not apply"};
    }
    auto snapshot = load_snapshot(path);
    if (!snapshot) return snapshot.error();
    return job_of_snapshot(std::move(snapshot).value(), path, common);
}

Result<PreparedJob> prepare_job(const std::string& path, const ModelOptions& options,
                                const CommonOptions& common) {
    if (!is_snapshot_file(path) && common.profile.empty()) {
        if (const std::string found = chosen_profile_path(common); !found.empty())
            print_note("profile " + found);
    }
    auto job = prepare_unsaid(path, options, common);
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
    if (!fs::exists(path, error) || fs::is_regular_file(path, error)) return check_writable(path);
    // A pipe or a device is written directly, whatever its folder is.
    if (access(path.c_str(), W_OK) == 0) return {};
    return bad_input(path + ": cannot be written: " + std::strerror(errno));
}

}  // namespace psicarve::cli
