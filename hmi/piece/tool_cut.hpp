// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hmi/piece/stock_map.hpp"
#include "hmi/tool/tool.hpp"

namespace psicarve::piece {

/// The greatest angle to the side at which a tool's front is seen from the axis.
inline constexpr double kWidest_rad = 1.5;

/// Cells of a stock map that a tool may reach: columns in which its front is seen from the axis, the first of
/// them unwrapped, and rows within its radius.
struct ReachedColumns {
    ReachedColumns(const tool::Tool& tool, std::size_t column_count, double direction_rad,
                   double tip_mm) noexcept;
    std::int64_t first;
    std::size_t count;
};
struct ReachedRows {
    ReachedRows(const tool::Tool& tool, const StockMap& stock, double height_mm) noexcept;
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Cuts out of a stock map what a tool whose axis lies on a radius reaches from one place. On the ray in the
/// direction D from the tool's axis, dy above it, material ends where the ray enters the tool:
///
///     flat   rho = r / cos D
///     ball   rho = c cos D - sqrt(R^2 - dy^2 - c^2 sin^2 D),   c = r + R
///     vee    rho = (r cos D + k sqrt(r^2 sin^2 D + A dy^2)) / A,   A = cos^2 D - k^2 sin^2 D,   k = 1 /
///     tan(angle/2)
///
/// with r the tip's radius, all within the tool's radius R across: (rho sin D)^2 + dy^2 <= R^2. A ray that
/// leaves the tool's side again before the blank's surface is left uncut. A point tool cuts the one cell that
/// it stands in, both cells where it is at most `point_reach_mm` from the boundary of two rows, or none when
/// its direction is further than `point_reach_rad` from the column. One thread.
class ToolCut {
public:
    ToolCut(const tool::Tool& tool, StockMap& stock, double point_reach_rad = 7.0,
            double point_reach_mm = 0.0);

    /// Cuts with the tool's axis at a direction and height, its tip at a radius >= 0.
    void at(double direction_rad, double height_mm, double tip_mm);
    /// The depth of its cut there, along the radius, where it would cut most [mm]; not for a point. Changes
    /// nothing.
    double bite_mm(double direction_rad, double height_mm, double tip_mm);
    /// Cells tested so far.
    std::uint64_t contacts() const noexcept { return contacts_; }

private:
    struct Ray {
        float cosine;
        float sine2;
    };
    void prick(double direction_rad, double height_mm, double tip_mm);
    void aim(double direction_rad, double tip_mm);
    void visit_rows(double direction_rad, double height_mm, double tip_mm);
    void visit_row(std::span<float> radii, float tip, float across2, float height2);
    template <typename Entry>
    void cut_run(float* radii, const Ray* rays, std::size_t count, float across2, const Entry& entry) const;
    template <typename Entry>
    float deepest_of_run(const float* radii, const Ray* rays, std::size_t count, float across2,
                         const Entry& entry) const;

    tool::Tool tool_;
    float flank_slope_;
    double point_reach_rad_;
    double point_reach_mm_;
    StockMap& stock_;
    std::vector<float> cosine_;  ///< by column
    std::vector<float> sine_;
    std::vector<Ray> rays_;  ///< of the columns within reach, from the first on
    std::size_t first_ = 0;
    std::uint64_t contacts_ = 0;
    bool only_measures_ = false;
    float deepest_ = 0.0F;  ///< found by the last measurement
};

}  // namespace psicarve::piece
