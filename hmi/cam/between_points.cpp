// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/between_points.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include "hmi/cam/gap_search.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/tool/tool.hpp"
#include "hmi/tool/tool_offset.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cam {
namespace {

constexpr std::size_t kMostPlaces = 36;  // a tenth of what the tables took, or less

/// The part of a gap to be tested: from a point to the next, and between them.
struct Stretch {
    double from_rad;
    double to_rad;
    std::array<double, 2> between_rad;
};

/// The gaps to be tested with the tool: in their middle, and where edges go deepest; all, if they are few.
std::vector<Stretch> worst_stretches(const std::vector<Gap>& gaps, const std::vector<double>& round_rad) {
    std::vector<std::size_t> order(gaps.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Where nothing is known, evenly round.
    std::vector<char> is_even(gaps.size(), 0);
    for (std::size_t i = 0; i < kMostPlaces; ++i) is_even[i * gaps.size() / kMostPlaces] = 1;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return gaps[a].sunk_mm != gaps[b].sunk_mm ? gaps[a].sunk_mm > gaps[b].sunk_mm
                                                  : is_even[a] > is_even[b];
    });
    order.resize(std::min(kMostPlaces, order.size()));
    std::sort(order.begin(), order.end());
    std::vector<Stretch> stretches;
    for (const std::size_t k : order) {
        const double to_rad = k + 1 < round_rad.size() ? round_rad[k + 1] : round_rad[0] + 2.0 * kPi;
        const double middle_rad = 0.5 * (round_rad[k] + to_rad);
        const bool is_known = gaps[k].sunk_mm > 0.0;
        stretches.push_back(
            {round_rad[k], to_rad, {middle_rad, is_known ? gaps[k].direction_rad : middle_rad}});
    }
    return stretches;
}

Result<double> sunk_in_stretches_mm(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                                    const std::vector<Stretch>& stretches,
                                    const slice::SliceOptions& options) {
    std::vector<double> columns_rad;
    for (const Stretch& stretch : stretches) {
        columns_rad.insert(columns_rad.end(), {stretch.from_rad, stretch.to_rad});
        columns_rad.insert(columns_rad.end(), stretch.between_rad.begin(), stretch.between_rad.end());
    }
    std::sort(columns_rad.begin(), columns_rad.end());
    columns_rad.erase(std::unique(columns_rad.begin(), columns_rad.end()), columns_rad.end());
    const std::size_t rows = plan.heights.size();
    const auto tips = tool::tip_radii(mesh, plan.placement, tool::tool_of(profile.tool, 1.0 / plan.scale),
                                      {columns_rad, rows, plan.heights}, options);
    if (!tips) return tips.error();
    const double core = profile.core_radius_mm / plan.scale;
    const auto tip = [&](double direction_rad, std::size_t row) {
        const auto column = std::lower_bound(columns_rad.begin(), columns_rad.end(), direction_rad);
        return std::max(core, (*tips)[static_cast<std::size_t>(column - columns_rad.begin()) * rows + row]);
    };
    double most = 0.0;
    for (const Stretch& stretch : stretches) {
        for (std::size_t row = 0; row < rows; ++row) {
            const double from = tip(stretch.from_rad, row);
            const double to = tip(stretch.to_rad, row);
            for (const double direction_rad : stretch.between_rad) {
                const double part = (direction_rad - stretch.from_rad) / (stretch.to_rad - stretch.from_rad);
                most = std::max(most, tip(direction_rad, row) - (from + part * (to - from)));
            }
        }
    }
    return most * plan.scale;
}

}  // namespace

Result<double> sunk_between_points_mm(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                                      const JobTable& table, const slice::SliceOptions& options) {
    if (profile.tool.shape == ToolShape::point) return most_sunk_at_edges_mm(mesh, profile, plan, table);
    const std::vector<Gap> gaps = sunk_at_edges(mesh, profile, plan, table);
    double most_mm = 0.0;
    for (const Gap& gap : gaps) most_mm = std::max(most_mm, gap.sunk_mm);
    const auto round_rad = slice::full_circle_rad(plan.point_count, profile.psi.pulses_per_rev, 0.0);
    const auto sunk_mm = sunk_in_stretches_mm(mesh, profile, plan, worst_stretches(gaps, round_rad), options);
    if (!sunk_mm) return sunk_mm.error();
    return std::max(most_mm, *sunk_mm);
}

}  // namespace psicarve::cam
