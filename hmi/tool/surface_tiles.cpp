// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/surface_tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>
#include <thread>

#include "hmi/tool/map_dilation.hpp"
#include "shared/units.hpp"

namespace psicarve::tool {
namespace {

using Place = std::array<double, 3>;

// Of the lengths: what single precision may take from a bound.
constexpr double kBoundSlack_ratio = 1e-5;
// So far up that its square is still a number.
constexpr float kOutOfReach = 1e18F;

Place operator-(const Place& a, const Place& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double inner(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Across the longest ways through the places, else outwards.
Place normal_of(const std::vector<Place>& places, const Place& middle) {
    const Place way = places.back() - places.front();
    const Place other = places[places.size() / 2] - places.front();
    Place normal{way[1] * other[2] - way[2] * other[1], way[2] * other[0] - way[0] * other[2],
                 way[0] * other[1] - way[1] * other[0]};
    double length = std::sqrt(inner(normal, normal));
    if (length < 1e-6 * std::max(inner(way, way), 1e-30)) {
        normal = {middle[0], middle[1], 0.0};
        length = std::hypot(middle[0], middle[1]);
    }
    for (double& part : normal) part /= std::max(length, 1e-30);
    return normal;
}

void set_tile(SurfaceTiles& tiles, std::size_t tile, const std::vector<Place>& places) {
    Place middle{};
    for (const Place& place : places) {
        for (std::size_t k = 0; k < 3; ++k) middle[k] += place[k] / static_cast<double>(places.size());
    }
    const Place normal = normal_of(places, middle);
    double low = 0.0;
    double high = 0.0;
    for (const Place& place : places) {
        const double along = inner(place - middle, normal);
        low = std::min(low, along);
        high = std::max(high, along);
    }
    const double bulge = 0.5 * (high - low);
    for (std::size_t k = 0; k < 3; ++k) middle[k] += 0.5 * (low + high) * normal[k];
    double reach2 = 0.0;
    double most_radius2 = 0.0;
    for (const Place& place : places) {
        const Place way = place - middle;
        reach2 = std::max(reach2, inner(way, way));
        most_radius2 = std::max(most_radius2, place[0] * place[0] + place[1] * place[1]);
    }
    const double slack = kBoundSlack_ratio * std::sqrt(inner(middle, middle) + reach2);
    tiles.x[tile] = static_cast<float>(middle[0]);
    tiles.y[tile] = static_cast<float>(middle[1]);
    tiles.z[tile] = static_cast<float>(middle[2]);
    tiles.normal_x[tile] = static_cast<float>(normal[0]);
    tiles.normal_y[tile] = static_cast<float>(normal[1]);
    tiles.normal_z[tile] = static_cast<float>(normal[2]);
    tiles.bulge[tile] = static_cast<float>(bulge + slack);
    tiles.reach[tile] = static_cast<float>(std::sqrt(reach2) + slack);
    tiles.most_radius[tile] = static_cast<float>(std::sqrt(most_radius2) + slack);
}

}  // namespace

SurfaceTiles::SurfaceTiles(const SampledRadii& surface, std::size_t tile_side, unsigned thread_count)
    : side(tile_side),
      row_count((surface.row_count + side - 1) / side),
      column_count((surface.column_count + side - 1) / side),
      least_radius(row_count, 0.0F) {
    const std::size_t count = row_count * column_count + kReadPast;
    for (auto* values : {&x, &y, &normal_x, &normal_y, &normal_z, &bulge, &reach, &most_radius})
        values->assign(count, 0.0F);
    z.assign(count, kOutOfReach);
    std::vector<std::thread> threads;
    const std::size_t part = (row_count + thread_count - 1) / thread_count;
    std::size_t begun = std::min(part, row_count);
    try {
        for (; begun < row_count; begun += part)
            threads.emplace_back([this, &surface, begun, end = std::min(row_count, begun + part)] {
                fill(surface, begun, end);
            });
    } catch (const std::system_error&) {
        fill(surface, begun, row_count);
    }
    fill(surface, 0, std::min(part, row_count));
    for (std::thread& thread : threads) thread.join();
}

void SurfaceTiles::fill(const SampledRadii& surface, std::size_t first_row, std::size_t end_row) {
    std::vector<std::array<double, 2>> directions;
    for (std::size_t column = 0; column < surface.column_count; ++column) {
        const double angle_rad =
            2.0 * kPi * static_cast<double>(column) / static_cast<double>(surface.column_count);
        directions.push_back({std::cos(angle_rad), std::sin(angle_rad)});
    }
    std::vector<Place> places;
    for (std::size_t tile = first_row * column_count; tile < end_row * column_count; ++tile) {
        const std::size_t low = tile / column_count * side;
        const std::size_t left = tile % column_count * side;
        float& least = least_radius[tile / column_count];
        places.clear();
        for (std::size_t row = low; row < std::min(surface.row_count, low + side); ++row) {
            for (std::size_t column = left; column < std::min(surface.column_count, left + side); ++column) {
                const float radius = surface.radius[row * surface.column_count + column];
                if (!(radius > 0.0F)) continue;
                least = least > 0.0F ? std::min(least, radius) : radius;
                places.push_back({radius * directions[column][0], radius * directions[column][1],
                                  static_cast<double>(row) * surface.row_pitch});
            }
        }
        if (!places.empty()) set_tile(*this, tile, places);
    }
}

}  // namespace psicarve::tool
