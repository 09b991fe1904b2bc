// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/tool/surface_tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>
#include <thread>

#include "hmi/tool/dilation_lanes.hpp"
#include "hmi/tool/map_dilation.hpp"
#include "shared/base/units.hpp"

namespace psicarve::tool {
namespace {

using dilation::kQuad;
using dilation::larger;
using dilation::Quad;
using dilation::quad_at;
using dilation::smaller;
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

/// Where a tile's samples stand, four at a time.
class TilePlaces {
public:
    explicit TilePlaces(std::size_t side)
        : x_(side * side + kQuad), y_(side * side + kQuad), z_(side * side + kQuad) {}

    void clear() noexcept { count_ = 0; }
    void add(float x, float y, float z) noexcept {
        x_[count_] = x;
        y_[count_] = y;
        z_[count_++] = z;
    }
    /// Fills the last four with copies of the last place.
    void fill_up() noexcept {
        for (std::size_t i = count_; i % kQuad != 0; ++i) {
            x_[i] = x_[count_ - 1];
            y_[i] = y_[count_ - 1];
            z_[i] = z_[count_ - 1];
        }
    }
    std::size_t count() const noexcept { return count_; }
    Place at(std::size_t i) const noexcept { return {x_[i], y_[i], z_[i]}; }
    Quad x(std::size_t i) const noexcept { return quad_at(x_.data() + i); }
    Quad y(std::size_t i) const noexcept { return quad_at(y_.data() + i); }
    Quad z(std::size_t i) const noexcept { return quad_at(z_.data() + i); }

private:
    std::size_t count_ = 0;
    std::vector<float> x_, y_, z_;
};

float sum_of(const Quad& four) {
    return (four[0] + four[1]) + (four[2] + four[3]);
}
float most_of(const Quad& four) {
    return std::max(std::max(four[0], four[1]), std::max(four[2], four[3]));
}

/// Across the longest ways through the places, else outwards.
Place normal_of(const TilePlaces& places, const Place& middle) {
    const Place way = places.at(places.count() - 1) - places.at(0);
    const Place other = places.at(places.count() / 2) - places.at(0);
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

/// About their middle.
Place middle_of(const TilePlaces& places) {
    Quad x{};
    Quad y{};
    Quad z{};
    std::size_t count = 0;
    for (; count < places.count(); count += kQuad) {
        x += places.x(count);
        y += places.y(count);
        z += places.z(count);
    }
    const double share = 1.0 / static_cast<double>(count);
    return {share * sum_of(x), share * sum_of(y), share * sum_of(z)};
}

/// The places are filled up.
void set_tile(SurfaceTiles& tiles, std::size_t tile, const TilePlaces& places) {
    Place middle = middle_of(places);
    const Place normal = normal_of(places, middle);
    const auto normal_x = static_cast<float>(normal[0]);
    const auto normal_y = static_cast<float>(normal[1]);
    const auto normal_z = static_cast<float>(normal[2]);
    Quad low{};
    Quad high{};
    for (std::size_t i = 0; i < places.count(); i += kQuad) {
        const Quad along = (places.x(i) - static_cast<float>(middle[0])) * normal_x +
                           (places.y(i) - static_cast<float>(middle[1])) * normal_y +
                           (places.z(i) - static_cast<float>(middle[2])) * normal_z;
        low = smaller(low, along);
        high = larger(high, along);
    }
    const float most = most_of(high);
    const float least = -most_of(-low);
    for (std::size_t k = 0; k < 3; ++k) middle[k] += 0.5 * (double{least} + double{most}) * normal[k];
    const auto x = static_cast<float>(middle[0]);
    const auto y = static_cast<float>(middle[1]);
    const auto z = static_cast<float>(middle[2]);
    Quad reach2{};
    Quad radius2{};
    for (std::size_t i = 0; i < places.count(); i += kQuad) {
        const Quad way_x = places.x(i) - x;
        const Quad way_y = places.y(i) - y;
        const Quad way_z = places.z(i) - z;
        reach2 = larger(reach2, way_x * way_x + way_y * way_y + way_z * way_z);
        radius2 = larger(radius2, places.x(i) * places.x(i) + places.y(i) * places.y(i));
    }
    const double reach = std::sqrt(double{most_of(reach2)});
    const double slack = kBoundSlack_ratio * std::sqrt(inner(middle, middle) + reach * reach);
    tiles.x[tile] = x;
    tiles.y[tile] = y;
    tiles.z[tile] = z;
    tiles.normal_x[tile] = normal_x;
    tiles.normal_y[tile] = normal_y;
    tiles.normal_z[tile] = normal_z;
    tiles.bulge[tile] = static_cast<float>(0.5 * (double{most} - double{least}) + slack);
    tiles.reach[tile] = static_cast<float>(reach + slack);
    tiles.most_radius[tile] = static_cast<float>(std::sqrt(double{most_of(radius2)}) + slack);
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
    std::vector<std::array<float, 2>> directions;
    for (std::size_t column = 0; column < surface.column_count; ++column) {
        const double angle_rad =
            2.0 * kPi * static_cast<double>(column) / static_cast<double>(surface.column_count);
        directions.push_back(
            {static_cast<float>(std::cos(angle_rad)), static_cast<float>(std::sin(angle_rad))});
    }
    TilePlaces places(side);
    for (std::size_t tile = first_row * column_count; tile < end_row * column_count; ++tile) {
        const std::size_t low = tile / column_count * side;
        const std::size_t left = tile % column_count * side;
        float& least = least_radius[tile / column_count];
        places.clear();
        for (std::size_t row = low; row < std::min(surface.row_count, low + side); ++row) {
            const auto height = static_cast<float>(static_cast<double>(row) * surface.row_pitch);
            for (std::size_t column = left; column < std::min(surface.column_count, left + side); ++column) {
                const float radius = surface.radius[row * surface.column_count + column];
                if (!(radius > 0.0F)) continue;
                least = least > 0.0F ? std::min(least, radius) : radius;
                places.add(radius * directions[column][0], radius * directions[column][1], height);
            }
        }
        if (places.count() == 0) continue;
        places.fill_up();
        set_tile(*this, tile, places);
    }
}

}  // namespace psicarve::tool
