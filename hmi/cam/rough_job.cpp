// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/rough_job.hpp"

#include <string>

#include "hmi/cam/blank_check.hpp"
#include "hmi/rough/roughing.hpp"
#include "shared/base/decimals.hpp"

namespace psicarve::cam {

Result<void> rough(BuiltJob& built, const JobTable& level, const Profile& profile) {
    const auto options = rough::wanted_roughing(profile);
    if (!options) return {};
    const double pitch_mm = layer_pitch_mm(profile, level);
    const auto summary = rough::add_roughing(built.table, level, profile, *options);
    if (!summary) return summary.error();
    if (summary->passes.empty()) {
        built.report.notes.emplace_back(
            "no roughing passes: nothing of the blank stands further out than the allowance");
    }
    if (!summary->passes.empty() && summary->stepover_mm > 0.0 &&
        pitch_mm > summary->stepover_mm + 1.0 / profile.y.pulses_per_mm) {
        built.report.warnings.push_back("roughing cannot keep its stepover of " +
                                        mm_text(summary->stepover_mm) + ": the job's layers lie " +
                                        mm_text(pitch_mm) + " apart");
    }
    built.report.roughing_json = rough::to_json(*summary, *options);
    built.table.report_json = to_json(built.report);
    return {};
}

JobOptions level_options(const BuiltJob& spiral, const JobOptions& options) {
    JobOptions level = options;
    level.joining = Joining::continuous;
    level.layer_count =
        (spiral.table.layer_count > 1 ? spiral.table.layer_count - 1 : 1) + spiral.report.layers_above_blank;
    level.point_count = spiral.table.point_count;
    // Size and axis may be the result of a search.
    level.height_mm.reset();
    level.fits = false;
    level.scale = spiral.report.scale;
    level.axis_at = AxisAt::point;
    level.axis_x = spiral.report.axis[0];
    level.axis_y = spiral.report.axis[1];
    return level;
}

}  // namespace psicarve::cam
