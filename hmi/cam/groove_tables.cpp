// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/groove_tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "hmi/cam/tool_tables.hpp"
#include "hmi/slice/directions.hpp"
#include "shared/base/decimals.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cam {
namespace {

class GrooveRound {
public:
    GrooveRound(const flat::Grooves& grooves, const Profile& profile, const JobPlan& plan)
        : grooves_(grooves),
          profile_(profile),
          plan_(plan),
          cell_(groove_cell(grooves, profile, plan)),
          index_(grooves, grooves.wall_mm() + std::hypot(cell_.along_mm, cell_.height_mm)) {}

    /// `fill` gets a row and its radii once round; `go_on` the part of the rows that is done.
    template <typename Fill, typename GoOn>
    Result<void> go(double angle_error_deg, double height_error_mm, const Fill& fill,
                    const GoOn& go_on) const {
        const std::vector<double> directions =
            slice::full_circle_rad(plan_.point_count, profile_.psi.pulses_per_rev, angle_error_deg);
        const std::vector<double> heights = row_heights(plan_, height_error_mm);
        const std::size_t rows = plan_.height_pulses.size();
        const bool is_spiral = heights.size() != rows;
        std::vector<double> once_round(directions.size());
        for (std::size_t row = 0; row < rows; ++row) {
            for (std::size_t column = 0; column < directions.size(); ++column) {
                const double height_mm = heights[is_spiral ? column * rows + row : row];
                const double beside_mm =
                    index_.beside_floor_mm(directions[column] * grooves_.radius_mm, height_mm, cell_);
                once_round[column] = grooves_.radius_mm - grooves_.tip_depth_mm(beside_mm);
            }
            fill(row, once_round);
            if (!go_on(static_cast<double>(row + 1) / static_cast<double>(rows)))
                return Error{ErrorCode::cancelled, "slicing was cancelled"};
        }
        return {};
    }

private:
    const flat::Grooves& grooves_;
    const Profile& profile_;
    const JobPlan& plan_;
    flat::HalfCell cell_;
    flat::StrokeIndex index_;
};

}  // namespace

Result<void> check_groove_options(const model::Mesh& mesh, const Profile& profile,
                                  const JobOptions& options) {
    if (mesh.grooves->tool != tool::tool_of(profile.tool, 1.0))
        return Error{ErrorCode::bad_usage, mesh.source_name + ": its grooves are of another tool"};
    const bool is_as_drawn = options.up == slice::Up::z && options.axis_at == AxisAt::centre &&
                             !options.height_mm && !options.scale && !options.fits && !mesh.turn.any();
    if (is_as_drawn) return {};
    return Error{ErrorCode::bad_usage,
                 mesh.source_name +
                     ": --up, --axis-at, --fit, --rotate and --mirror are not for lines that are engraved"};
}

flat::HalfCell groove_cell(const flat::Grooves& grooves, const Profile& profile, const JobPlan& plan) {
    // Points stand on whole pulses, so a step may be half a pulse longer at both its ends.
    const double step_pulses =
        0.5 * static_cast<double>(profile.psi.pulses_per_rev) / static_cast<double>(plan.point_count - 1) +
        1.0;
    const double step_mm = grooves.round_mm() * step_pulses / static_cast<double>(profile.psi.pulses_per_rev);
    const double layer_mm = grooves.height_mm / static_cast<double>(plan.layer_count);
    constexpr double kRounded_mm = 1e-6;  // a line between two layers is met by both
    return {0.5 * step_mm, 0.5 * layer_mm + kRounded_mm};
}

Result<void> fill_with_grooves(const flat::Grooves& grooves, const Profile& profile, const JobPlan& plan,
                               const slice::SliceOptions& options, RadiusTables& tables) {
    const double angle_error_deg = profile.head_r2_angle_error_deg;
    const double height_error_mm = profile.head_r2_height_error_mm;
    const bool is_opposite = angle_error_deg == 0.0 && height_error_mm == 0.0;
    const GrooveRound round(grooves, profile, plan);
    const auto progress = [&options](double before, double share) {
        return [&options, before, share](double done) {
            return !options.progress || options.progress(before + share * done);
        };
    };
    const auto both = [&](std::size_t row, const std::vector<double>& radii) {
        tables.fill_left(row, radii);
        if (is_opposite) tables.fill_right(row, radii);
    };
    if (auto done = round.go(0.0, 0.0, both, progress(0.0, is_opposite ? 1.0 : 0.5)); !done || is_opposite)
        return done;
    const auto right = [&](std::size_t row, const std::vector<double>& radii) {
        tables.fill_right(row, radii);
    };
    return round.go(angle_error_deg, height_error_mm, right, progress(0.5, 0.5));
}

void report_grooves(const flat::Grooves& grooves, const Profile& profile, const JobPlan& plan,
                    SliceReport& report) {
    const flat::HalfCell cell = groove_cell(grooves, profile, plan);
    const double tool_mm = 2.0 * grooves.wall_mm();
    report.notes.push_back("grooves " + mm_text(grooves.depth_mm) + " deep and " +
                           mm_text(2.0 * (grooves.wall_mm() + grooves.widest_floor_mm())) +
                           " wide; where no point meets the line, up to " + mm_text(2.0 * cell.along_mm) +
                           " wider along the layers and " + mm_text(2.0 * cell.height_mm) + " across them");
    if (profile.tool.shape == ToolShape::point) {
        report.warnings.emplace_back(
            "the tool is a point, which leaves no width: grooves are as wide as the real tool cuts them");
    } else if (2.0 * std::hypot(cell.along_mm, cell.height_mm) > tool_mm) {
        report.warnings.push_back("layers and points lie farther from each other than the tool cuts, " +
                                  mm_text(tool_mm) + ": more --layers or --points");
    }
    if (grooves.radius_mm - grooves.depth_mm < profile.core_radius_mm) {
        report.warnings.push_back("grooves end at the core radius of " + mm_text(profile.core_radius_mm) +
                                  ", less deep than asked");
    }
}

}  // namespace psicarve::cam
