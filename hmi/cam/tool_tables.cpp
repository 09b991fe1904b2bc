// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/tool_tables.hpp"

#include <cstddef>
#include <vector>

#include "hmi/slice/directions.hpp"
#include "hmi/tool/tool_offset.hpp"

namespace psicarve::cam {
std::vector<double> row_heights(const JobPlan& plan, double height_error) {
    std::vector<double> heights;
    if (plan.joining != Joining::spiral || plan.heights.size() == 1) {
        for (const double height : plan.heights) heights.push_back(height + height_error);
        return heights;
    }
    const std::size_t n = plan.point_count - 1;
    for (std::size_t column = 0; column < 2 * n; ++column) {
        const std::size_t point = column % n == 0 ? n : column % n;
        const double part = static_cast<double>(point) / static_cast<double>(n);
        heights.push_back(plan.heights.front() + height_error);
        for (std::size_t row = 1; row < plan.heights.size(); ++row) {
            const double bottom = plan.heights[row - 1];
            heights.push_back(bottom + part * (plan.heights[row] - bottom) + height_error);
        }
        heights.push_back(plan.heights.back() + height_error);
    }
    return heights;
}

namespace {

class ToolRound {
public:
    ToolRound(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan)
        : mesh_(mesh), profile_(profile), plan_(plan), tool_(tool::tool_of(profile.tool, 1.0 / plan.scale)) {}

    /// `fill` gets a layer and its radii once round.
    template <typename Fill>
    Result<void> go(double angle_error_deg, double height_error, const slice::SliceOptions& options,
                    const Fill& fill) const {
        const std::vector<double> directions =
            slice::full_circle_rad(plan_.point_count, profile_.psi.pulses_per_rev, angle_error_deg);
        const std::vector<double> heights = row_heights(plan_, height_error);
        const std::size_t rows = plan_.height_pulses.size();
        const auto tips =
            tool::tip_radii(mesh_, plan_.placement, tool_, {directions, rows, heights}, options);
        if (!tips) return tips.error();
        std::vector<double> once_round(directions.size());
        for (std::size_t row = 0; row < rows; ++row) {
            for (std::size_t column = 0; column < once_round.size(); ++column) {
                once_round[column] = (*tips)[column * rows + row];
            }
            fill(row, once_round);
        }
        return {};
    }

private:
    const model::Mesh& mesh_;
    const Profile& profile_;
    const JobPlan& plan_;
    tool::Tool tool_;
};

}  // namespace

Result<void> fill_with_tool(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                            const slice::SliceOptions& options, RadiusTables& tables) {
    const double angle_error_deg = profile.head_r2_angle_error_deg;
    const double height_error = profile.head_r2_height_error_mm / plan.scale;
    const bool is_opposite = angle_error_deg == 0.0 && height_error == 0.0;
    const ToolRound round(mesh, profile, plan);
    const auto both = [&](std::size_t row, const std::vector<double>& radii) {
        tables.fill_left(row, radii);
        if (is_opposite) tables.fill_right(row, radii);
    };
    if (is_opposite) return round.go(0.0, 0.0, options, both);
    const auto half = [&options](double before) {
        slice::SliceOptions part = options;
        if (!options.progress) return part;
        part.progress = [&options, before](double done) { return options.progress(before + 0.5 * done); };
        return part;
    };
    if (auto done = round.go(0.0, 0.0, half(0.0), both); !done) return done;
    return round.go(
        angle_error_deg, height_error, half(0.5),
        [&](std::size_t row, const std::vector<double>& radii) { tables.fill_right(row, radii); });
}

}  // namespace psicarve::cam
