// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/spiral_scan.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace psicarve::slice {
namespace {

constexpr double kHalfTurn = 2.0;  // in diamond angles
constexpr double kTurn = 4.0;

/// Diamond angles between which a facet is seen from the axis; from > to: past angle 0.
struct Width {
    double from;
    double to;
    bool is_all_round;
};

Width width_of(const std::array<FacetCutter::Corner, 3>& corners) noexcept {
    std::array<double, 3> angle{};
    bool holds_axis = false;
    for (std::size_t i = 0; i < 3; ++i) {
        angle[i] = diamond_angle(corners[i].x, corners[i].y);
        holds_axis = holds_axis || (corners[i].x == 0.0 && corners[i].y == 0.0);
    }
    std::sort(angle.begin(), angle.end());
    // A facet without the axis is seen under less than half a turn: the rest is one gap.
    if (!holds_axis && angle[2] - angle[0] < kHalfTurn) return {angle[0], angle[2], false};
    if (!holds_axis && angle[1] - angle[0] > kHalfTurn) return {angle[1], angle[0], false};
    if (!holds_axis && angle[2] - angle[1] > kHalfTurn) return {angle[2], angle[1], false};
    return {0.0, kTurn, true};
}

}  // namespace

SpiralScan::SpiralScan(const Directions& directions) : directions_(directions), height_(directions.count()) {
    const std::size_t count = directions.count();
    const std::size_t half = count / 2;
    for (std::size_t odd = 0; odd < 2; ++odd) {
        for (std::size_t cell = 0; cell < count; ++cell) {
            const std::size_t direction = (cell + directions.first_sorted()) % count;
            const std::size_t along = (direction + count - odd * half) % half;
            const std::size_t point = along == 0 ? half : along;
            part_[odd].push_back(static_cast<double>(point) / static_cast<double>(half));
        }
    }
}

void SpiralScan::begin_row(std::size_t row, double bottom, double top) noexcept {
    row_ = row;
    const std::vector<double>& part = part_[row % 2];
    for (std::size_t cell = 0; cell < height_.size(); ++cell) {
        height_[cell] = bottom + (top - bottom) * part[cell];
    }
}

std::uint32_t SpiralScan::open_cells(const LayerScan& scan) const noexcept {
    const std::size_t count = directions_.count();
    const std::size_t half = count / 2;
    std::array<std::uint32_t, 2> alike{};  // pairs with an even, an odd number of walls
    std::uint32_t unlike = 0;
    bool first = false;
    bool last = false;
    for (std::size_t point = 1; point <= half; ++point) {
        const std::size_t direction = row_ % 2 * half + point + count - directions_.first_sorted();
        const bool one = scan.is_odd(static_cast<std::uint32_t>(direction % count));
        const bool other = scan.is_odd(static_cast<std::uint32_t>((direction + half) % count));
        if (one != other) {
            ++unlike;
            continue;
        }
        if (alike[0] + alike[1] == 0) first = one;
        last = one;
        ++alike[one ? 1 : 0];
    }
    return unlike + (first == last ? 2 * alike[last ? 0 : 1] : 0);
}

void SpiralScan::add(const FacetCutter& cutter, const model::Triangle& facet,
                     LayerScan& scan) const noexcept {
    const std::array corners{cutter.corner(facet, 0), cutter.corner(facet, 1), cutter.corner(facet, 2)};
    const auto count = static_cast<std::uint32_t>(directions_.count());
    const Width width = width_of(corners);
    if (width.is_all_round) return add_in(cutter, facet, 0, count, scan);
    // A cut's ends are rounded: one cell more at either side.
    const std::uint32_t first = directions_.count_up_to(width.from) + count - 1;
    const std::uint32_t end =
        directions_.count_up_to(width.to) + count + 1 + (width.from > width.to ? count : 0);
    const std::uint32_t begin = first % count;
    const std::uint32_t stop = begin + std::min(count, end - first);
    add_in(cutter, facet, begin, std::min(stop, count), scan);
    if (stop > count) add_in(cutter, facet, 0, stop - count, scan);
}

void SpiralScan::add_in(const FacetCutter& cutter, const model::Triangle& facet, std::uint32_t first,
                        std::uint32_t end, LayerScan& scan) const noexcept {
    const float z0 = cutter.corner(facet, 0).z;
    const float z1 = cutter.corner(facet, 1).z;
    const float z2 = cutter.corner(facet, 2).z;
    const double low = std::min(std::min(z0, z1), z2);
    const double high = std::max(std::max(z0, z1), z2);
    for (std::uint32_t cell = first; cell < end; ++cell) {
        const double height = height_[cell];
        if (low <= height && height < high) scan.add_segment_in(cutter.cut(facet, height), cell);
    }
}

}  // namespace psicarve::slice
