// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/slice_report.hpp"

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
                       {"triangles", report.triangles},
                       {"bounding_box_mm", report.box_mm},
                       {"scale", report.scale},
                       {"axis_at", report.axis_choice},
                       {"axis", report.axis},
                       {"layers", report.layers},
                       {"points", report.points},
                       {"undercut_share", report.undercut_share},
                       {"open_points", report.open_points},
                       {"core_points", report.core_points},
                       {"clearance_points", report.clearance_points},
                       {"layers_without_axis", report.layers_without_axis},
                       {"r_min_mm", report.r_min_mm},
                       {"r_max_mm", report.r_max_mm},
                       {"warnings", report.warnings},
                       {"notes", report.notes}};
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
