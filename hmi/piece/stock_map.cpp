// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/stock_map.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::piece {

PrickedRows::PrickedRows(double above_bottom_mm, double row_mm, double reach_mm) noexcept {
    constexpr double kMostOfRow = 0.25;
    // With a margin for rounding.
    const double reach = std::min(1.000001 * reach_mm / row_mm, kMostOfRow);
    const double at = above_bottom_mm / row_mm;
    first = static_cast<std::int64_t>(std::floor(at - reach));
    last = static_cast<std::int64_t>(std::floor(at + reach));
}

StockMap::StockMap(double radius_mm, double bottom_mm, double row_mm, std::size_t row_count,
                   std::size_t column_count)
    : blank_radius_mm_(radius_mm),
      bottom_mm_(bottom_mm),
      row_mm_(row_mm),
      row_count_(row_count),
      column_count_(column_count),
      radius_mm_(row_count * column_count, static_cast<float>(radius_mm)),
      surface_mm_(column_count, static_cast<float>(radius_mm)) {}

void StockMap::stand_off(const BlankProfile& blank) {
    blank_radius_mm_ = blank.reach_mm();
    for (std::size_t column = 0; column < column_count_; ++column)
        surface_mm_[column] = static_cast<float>(blank.surface_mm(direction_rad(column)));
    for (std::size_t i = 0; i < radius_mm_.size(); ++i) radius_mm_[i] = surface_mm_[i % column_count_];
}

double StockMap::direction_rad(std::size_t column) const noexcept {
    return 2.0 * kPi * static_cast<double>(column) / static_cast<double>(column_count_);
}

double StockMap::removed_mm3() const noexcept {
    double sum = 0.0;
    for (std::size_t i = 0; i < radius_mm_.size(); ++i) {
        const double full = surface_mm_[i % column_count_];
        sum += full * full - static_cast<double>(radius_mm_[i]) * radius_mm_[i];
    }
    return 0.5 * sum * row_mm_ * 2.0 * kPi / static_cast<double>(column_count_);
}

}  // namespace psicarve::piece
