// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/profile/profile.hpp"

namespace psicarve::piece {

/// The rows of a map that a point tool cuts: the one that holds it, and, at most `reach_mm` from a boundary,
/// or a quarter of a row, the one beyond as well. Y steps anywhere within its pulses, and a row that a point
/// passes along its boundary would be left out. May lie outside of the map.
struct PrickedRows {
    PrickedRows(double above_bottom_mm, double row_mm, double reach_mm) noexcept;
    std::int64_t first;
    std::int64_t last;
};
/// For `reach_mm`: the most pulses of Y by which its steps lie off their even share.
inline constexpr double kPointReach_pulses = 2.0;

/// The rest of a cylindrical blank: in each direction at each height the radius up to which there is
/// material. Material behind a cut, seen from the axis, counts as gone only where nothing of the blank stands
/// outside it: a map of radii cannot hold overhangs.
class StockMap {
public:
    /// Rows of `row_mm` from `bottom_mm` up; columns stand at 2 pi i / column_count.
    /// Requires at least 4 columns and one row, and lengths greater than zero.
    StockMap(double radius_mm, double bottom_mm, double row_mm, std::size_t row_count,
             std::size_t column_count);

    /// Before anything is cut: puts the cylinder off the table's axis. Requires that the axis is in it.
    void stand_off(const BlankProfile& blank);

    std::size_t row_count() const noexcept { return row_count_; }
    std::size_t column_count() const noexcept { return column_count_; }
    /// How far the blank reaches out, all round.
    double blank_radius_mm() const noexcept { return blank_radius_mm_; }
    double bottom_mm() const noexcept { return bottom_mm_; }
    double row_mm() const noexcept { return row_mm_; }
    /// Height of a row's middle.
    double height_mm(std::size_t row) const noexcept {
        return bottom_mm_ + (static_cast<double>(row) + 0.5) * row_mm_;
    }
    double direction_rad(std::size_t column) const noexcept;
    /// Radius of the blank before anything is cut.
    double surface_mm(std::size_t column) const noexcept { return surface_mm_[column]; }

    /// Radii of a row, by column [mm].
    std::span<const float> row(std::size_t row) const noexcept {
        return {radius_mm_.data() + row * column_count_, column_count_};
    }
    std::span<float> row(std::size_t row) noexcept {
        return {radius_mm_.data() + row * column_count_, column_count_};
    }
    /// Volume that has been cut away.
    double removed_mm3() const noexcept;

private:
    double blank_radius_mm_;
    double bottom_mm_;
    double row_mm_;
    std::size_t row_count_;
    std::size_t column_count_;
    std::vector<float> radius_mm_;
    std::vector<float> surface_mm_;  ///< of the blank, by column
};

}  // namespace psicarve::piece
