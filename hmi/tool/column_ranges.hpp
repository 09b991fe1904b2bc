// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hmi/tool/contact_parts.hpp"

namespace psicarve::tool {

/// Columns, by index: a first and a second range, either may be empty.
struct ColumnRanges {
    std::array<std::uint32_t, 2> first{};
    std::array<std::uint32_t, 2> end{};
};

/// Finds the columns of a turn from which a tool of some radius may touch parts of a mesh.
class ColumnFinder {
public:
    /// Ascending directions within one turn, the first in [0, 2 pi).
    ColumnFinder(std::span<const double> direction_rad, double radius) noexcept
        : directions_(direction_rad), radius_(radius) {}

    ColumnRanges of(const Edge& edge) const;
    ColumnRanges of(const Facet& facet) const;

private:
    ColumnRanges of(std::span<const Point> corners, bool holds_axis) const;
    ColumnRanges between(double low_rad, double high_rad) const;
    ColumnRanges all() const noexcept;

    std::span<const double> directions_;
    double radius_;
};

}  // namespace psicarve::tool
