// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/scene/time_map.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "hmi/scene/colour_map.hpp"
#include "hmi/scene/radius_map.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

constexpr double kMsPerS = 1e3;
/// The window waits while a map is made: of more points some layers stand for those beside them.
constexpr std::size_t kMostPoints = 1'000'000;
constexpr double kRareRatio = 0.02;
constexpr double kLeastRange_ms = 1e-3;

/// What the ways in a cell add up to.
struct Cell {
    float seconds = 0.0F;
    std::uint32_t ways = 0;
    std::array<float, kWayBoundCount> bound_s{};
};

class Gatherer {
public:
    Gatherer(const cam::PreparedJob& job, const PointPlan& plan, TimeMap& map)
        : job_(job), plan_(plan), map_(map), cells_(map.columns * map.rows) {}

    void gather() {
        const std::size_t first = job_.view.finishing_layer();
        const std::size_t layers = job_.view.layer_count() - first;
        const std::size_t most_of_row =
            std::max<std::size_t>(1, kMostPoints / (map_.rows * job_.view.point_count()));
        for (std::size_t row = 0; row < map_.rows; ++row) {
            const std::size_t begin = row * layers / map_.rows;
            const std::size_t count = (row + 1) * layers / map_.rows - begin;
            const std::size_t taken = std::min(count, most_of_row);
            for (std::size_t i = 0; i < taken; ++i) {
                const std::size_t layer = first + begin + (2 * i + 1) * count / (2 * taken);
                gather_layer(static_cast<std::uint32_t>(layer), row);
            }
        }
    }
    /// A cell that no way came to, by rounding, has what the one beside it has.
    void fill() {
        for (std::size_t row = 0; row < map_.rows; ++row) {
            const std::span<Cell> cells = std::span{cells_}.subspan(row * map_.columns, map_.columns);
            const auto some = std::ranges::find_if(cells, [](const Cell& cell) { return cell.ways > 0; });
            if (some == cells.end()) continue;
            Cell beside = *some;
            for (std::size_t column = 0; column < map_.columns; ++column) {
                if (cells[column].ways > 0) beside = cells[column];
                const std::size_t place = row * map_.columns + column;
                map_.way_ms[place] = static_cast<float>(kMsPerS * beside.seconds / beside.ways);
                const auto most = std::ranges::max_element(beside.bound_s);
                map_.bounds[place] = static_cast<WayBound>(most - beside.bound_s.begin());
            }
        }
    }

private:
    void gather_layer(std::uint32_t layer, std::size_t row) {
        const std::uint32_t count = job_.view.point_count();
        const bool is_backwards = carved_point(job_.view.joining(), count, layer, 0) != 0;
        for (std::uint32_t point = 0; point < count; ++point) {
            // The way to a layer's first point is none around the workpiece.
            const bool is_first = point == (is_backwards ? count - 1 : 0);
            const std::uint32_t from = is_first ? point : (is_backwards ? point + 1 : point - 1);
            const double middle_deg =
                deg_from_pulses(job_.view.psi_pulses(layer, point) + job_.view.psi_pulses(layer, from),
                                2 * job_.profile.psi.pulses_per_rev);
            const std::size_t place = std::size_t{layer} * count + point;
            // Where rows of a spiral meet, and at the job's first point, there is none.
            if (plan_.seconds[place] <= 0.0F) continue;
            for (const double turned_deg : {0.0, kDegPerRev / 2.0 + job_.profile.head_r2_angle_error_deg})
                add(row, within_turn(middle_deg + turned_deg), place);
        }
    }
    void add(std::size_t row, double direction_deg, std::size_t place) {
        const auto columns = static_cast<double>(map_.columns);
        const auto column =
            std::min(static_cast<std::size_t>(direction_deg / kDegPerRev * columns), map_.columns - 1);
        Cell& cell = cells_[row * map_.columns + column];
        const float seconds = plan_.seconds[place];
        cell.seconds += seconds;
        ++cell.ways;
        cell.bound_s[static_cast<std::size_t>(plan_.bounds[place])] += seconds;
    }

    const cam::PreparedJob& job_;
    const PointPlan& plan_;
    TimeMap& map_;
    std::vector<Cell> cells_;
};

std::array<double, kWayBoundCount> bound_ratios(const PointPlan& plan) {
    std::array<double, kWayBoundCount> ratios{};
    double all_s = 0.0;
    for (std::size_t i = 0; i < plan.seconds.size(); ++i) {
        ratios[static_cast<std::size_t>(plan.bounds[i])] += plan.seconds[i];
        all_s += plan.seconds[i];
    }
    for (double& ratio : ratios) ratio = all_s > 0.0 ? ratio / all_s : 0.0;
    return ratios;
}

double usual_most(std::vector<float> values) {
    const auto rank =
        static_cast<std::ptrdiff_t>(std::floor(static_cast<double>(values.size() - 1) * (1.0 - kRareRatio)));
    std::ranges::nth_element(values, values.begin() + rank);
    return std::max<double>(values[static_cast<std::size_t>(rank)], kLeastRange_ms);
}

/// Rows turned round, each cell by its colour.
template <typename ColourOf>
std::vector<std::uint32_t> picture_of(const TimeMap& map, ColourOf colour_of) {
    std::vector<std::uint32_t> picture(map.way_ms.size());
    for (std::size_t row = 0; row < map.rows; ++row) {
        for (std::size_t column = 0; column < map.columns; ++column)
            picture[(map.rows - 1 - row) * map.columns + column] =
                0xFF000000U | colour_of(row * map.columns + column);
    }
    return picture;
}

}  // namespace

TimeMap time_map(const cam::PreparedJob& job, const PointPlan& plan, std::size_t most_columns,
                 std::size_t most_rows) {
    TimeMap map;
    const std::size_t layers = job.view.layer_count() - job.view.finishing_layer();
    map.columns = std::min<std::size_t>(most_columns, 2 * (std::size_t{job.view.point_count()} - 1));
    map.rows = std::min(most_rows, layers);
    map.way_ms.resize(map.columns * map.rows);
    map.bounds.resize(map.columns * map.rows, WayBound::unknown);
    Gatherer gatherer{job, plan, map};
    gatherer.gather();
    gatherer.fill();
    map.most_ms = usual_most(map.way_ms);
    map.bound_ratio = bound_ratios(plan);
    return map;
}

std::vector<std::uint32_t> time_picture(const TimeMap& map) {
    return picture_of(map, [&map](std::size_t place) { return viridis(map.way_ms[place] / map.most_ms); });
}

std::vector<std::uint32_t> bound_picture(const TimeMap& map,
                                         const std::array<std::uint32_t, kWayBoundCount>& colours) {
    return picture_of(
        map, [&](std::size_t place) { return colours[static_cast<std::size_t>(map.bounds[place])]; });
}

}  // namespace psicarve::session
