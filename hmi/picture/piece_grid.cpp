// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/picture/piece_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/base/units.hpp"

namespace psicarve::verify {

namespace {

constexpr std::size_t kMostRows = 600;
constexpr std::size_t kMostColumns = 720;
constexpr std::size_t kFewestRows = 120;  // fewer layers are drawn as the steps that they are

/// Radii resampled to the grid, and the heights of its rows.
struct Radii {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<float> mm;
    std::vector<float> height_mm;

    float at(std::size_t row, std::size_t column) const { return mm[row * columns + column]; }
};

/// Heights between which a layer's cut stands: half way to its neighbours.
std::vector<double> layer_edges_mm(const CarvedSurface& surface) {
    const std::uint32_t count = surface.layer_count();
    std::vector<double> edges(count + 1);
    for (std::uint32_t i = 1; i < count; ++i)
        edges[i] = (surface.layer_height_mm(i - 1) + surface.layer_height_mm(i)) / 2.0;
    const double thick = count > 1 ? surface.layer_height_mm(1) - surface.layer_height_mm(0) : 1.0;
    edges[0] = surface.layer_height_mm(0) - thick / 2.0;
    edges[count] = surface.layer_height_mm(count - 1) +
                   (count > 1 ? surface.layer_height_mm(count - 1) - edges[count - 1] : thick / 2.0);
    return edges;
}

void average_row(const CarvedSurface& surface, std::size_t first, std::size_t end, std::size_t columns,
                 float* out) {
    const std::size_t directions = surface.direction_count();
    for (std::size_t c = 0; c < columns; ++c) {
        const std::size_t from = c * directions / columns;
        const std::size_t to = std::max(from + 1, (c + 1) * directions / columns);
        double sum = 0.0;
        for (std::size_t layer = first; layer < end; ++layer) {
            const auto radii = surface.radii_mm(static_cast<std::uint32_t>(layer));
            for (std::size_t d = from; d < to; ++d) sum += static_cast<double>(radii[d]);
        }
        out[c] = static_cast<float>(sum / static_cast<double>((to - from) * (end - first)));
    }
}

Radii resample(const CarvedSurface& surface) {
    const std::vector<double> edges = layer_edges_mm(surface);
    const std::size_t layers = surface.layer_count();
    Radii radii;
    radii.columns = std::min<std::size_t>(surface.direction_count(), kMostColumns);
    const std::size_t bands = std::min(layers, kMostRows);
    const bool as_steps = layers < kFewestRows;
    radii.rows = as_steps ? 2 * bands : bands;
    radii.mm.resize(radii.rows * radii.columns);
    std::vector<float> row(radii.columns);
    for (std::size_t b = 0; b < bands; ++b) {
        const std::size_t first = b * layers / bands;
        const std::size_t end = (b + 1) * layers / bands;
        average_row(surface, first, end, radii.columns, row.data());
        const std::size_t copies = as_steps ? 2 : 1;
        for (std::size_t n = 0; n < copies; ++n)
            std::copy(row.begin(), row.end(), radii.mm.data() + (b * copies + n) * radii.columns);
        if (as_steps) {
            radii.height_mm.push_back(static_cast<float>(edges[first]));
            radii.height_mm.push_back(static_cast<float>(edges[end]));
        } else {
            const double low = b == 0 ? edges[first] : (edges[first] + edges[end]) / 2.0;
            radii.height_mm.push_back(static_cast<float>(b + 1 == bands ? edges[end] : low));
        }
    }
    return radii;
}

/// A spiral's rows are not level: interpolates between the two that lie around a height in its direction.
float radius_at(const CarvedSurface& surface, std::uint32_t direction, double height_mm) {
    std::uint32_t above = 1;
    for (std::uint32_t end = surface.layer_count() - 1; above < end;) {
        const std::uint32_t middle = above + (end - above) / 2;
        if (surface.height_mm(middle, direction) < height_mm) {
            above = middle + 1;
        } else {
            end = middle;
        }
    }
    const double low_mm = surface.height_mm(above - 1, direction);
    const double high_mm = surface.height_mm(above, direction);
    const double part =
        high_mm > low_mm ? std::clamp((height_mm - low_mm) / (high_mm - low_mm), 0.0, 1.0) : 0.0;
    const auto low = static_cast<double>(surface.radii_mm(above - 1)[direction]);
    const auto high = static_cast<double>(surface.radii_mm(above)[direction]);
    return static_cast<float>(low + part * (high - low));
}

Radii resample_spiral(const CarvedSurface& surface) {
    const std::size_t directions = surface.direction_count();
    const double bottom_mm = surface.layer_height_mm(0);
    const double height_mm = surface.layer_height_mm(surface.layer_count() - 1) - bottom_mm;
    Radii radii;
    radii.columns = std::min(directions, kMostColumns);
    radii.rows = std::clamp<std::size_t>(2 * surface.layer_count(), 2, kMostRows);
    for (std::size_t row = 0; row < radii.rows; ++row) {
        const double part = static_cast<double>(row) / static_cast<double>(radii.rows - 1);
        const double at_mm = bottom_mm + part * height_mm;
        radii.height_mm.push_back(static_cast<float>(at_mm));
        for (std::size_t c = 0; c < radii.columns; ++c) {
            const auto direction = static_cast<std::uint32_t>(c * directions / radii.columns);
            radii.mm.push_back(radius_at(surface, direction, at_mm));
        }
    }
    return radii;
}

/// Running mean over a window of columns (round) and rows.
std::vector<float> blurred(const Radii& radii, std::size_t half_columns, std::size_t half_rows) {
    const std::size_t rows = radii.rows;
    const std::size_t columns = radii.columns;
    std::vector<float> across(radii.mm.size());
    for (std::size_t r = 0; r < rows; ++r) {
        double sum = 0.0;
        for (std::size_t k = 0; k <= 2 * half_columns; ++k)
            sum += static_cast<double>(radii.at(r, (k + columns - half_columns % columns) % columns));
        for (std::size_t c = 0; c < columns; ++c) {
            across[r * columns + c] = static_cast<float>(sum / static_cast<double>(2 * half_columns + 1));
            sum += static_cast<double>(radii.at(r, (c + half_columns + 1) % columns)) -
                   static_cast<double>(radii.at(r, (c + columns - half_columns % columns) % columns));
        }
    }
    std::vector<float> result(radii.mm.size());
    std::vector<double> sums(columns, 0.0);
    const auto add_row = [&](std::size_t r, double sign) {
        for (std::size_t c = 0; c < columns; ++c)
            sums[c] += sign * static_cast<double>(across[r * columns + c]);
    };
    std::size_t low = 0;
    std::size_t high = 0;  // rows low .. high-1 are in sums
    for (std::size_t r = 0; r < rows; ++r) {
        while (high < std::min(rows, r + half_rows + 1)) add_row(high++, 1.0);
        while (low + half_rows < r) add_row(low++, -1.0);
        for (std::size_t c = 0; c < columns; ++c)
            result[r * columns + c] = static_cast<float>(sums[c] / static_cast<double>(high - low));
    }
    return result;
}

/// Places below the mean of their surroundings see less of the sky: an imitation of ambient occlusion.
void shade_grooves(const Radii& radii, PieceGrid& grid) {
    const double height = std::max(1e-3, static_cast<double>(grid.top_mm - grid.bottom_mm));
    const double around = 2.0 * kPi * static_cast<double>(grid.radius_mm);
    for (const double window_mm : {0.12, 0.03}) {
        const double half_mm = window_mm * static_cast<double>(grid.radius_mm);
        const auto half_columns =
            static_cast<std::size_t>(half_mm / around * static_cast<double>(radii.columns)) + 1;
        const auto half_rows =
            static_cast<std::size_t>(half_mm / height * static_cast<double>(radii.rows)) + 1;
        const std::vector<float> mean = blurred(radii, half_columns, half_rows);
        for (std::size_t n = 0; n < grid.nodes.size(); ++n) {
            const float below = (mean[n] - radii.mm[n]) / static_cast<float>(half_mm);
            grid.nodes[n].openness *= std::clamp(1.0F - 0.9F * below, 0.35F, 1.08F);
        }
    }
}

Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

void find_normals(PieceGrid& grid) {
    for (std::size_t r = 0; r < grid.rows; ++r) {
        const std::size_t below = r == 0 ? 0 : r - 1;
        const std::size_t above = std::min(r + 1, grid.rows - 1);
        for (std::size_t c = 0; c < grid.columns; ++c) {
            const Vec3& east = grid.at(r, (c + 1) % grid.columns).position_mm;
            const Vec3& west = grid.at(r, (c + grid.columns - 1) % grid.columns).position_mm;
            const Vec3& up = grid.at(above, c).position_mm;
            const Vec3& down = grid.at(below, c).position_mm;
            Vec3 n = cross({east.x - west.x, east.y - west.y, east.z - west.z},
                           {up.x - down.x, up.y - down.y, up.z - down.z});
            const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
            const float scale = length > 0.0F ? 1.0F / length : 0.0F;
            grid.nodes[r * grid.columns + c].normal = {n.x * scale, n.y * scale, n.z * scale};
        }
    }
}

PieceGrid grid_of(const Radii& radii) {
    PieceGrid grid;
    grid.rows = radii.rows;
    grid.columns = radii.columns;
    grid.bottom_mm = radii.height_mm.front();
    grid.top_mm = radii.height_mm.back();
    grid.radius_mm = std::max(1e-3F, *std::max_element(radii.mm.begin(), radii.mm.end()));
    grid.nodes.resize(radii.mm.size());
    for (std::size_t r = 0; r < grid.rows; ++r) {
        for (std::size_t c = 0; c < grid.columns; ++c) {
            const double turn = static_cast<double>(c) / static_cast<double>(grid.columns) * 2.0 * kPi;
            const double mm = static_cast<double>(radii.at(r, c));
            grid.nodes[r * grid.columns + c].position_mm = {static_cast<float>(mm * std::cos(turn)),
                                                            static_cast<float>(mm * std::sin(turn)),
                                                            radii.height_mm[r]};
        }
    }
    find_normals(grid);
    shade_grooves(radii, grid);
    return grid;
}

}  // namespace

PieceGrid make_piece_grid(const CarvedSurface& surface) {
    return grid_of(surface.is_spiral() ? resample_spiral(surface) : resample(surface));
}

PieceGrid make_piece_grid(std::size_t columns, std::vector<float> radii_mm, std::vector<float> heights_mm) {
    return grid_of({heights_mm.size(), columns, std::move(radii_mm), std::move(heights_mm)});
}

}  // namespace psicarve::verify
