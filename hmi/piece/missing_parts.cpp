// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/missing_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "shared/base/units.hpp"

namespace psicarve::piece {
namespace {

constexpr double kWorthLooking_mm = 0.01;
constexpr std::ptrdiff_t kReach_cells = 64;
constexpr std::size_t kReach_rows = 16;

std::array<double, 3> place_of(double direction_rad, double radius_mm, double height_mm) {
    return {radius_mm * std::cos(direction_rad), radius_mm * std::sin(direction_rad), height_mm};
}

}  // namespace

MissingParts::MissingParts(const StockMap& carved, std::span<const float> wanted_mm,
                           std::span<const std::size_t> rows)
    : carved_(carved),
      wanted_mm_(wanted_mm),
      first_row_(rows.front()),
      last_row_(rows.back()),
      piece_(carved, {carved.row(0).data(), carved.row_count() * carved.column_count()},
             {first_row_, last_row_}) {}

double MissingParts::at_cell(std::size_t row, std::size_t column) const {
    const std::size_t columns = carved_.column_count();
    // Where there is no blank, the tool is not at fault.
    const double radius_mm = std::min(double{wanted_mm_[row * columns + column]}, carved_.surface_mm(column));
    double missing_mm = radius_mm - double{carved_.row(row)[column]};
    if (missing_mm <= kWorthLooking_mm) return 0.0;
    const double side_mm = radius_mm * carved_.direction_rad(1);
    for (std::size_t r = std::max(row, first_row_ + 1) - 1; r <= std::min(row + 1, last_row_); ++r) {
        for (const std::size_t c : {(column + columns - 1) % columns, column, (column + 1) % columns}) {
            const double short_mm = radius_mm - double{carved_.row(r)[c]};
            const double beside_mm =
                std::hypot(c == column ? 0.0 : side_mm, r == row ? 0.0 : carved_.row_mm());
            if (beside_mm > 0.0 && short_mm <= beside_mm) return 0.0;
        }
    }
    return piece_.of(row, column, place_of(carved_.direction_rad(column), radius_mm, carved_.height_mm(row)),
                     missing_mm);
}

double MissingParts::at_ridge(const Ridges& ridges, std::size_t index) const {
    const double missing_mm = ridges.missing_mm(index);
    if (missing_mm <= kWorthLooking_mm) return 0.0;
    const Ridge& ridge = ridges.all()[index];
    double nearest_mm = std::min(missing_mm, in_row_mm(ridge, ridge.row));
    const std::size_t low = std::max(ridge.row, first_row_ + kReach_rows) - kReach_rows;
    for (std::size_t row = low; row <= std::min(ridge.row + kReach_rows, last_row_); ++row) {
        const double beside_mm = std::abs(carved_.height_mm(row) - ridge.height_mm);
        if (beside_mm >= nearest_mm || !ridges.is_cleared(carved_.height_mm(row))) continue;
        nearest_mm = std::min(nearest_mm, std::hypot(in_row_mm(ridge, row), beside_mm));
    }
    return nearest_mm;
}

double MissingParts::in_row_mm(const Ridge& ridge, std::size_t row) const {
    const std::size_t columns = carved_.column_count();
    const double step_rad = carved_.direction_rad(1);
    const double off_rad =
        std::remainder(ridge.direction_rad - carved_.direction_rad(ridge.column), 2.0 * kPi);
    // Seen along the ridge's own ray.
    const auto corner = [&](std::ptrdiff_t k) {
        const auto column = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(ridge.column + columns) + k);
        return std::polar(double{carved_.row(row)[column % columns]},
                          static_cast<double>(k) * step_rad - off_rad);
    };
    const std::complex<double> from{ridge.radius_mm, 0.0};
    const auto reach = std::min<std::ptrdiff_t>(kReach_cells, static_cast<std::ptrdiff_t>(columns / 4));
    double nearest_mm = ridge.radius_mm;
    for (std::ptrdiff_t k = -reach; k < reach; ++k) {
        const std::complex<double> a = corner(k);
        const std::complex<double> side = corner(k + 1) - a;
        const double length2 = std::norm(side);
        const double along = length2 > 0.0 ? (std::conj(side) * (from - a)).real() / length2 : 0.0;
        nearest_mm = std::min(nearest_mm, std::abs(from - a - std::clamp(along, 0.0, 1.0) * side));
    }
    return nearest_mm;
}

}  // namespace psicarve::piece
