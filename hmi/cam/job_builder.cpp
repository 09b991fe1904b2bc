// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/job_builder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hmi/cam/job_plan.hpp"
#include "hmi/cam/radius_tables.hpp"
#include "hmi/cam/slice_report.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/slice/best_axis.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/job.hpp"
#include "shared/profile.hpp"
#include "shared/result.hpp"
#include "shared/units.hpp"

namespace psicarve::cam {
namespace {

/// Samples the surface for both heads and fills the tables; R1's pass sees every direction of every layer, so
/// its totals describe the model. Where R2 stands exactly opposite, one pass serves both.
Result<std::vector<slice::LayerTotals>> sample(const model::Mesh& mesh, const Profile& profile,
                                               const JobPlan& plan, const JobOptions& options,
                                               RadiusTables& tables) {
    const double angle_error_deg = profile.head_r2_angle_error_deg;
    const double height_error = profile.head_r2_height_error_mm / plan.scale;
    const bool one_pass = angle_error_deg == 0.0 && height_error == 0.0;
    slice::SliceOptions slicing{options.thread_count, options.progress};
    if (!one_pass && options.progress) {
        slicing.progress = [&options](double done) { return options.progress(done / 2.0); };
    }
    const slice::Directions directions(
        slice::full_circle_rad(plan.point_count, profile.psi.pulses_per_rev, 0.0));
    const auto both = [&tables, one_pass](const slice::LayerSection& section) {
        tables.fill_left(section.layer, section.radius);
        if (one_pass) tables.fill_right(section.layer, section.radius);
    };
    const auto slice_rows = plan.joining == Joining::spiral ? slice::slice_spiral : slice::slice_layers;
    auto totals = slice_rows(mesh, plan.placement, plan.heights, directions, both, slicing);
    if (!totals || one_pass) return totals;

    std::vector<double> heights = plan.heights;
    for (double& height : heights) height += height_error;
    if (options.progress) {
        slicing.progress = [&options](double done) { return options.progress((1.0 + done) / 2.0); };
    }
    const slice::Directions turned(
        slice::full_circle_rad(plan.point_count, profile.psi.pulses_per_rev, angle_error_deg));
    const auto right = [&tables](const slice::LayerSection& section) {
        tables.fill_right(section.layer, section.radius);
    };
    auto done = slice_rows(mesh, plan.placement, heights, turned, right, slicing);
    if (!done) return done.error();
    return totals;
}

double ratio(double part, double whole) {
    return whole > 0.0 ? part / whole : 0.0;
}

void report_totals(const std::vector<slice::LayerTotals>& totals, SliceReport& report) {
    double all = 0.0;
    double outer = 0.0;
    bool hidden = false;
    for (const slice::LayerTotals& layer : totals) {
        report.open_points += layer.open_cells;
        report.layers_without_axis += layer.contains_axis ? 0 : 1;
        hidden = hidden || layer.hidden_walls > 0;
        all += layer.radius_sum;
        outer += layer.outer_sum;
    }
    report.undercut_share = hidden ? std::clamp(ratio(all - outer, all), 0.0, 1.0) : 0.0;
}

std::string percent(double share) {
    const auto tenths = static_cast<int>(std::lround(share * 1000.0));
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %";
}

// Where the chosen axis loses more than this, a better one is looked for and offered.
constexpr double kLossWorthASearch = 0.01;

Result<void> offer_axis(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                        const JobOptions& options, SliceReport& report) {
    const double outside = ratio(report.layers_without_axis, report.layers);
    if (report.axis_search || report.undercut_share + outside < kLossWorthASearch) return {};
    const auto found =
        slice::search_axis(mesh, plan.placement.up, {plan.placement.axis_x, plan.placement.axis_y},
                           reachable_radius(profile, plan.scale), options.search_progress);
    if (!found) return found.error();
    report.axis_search = *found;
    return {};
}

std::string better_axis(const SliceReport& report) {
    if (report.axis_choice == "best" || !report.axis_search) return "";
    const slice::AxisSearch& found = *report.axis_search;
    if (found.best_loss.total() >= found.used_loss.total() - kLossWorthASearch) return "";
    return "; --axis-at best would lose " + percent(found.best_loss.undercut_share) + " of the surface and " +
           percent(found.best_loss.outside_share) + " of the layers";
}

void warn_about_losses(SliceReport& report) {
    const std::string hint = better_axis(report);
    if (report.undercut_share >= 0.0005) {
        report.warnings.push_back(percent(report.undercut_share) +
                                  " of the surface lies behind another part and cannot be reached" + hint);
    }
    if (report.layers_without_axis > 0) {
        report.warnings.push_back(std::to_string(report.layers_without_axis) + " of " +
                                  std::to_string(report.layers) + " layers do not contain the axis" +
                                  (report.undercut_share >= 0.0005 ? "" : hint));
    }
    if (report.open_points > 0) {
        report.warnings.push_back(
            "the mesh is open at " + std::to_string(report.open_points) +
            " of the samples; what is missing there is carved down to what lies behind it, or to the core");
    }
}

Result<BuiltJob> build(const model::Mesh& mesh, const Profile& profile, const JobOptions& options) {
    BuiltJob built;
    SliceReport& report = built.report;
    const Result<JobPlan> planned = plan_job(mesh, profile, options, report);
    if (!planned) return planned.error();
    const JobPlan& plan = *planned;

    JobTable& table = built.table;
    table.layer_count = report.layers;
    table.point_count = plan.point_count;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.joining = plan.joining;
    table.feed_mm_s = profile.job.feed_mm_s;
    table.layer_height_pulses = plan.height_pulses;
    table.source_name = mesh.source_name;
    table.source_hash = mesh.source_hash;

    RadiusTables tables(profile, table, plan.scale);
    const auto totals = sample(mesh, profile, plan, options, tables);
    if (!totals) return totals.error();
    tables.join_rows();
    if (auto fits = tables.check_travel(mesh.source_name); !fits) return fits.error();
    report_totals(*totals, report);
    tables.report(report);
    if (auto done = offer_axis(mesh, profile, plan, options, report); !done) return done.error();
    warn_about_losses(report);
    table.profile_toml = profile_to_toml(profile);
    table.report_json = to_json(report);
    return built;
}

}  // namespace

Result<BuiltJob> build_job(const model::Mesh& mesh, const Profile& profile, const JobOptions& options) {
    try {
        return build(mesh, profile, options);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, "not enough memory for so many layers and points"};
    }
}

}  // namespace psicarve::cam
