// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/relief.hpp"
#include "hmi/model/indexed_mesh.hpp"
#include "hmi/model/mesh_check.hpp"
#include "shared/base/units.hpp"

namespace psicarve::flat {
namespace {

constexpr double kStepWidth_mm = 0.01;  // beside a picture that goes not all round

/// A line of points up the body: its angle, and the samples on both sides.
struct Column {
    double angle_rad = 0.0;
    std::size_t left = 0;
    std::size_t right = 0;
    double share = 0.0;    ///< of `right`
    bool is_rest = false;  ///< beside the picture
};

/// Chords between columns leave the circle by no more than curves leave their straight pieces.
std::size_t pieces_of(double angle_rad, double radius_mm) {
    const double most_rad = 2.0 * std::acos(1.0 - std::min(kFlatness_mm / radius_mm, 1.0));
    return static_cast<std::size_t>(std::max(1.0, std::ceil(angle_rad / most_rad)));
}

std::vector<Column> columns_of(const DepthMap& map) {
    const double sweep_rad = 2.0 * kPi * map.share_of_turn;
    const double pitch_rad = sweep_rad / static_cast<double>(map.width);
    const std::size_t pieces = pieces_of(pitch_rad, map.radius_mm);
    const bool is_ring = map.share_of_turn == 1.0;
    std::vector<Column> columns;
    const auto rest = [&](double angle_rad) { columns.push_back({angle_rad, 0, 0, 0.0, true}); };
    // From the picture's edge to the middle of its first sample, and from the last one's to the other edge.
    const std::size_t edge_pieces = pieces_of(0.5 * pitch_rad, map.radius_mm);
    const auto edge = [&](double from_rad, std::size_t sample, std::size_t first) {
        for (std::size_t k = first; k < edge_pieces + first; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(edge_pieces);
            columns.push_back({from_rad + 0.5 * pitch_rad * share, sample, sample, 0.0, false});
        }
    };
    if (!is_ring) edge(0.0, 0, 0);
    for (std::size_t x = 0; x < map.width; ++x) {
        const bool is_last = x + 1 == map.width;
        const std::size_t next = is_last ? (is_ring ? 0 : x) : x + 1;
        const std::size_t here = is_last && !is_ring ? 1 : pieces;
        for (std::size_t k = 0; k < here; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(pieces);
            columns.push_back({(static_cast<double>(x) + 0.5 + share) * pitch_rad, x, next, share, false});
        }
    }
    if (is_ring) return columns;
    edge(sweep_rad - 0.5 * pitch_rad, map.width - 1, 1);
    const double gap_rad = 2.0 * kPi - sweep_rad;
    const double step_rad = std::min(kStepWidth_mm / map.radius_mm, 0.25 * gap_rad);
    const std::size_t rest_pieces = pieces_of(gap_rad - 2.0 * step_rad, map.radius_mm);
    for (std::size_t k = 0; k <= rest_pieces; ++k) {
        rest(sweep_rad + step_rad +
             (gap_rad - 2.0 * step_rad) * static_cast<double>(k) / static_cast<double>(rest_pieces));
    }
    return columns;
}

/// Rows from the bottom: the lower edge, the samples' heights, the upper edge.
struct Row {
    double height_mm;
    std::size_t sample;
};

std::vector<Row> rows_of(const DepthMap& map) {
    std::vector<Row> rows{{0.0, map.height - 1}};
    for (std::size_t y = map.height; y-- > 0;) {
        rows.push_back(
            {map.height_mm * (1.0 - (static_cast<double>(y) + 0.5) / static_cast<double>(map.height)), y});
    }
    rows.push_back({map.height_mm, 0});
    return rows;
}

double depth_at(const DepthMap& map, const Column& column, std::size_t y) {
    if (column.is_rest) return map.rest_depth_mm;
    const double left = map.at(column.left, y);
    return left + column.share * (static_cast<double>(map.at(column.right, y)) - left);
}

}  // namespace

Result<model::Mesh> body_of(const DepthMap& map, const std::string& format, const std::string& file) {
    const std::vector<Column> columns = columns_of(map);
    const std::vector<Row> rows = rows_of(map);
    const std::uint64_t n = columns.size();
    model::IndexedMesh mesh;
    for (const Row& row : rows) {
        for (const Column& column : columns) {
            const double radius_mm = map.radius_mm - depth_at(map, column, row.sample);
            mesh.add_point({radius_mm * std::cos(column.angle_rad), radius_mm * std::sin(column.angle_rad),
                            row.height_mm});
        }
    }
    const std::uint64_t bottom = mesh.point_count();
    mesh.add_point({0.0, 0.0, 0.0});
    mesh.add_point({0.0, 0.0, map.height_mm});
    const std::uint64_t top_row = (rows.size() - 1) * n;
    for (std::uint64_t x = 0; x < n; ++x) {
        const std::uint64_t next = (x + 1) % n;
        for (std::uint64_t row = 0; row < top_row; row += n) {
            mesh.add_polygon(std::array{row + x, row + next, row + n + next, row + n + x});
        }
        mesh.add_polygon(std::array{bottom, next, x});
        mesh.add_polygon(std::array{bottom + 1, top_row + x, top_row + next});
    }
    model::Mesh made = mesh.finish(format);
    made.axis_hint = std::array{0.0, 0.0};
    if (auto good = model::judge_mesh(made, file); !good) return good.error();
    made.warnings.insert(made.warnings.begin(), map.warnings.begin(), map.warnings.end());
    return made;
}

}  // namespace psicarve::flat
