// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/picture/deviation_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

namespace psicarve::verify {

namespace {

using Colour = std::array<double, 3>;

Colour mixed(const Colour& a, const Colour& b, double part) {
    return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])};
}

/// The cells of one pixel: at least one.
struct CellRange {
    std::uint32_t first;
    std::uint32_t end;
};
CellRange cells_of(std::size_t pixel, std::size_t pixels, std::uint32_t cells) {
    const auto first = static_cast<std::uint32_t>(pixel * cells / pixels);
    const auto end = static_cast<std::uint32_t>((pixel + 1) * cells / pixels);
    return {first, std::max(first + 1, end)};
}

bool is_shown(const CarvedSurface& surface, std::uint32_t layer, std::uint32_t direction, MapShows shows) {
    if (shows == MapShows::all || surface.is_carved(layer, direction)) return true;
    return shows == MapShows::asked_for && surface.holds_point(layer, direction);
}

/// Nothing: none of them counts.
std::optional<std::int32_t> largest_in(const CarvedSurface& surface, CellRange layers, CellRange directions,
                                       MapShows shows) {
    std::optional<std::int32_t> largest;
    for (std::uint32_t layer = layers.first; layer < layers.end; ++layer) {
        for (std::uint32_t d = directions.first; d < directions.end; ++d) {
            if (!is_shown(surface, layer, d, shows)) continue;
            const std::int32_t deviation = surface.deviation_pulses(layer, d);
            if (!largest || std::abs(deviation) > std::abs(*largest)) largest = deviation;
        }
    }
    return largest;
}

/// The layers of a row of pixels in one direction: its share of the piece's height.
CellRange spiral_layers(const CarvedSurface& surface, std::uint32_t direction, std::size_t pixel,
                        std::size_t pixels) {
    const std::uint32_t count = surface.layer_count();
    const double bottom_mm = surface.layer_height_mm(0);
    const double height_mm = surface.layer_height_mm(count - 1) - bottom_mm;
    const auto first_from = [&](std::size_t edge) {
        const double edge_mm =
            bottom_mm + height_mm * static_cast<double>(edge) / static_cast<double>(pixels);
        std::uint32_t first = 0;
        for (std::uint32_t end = count; first < end;) {
            const std::uint32_t middle = first + (end - first) / 2;
            if (surface.height_mm(middle, direction) < edge_mm) {
                first = middle + 1;
            } else {
                end = middle;
            }
        }
        return first;
    };
    const std::uint32_t first = first_from(pixel);
    const std::uint32_t end = pixel + 1 == pixels ? count : first_from(pixel + 1);
    if (first < end) return {first, end};
    return {std::min(first, count - 1), std::min(first, count - 1) + 1};
}

/// Light falling flat from the upper left onto the unrolled relief: 0.6 .. 1.
double relief_grey(const CarvedSurface& surface, std::uint32_t layer, std::uint32_t direction,
                   CellRange step_layers, CellRange step_directions) {
    const std::uint32_t rows = surface.layer_count();
    const std::uint32_t columns = surface.direction_count();
    const std::uint32_t across = std::max(1U, step_directions.end - step_directions.first);
    const std::uint32_t up = std::max(1U, step_layers.end - step_layers.first);
    const std::uint32_t above = std::min(rows - 1, layer + up);
    const std::uint32_t below = layer >= up ? layer - up : 0;
    const auto here = surface.radii_mm(layer);
    const double dr = static_cast<double>(here[(direction + across) % columns]) -
                      static_cast<double>(here[(direction + columns - across % columns) % columns]);
    const double dx = 2.0 * across / static_cast<double>(columns) * 6.2832 *
                      std::max(1.0, static_cast<double>(here[direction]));
    const double dz = static_cast<double>(surface.radii_mm(above)[direction]) -
                      static_cast<double>(surface.radii_mm(below)[direction]);
    const double dy = std::max(1e-3, surface.layer_height_mm(above) - surface.layer_height_mm(below));
    const double slope = 0.7 * dr / dx - 0.7 * dz / dy;
    return 0.84 + 0.16 * slope / std::sqrt(1.0 + slope * slope) * 1.5;
}

std::uint32_t pixel_of(const Colour& colour, double grey) {
    std::uint32_t argb = 0xFF000000U;
    for (std::size_t k = 0; k < 3; ++k) {
        const double bounded = std::clamp(colour[k] * grey, 0.0, 1.0);
        argb |= static_cast<std::uint32_t>(std::lround(bounded * 255.0)) << (16U - 8U * k);
    }
    return argb;
}

}  // namespace

DeviationScale::DeviationScale(std::int64_t largest_pulses)
    : reach_pulses_(std::max<std::int64_t>(1, largest_pulses)) {}

Colour DeviationScale::colour(double pulses) const noexcept {
    constexpr Colour kNone{0.95, 0.95, 0.93};
    constexpr Colour kLeft{0.98, 0.62, 0.30};
    constexpr Colour kLeftMost{0.72, 0.06, 0.10};
    constexpr Colour kDeep{0.35, 0.66, 0.90};
    constexpr Colour kDeepMost{0.08, 0.14, 0.55};
    const double part = std::clamp(std::abs(pulses) / static_cast<double>(reach_pulses_), 0.0, 1.0);
    const Colour& half = pulses < 0.0 ? kDeep : kLeft;
    const Colour& full = pulses < 0.0 ? kDeepMost : kLeftMost;
    return part < 0.5 ? mixed(kNone, half, 2.0 * part) : mixed(half, full, 2.0 * part - 1.0);
}

PixelImage draw_deviation_map(const CarvedSurface& surface, const DeviationScale& scale, std::size_t width_px,
                              std::size_t height_px, MapShows shows) {
    PixelImage image;
    image.width = width_px;
    image.height = height_px;
    image.argb.resize(width_px * height_px);
    for (std::size_t y = 0; y < height_px; ++y) {
        CellRange layers = cells_of(height_px - 1 - y, height_px, surface.layer_count());
        for (std::size_t x = 0; x < width_px; ++x) {
            const CellRange directions = cells_of(x, width_px, surface.direction_count());
            if (surface.is_spiral())
                layers = spiral_layers(surface, directions.first, height_px - 1 - y, height_px);
            const auto pulses = largest_in(surface, layers, directions, shows);
            std::uint32_t& pixel = image.argb[y * width_px + x];
            pixel = pulses
                        ? pixel_of(scale.colour(*pulses),
                                   relief_grey(surface, layers.first, directions.first, layers, directions))
                        : pixel_of(kUncarvedColour, 1.0);
        }
    }
    return image;
}

}  // namespace psicarve::verify
