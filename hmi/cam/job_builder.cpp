// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/job_builder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hmi/cam/between_points.hpp"
#include "hmi/cam/blank_check.hpp"
#include "hmi/cam/core_share.hpp"
#include "hmi/cam/groove_tables.hpp"
#include "hmi/cam/job_plan.hpp"
#include "hmi/cam/radius_tables.hpp"
#include "hmi/cam/rough_job.hpp"
#include "hmi/cam/slice_report.hpp"
#include "hmi/cam/tool_tables.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/rough/roughing.hpp"
#include "hmi/slice/best_axis.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/slicer.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/base/decimals.hpp"
#include "shared/base/result.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {
namespace {

using Totals = std::vector<slice::LayerTotals>;

/// Progress of one part of the work: `share` of the whole, from `begin` on.
slice::SliceOptions part_of(const JobOptions& options, double begin, double share) {
    slice::SliceOptions part{options.thread_count, {}};
    if (!options.progress) return part;
    part.progress = [&options, begin, share](double done) { return options.progress(begin + share * done); };
    return part;
}

/// Slices the model into radii in R1's or R2's directions. R1's pass sees every direction of every layer, so
/// its totals describe the model.
Result<Totals> slice_once(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                          double angle_error_deg, double height_error, const slice::LayerSink& sink,
                          const slice::SliceOptions& slicing) {
    std::vector<double> heights = plan.heights;
    for (double& height : heights) height += height_error;
    const slice::Directions directions(
        slice::full_circle_rad(plan.point_count, profile.psi.pulses_per_rev, angle_error_deg));
    const auto slice_rows = plan.joining == Joining::spiral ? slice::slice_spiral : slice::slice_layers;
    return slice_rows(mesh, plan.placement, heights, directions, sink, slicing);
}

/// Tables for a tip without size: the radii themselves. Where R2 stands exactly opposite, one pass serves
/// both.
Result<Totals> sample(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                      const JobOptions& options, RadiusTables& tables, OutermostRadii& outermost) {
    const double angle_error_deg = profile.head_r2_angle_error_deg;
    const double height_error = profile.head_r2_height_error_mm / plan.scale;
    const bool one_pass = angle_error_deg == 0.0 && height_error == 0.0;
    const auto both = [&tables, &outermost, one_pass](const slice::LayerSection& section) {
        outermost.note(section.radius);
        tables.fill_left(section.layer, section.radius);
        if (one_pass) tables.fill_right(section.layer, section.radius);
    };
    auto totals =
        slice_once(mesh, profile, plan, 0.0, 0.0, both, part_of(options, 0.0, one_pass ? 1.0 : 0.5));
    if (!totals || one_pass) return totals;
    const auto right = [&tables](const slice::LayerSection& section) {
        tables.fill_right(section.layer, section.radius);
    };
    auto done =
        slice_once(mesh, profile, plan, angle_error_deg, height_error, right, part_of(options, 0.5, 0.5));
    if (!done) return done.error();
    return totals;
}

constexpr double kBetweenPointsShare = 0.1;  // of a tool's job

/// Tables for a tool: how far in it can go. Line art has this in itself, for a point as well.
Result<Totals> sample_with_tool(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                                const JobOptions& options, RadiusTables& tables, OutermostRadii& outermost) {
    constexpr double kSlicingShare = 0.2;
    auto totals = slice_once(
        mesh, profile, plan, 0.0, 0.0,
        [&outermost](const slice::LayerSection& section) { outermost.note(section.radius); },
        part_of(options, 0.0, kSlicingShare));
    if (!totals) return totals;
    const slice::SliceOptions rest =
        part_of(options, kSlicingShare, 1.0 - kSlicingShare - kBetweenPointsShare);
    auto done = mesh.grooves ? fill_with_grooves(*mesh.grooves, profile, plan, rest, tables)
                             : fill_with_tool(mesh, profile, plan, rest, tables);
    if (!done) return done.error();
    return totals;
}

double ratio(double part, double whole) {
    return whole > 0.0 ? part / whole : 0.0;
}

void widen(std::optional<std::array<double, 2>>& range, double at_mm) {
    if (!range) range = {at_mm, at_mm};
    (*range)[0] = std::min((*range)[0], at_mm);
    (*range)[1] = std::max((*range)[1], at_mm);
}

// A layer with less behind its outer walls is not worth naming.
constexpr double kHiddenWorthNaming = 0.01;

void report_totals(const std::vector<slice::LayerTotals>& totals, const std::vector<double>& heights_mm,
                   SliceReport& report) {
    for (std::size_t i = 0; i < totals.size(); ++i) {
        const slice::LayerTotals& layer = totals[i];
        if (layer.open_cells > 0) widen(report.open_mm, heights_mm[i]);
        if (layer.radius_sum - layer.outer_sum > kHiddenWorthNaming * layer.radius_sum)
            widen(report.undercut_mm, heights_mm[i]);
        report.open_points += layer.open_cells;
        report.layers_without_axis += layer.contains_axis ? 0 : 1;
    }
    report.undercut_share = slice::undercut_share(totals);
}

std::string percent(double share) {
    const auto tenths = static_cast<int>(std::lround(share * 1000.0));
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %";
}

// Where the chosen axis loses more than this, a better one is worth a look.
constexpr double kLossWorthASearch = 0.01;

bool is_axis_worth_a_search(const SliceReport& report) {
    return report.undercut_share + ratio(report.layers_without_axis, report.layers) >= kLossWorthASearch;
}

Result<void> compare_axes(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                          const JobOptions& options, SliceReport& report) {
    if (!options.compares_axes || report.axis_search || !is_axis_worth_a_search(report)) return {};
    const auto found =
        slice::search_axis(mesh, plan.placement.up, {plan.placement.axis_x, plan.placement.axis_y},
                           reachable_radius(profile, plan.scale), options.search_progress);
    if (!found) return found.error();
    report.axis_search = *found;
    return {};
}

std::string better_axis(const SliceReport& report) {
    if (report.axis_choice == "best") return "";
    if (!report.axis_search)
        return is_axis_worth_a_search(report) ? "; --axis-at best looks for an axis that loses less" : "";
    const slice::AxisSearch& found = *report.axis_search;
    if (found.best_loss.total() >= found.used_loss.total() - kLossWorthASearch) return "";
    // Both by the search's own estimate: on fewer sections than the job, so not the figure above.
    return "; --axis-at best would lose " + percent(found.best_loss.undercut_share) + " of the surface and " +
           percent(found.best_loss.outside_share) + " of the layers, by the same look this axis " +
           percent(found.used_loss.undercut_share) + " and " + percent(found.used_loss.outside_share);
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

/// A spiral's points lie as close as a layer's.
Result<void> look_between_points(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                                 const JobTable& table, const JobOptions& options, SliceReport& report) {
    constexpr double kWorthNaming_mm = 0.05;
    const auto sunk_mm = sunk_between_points_mm(
        mesh, profile, plan, table, part_of(options, 1.0 - kBetweenPointsShare, kBetweenPointsShare));
    if (!sunk_mm) return sunk_mm.error();
    report.between_points_mm = *sunk_mm;
    if (*sunk_mm < kWorthNaming_mm) return {};
    report.warnings.push_back(
        "between two points of a layer the tool goes up to " + mm_text(*sunk_mm) +
        " too deep along its radius, into the model mostly less; more points make that less");
    return {};
}

/// Before anything keeps the heads out: checks that the tables hold more than the core.
Result<void> check_meets_model(const std::string& source_name, const Profile& profile,
                               const JobOptions& options, const OutermostRadii& outermost,
                               const BuiltJob& built) {
    if (!core_share(profile, built.table).is_all()) return {};
    const auto radii = outermost.radii();
    const double most = radii.empty() ? 0.0 : *std::max_element(radii.begin(), radii.end());
    // Far away from the axis, or too small to be met: a ring around the axis would be seen.
    if (most <= 0.0) {
        return bad_input(source_name +
                         ": the axis passes beside the model and no sample meets it: nothing but the core "
                         "would be carved; --axis-at moves the axis");
    }
    return core_alone(source_name, profile, options, most * built.report.scale, built.report);
}

/// Warnings about the blank; directions are those of R1's pass.
void check_blank(const Profile& profile, const JobPlan& plan, const OutermostRadii& outermost,
                 SliceReport& report) {
    std::vector<double> model_mm(outermost.radii().begin(), outermost.radii().end());
    for (double& radius : model_mm) radius *= plan.scale;
    const auto directions_rad = slice::full_circle_rad(plan.point_count, profile.psi.pulses_per_rev, 0.0);
    warn_about_blank(profile, directions_rad, model_mm, profile.job.base_height_mm + report.box_mm[2],
                     report);
}

Result<BuiltJob> build(const model::Mesh& mesh, const Profile& profile, const JobOptions& options) {
    BuiltJob built;
    SliceReport& report = built.report;
    if (mesh.grooves) {
        if (auto good = check_groove_options(mesh, profile, options); !good) return good.error();
    }
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

    report.tool = tool::name_of(profile.tool);
    RadiusTables tables(profile, table, plan.scale);
    const bool is_by_surface = profile.tool.shape == ToolShape::point && !mesh.grooves;
    const auto sampled = is_by_surface ? sample : sample_with_tool;
    OutermostRadii outermost;
    const auto totals = sampled(mesh, profile, plan, options, tables, outermost);
    if (!totals) return totals.error();
    tables.join_rows();
    if (auto good = check_meets_model(mesh.source_name, profile, options, outermost, built); !good)
        return good.error();
    hold_depth_limit(profile, table, report);
    if (auto fits = tables.check_travel(mesh.source_name); !fits) return fits.error();
    std::vector<double> heights_mm;
    for (const std::int64_t pulses : plan.height_pulses)
        heights_mm.push_back(mm_from_pulses(pulses, profile.y.pulses_per_mm));
    report_totals(*totals, heights_mm, report);
    const CoreShare at_core = core_share(profile, table);
    tables.report(profile, report);
    if (auto done = compare_axes(mesh, profile, plan, options, report); !done) return done.error();
    warn_about_losses(report);
    // Grooves have their own report of it.
    if (!mesh.grooves) warn_about_core(profile, at_core, report);
    if (!mesh.grooves) {
        if (auto done = look_between_points(mesh, profile, plan, table, options, report); !done)
            return done.error();
    }
    check_blank(profile, plan, outermost, report);
    if (!mesh.grooves) {
        warn_about_layers(profile, table, report);
        warn_about_foot(profile, table, report);
    }
    note_what_meets_the_table(profile, table, report);
    if (mesh.grooves) report_grooves(*mesh.grooves, profile, plan, report);
    table.profile_toml = profile_to_toml(profile);
    table.report_json = to_json(report);
    return built;
}

Result<BuiltJob> build_with_roughing(const model::Mesh& mesh, const Profile& profile,
                                     const JobOptions& options) {
    if (auto clear = check_heads_clear(profile.blank, profile); !clear)
        return bad_input(mesh.source_name + ": " + clear.error().message);
    const auto wanted = rough::wanted_roughing(profile);
    if (!wanted) return build(mesh, profile, options);
    if (auto good = rough::check_options(*wanted, profile); !good) return good.error();
    auto built = build(mesh, profile, options);
    if (!built) return built;
    Result<BuiltJob> level = BuiltJob{};
    const bool is_spiral = built->table.joining == Joining::spiral;
    if (is_spiral) level = build(mesh, profile, level_options(*built, options));
    if (!level) return level;
    const JobTable own = is_spiral ? std::move(level->table) : built->table;
    if (auto done = rough(*built, own, profile); !done) return done.error();
    return built;
}

}  // namespace

Result<BuiltJob> build_job(const model::Mesh& mesh, const Profile& profile, const JobOptions& options) {
    try {
        return build_with_roughing(mesh, profile, options);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, "not enough memory for so many layers and points"};
    }
}

}  // namespace psicarve::cam
