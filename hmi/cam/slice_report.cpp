// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/slice_report.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <string>

namespace psicarve::cam {
namespace {

nlohmann::json loss_json(const slice::AxisLoss& loss) {
    return {{"undercut_share", loss.undercut_share}, {"layers_without_axis_share", loss.outside_share}};
}

}  // namespace

std::string to_json(const SliceReport& report) {
    nlohmann::json out{{"format", report.format},
                       {"layers", report.layers},
                       {"points", report.points},
                       {"core_points", report.core_points},
                       {"clearance_points", report.clearance_points},
                       {"tool", report.tool},
                       {"r_min_mm", report.r_min_mm},
                       {"r_max_mm", report.r_max_mm},
                       {"warnings", report.warnings},
                       {"notes", report.notes}};
    if (report.format != kTableFormat) {
        out["triangles"] = report.triangles;
        out["bounding_box_mm"] = report.box_mm;
        out["scale"] = report.scale;
        out["up"] = report.up;
        out["axis_at"] = report.axis_choice;
        out["axis"] = report.axis;
        out["undercut_share"] = report.undercut_share;
        out["open_points"] = report.open_points;
        out["layers_without_axis"] = report.layers_without_axis;
    }
    if (report.depth_limit) {
        out["depth_limit"] = {{"points", report.depth_limit->points},
                              {"share", report.depth_limit->share},
                              {"most_mm", report.depth_limit->most_mm}};
    }
    if (report.layers_above_blank > 0) out["layers_above_blank"] = report.layers_above_blank;
    if (report.between_points_mm) out["between_points_mm"] = *report.between_points_mm;
    if (report.undercut_mm) out["undercut_heights_mm"] = *report.undercut_mm;
    if (report.open_mm) out["open_heights_mm"] = *report.open_mm;
    if (report.turn.any()) {
        constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
        const auto mirror = report.turn.mirror ? nlohmann::json(kNames[*report.turn.mirror]) : nullptr;
        out["turn"] = {{"rotate_deg", report.turn.rotate_deg}, {"mirror", mirror}};
    }
    if (!report.body_json.empty()) {
        out["body"] = nlohmann::json::parse(report.body_json, nullptr, false);
    }
    if (!report.roughing_json.empty()) {
        out["roughing"] = nlohmann::json::parse(report.roughing_json, nullptr, false);
    }
    if (report.axis_search) {
        out["best_axis"] = {{"axis", report.axis_search->best},
                            {"loss", loss_json(report.axis_search->best_loss)},
                            {"loss_at_centre", loss_json(report.axis_search->centre_loss)},
                            {"loss_at_used", loss_json(report.axis_search->used_loss)}};
    }
    // A file name may hold bytes that are not UTF-8; the report is valid JSON all the same.
    return out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace psicarve::cam
