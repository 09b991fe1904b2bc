// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "hmi/piece/stock_map.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::piece {

/// Cells once round of a piece for a view that follows the carving: as many as it draws.
inline constexpr std::size_t kViewColumns = 480;
/// A blank for a view that follows the carving: at most `columns` cells once round, fewer where the blank is
/// so tall that its map would have more than a million cells.
StockMap view_blank_of(const verify::JobGeometry& geometry, const Profile& profile, std::size_t columns);

/// Of the places that the axes pass, those that change a map, for a tool that has a size: each a quarter of a
/// cell from the one before, or deeper than it by a sixteenth.
class ToolWay {
public:
    using Cut = std::function<void(const verify::Positions&)>;

    ToolWay(const verify::JobGeometry& geometry, const StockMap& stock);

    /// The axes have moved here straight from the place before.
    void go(const verify::Positions& to, const Cut& cut);
    /// The way of the axes to the next place is not known.
    void lift() noexcept { told_.reset(); }
    /// Moves as the job says: a layer's points, up to before a step. Lifted before and behind it.
    void go_layer(std::uint32_t layer, std::uint32_t end_step, const Cut& cut);
    /// Halves the density of the places from now on.
    void coarsen() noexcept { near_ratio_ *= 2.0; }

    /// The straight way from one place to another, without the former: two places to a cell.
    void between(const verify::Positions& from, const verify::Positions& to, const Cut& cut) const;
    /// Cells of the map, of direction or height, on this way.
    double cells_between(const verify::Positions& from, const verify::Positions& to) const noexcept;

private:
    void take(const verify::Positions& at, const Cut& cut);
    bool is_outside(const verify::Positions& at) const noexcept;

    verify::JobGeometry geometry_;
    double blank_radius_mm_;
    double psi_pulses_;  ///< of a cell
    double y_pulses_;
    std::array<double, verify::kHeadCount> deep_pulses_{};
    double near_ratio_ = 0.25;               ///< of a cell
    std::optional<verify::Positions> told_;  ///< the place before
    std::optional<verify::Positions> cut_;   ///< the last that told
};

}  // namespace psicarve::piece
