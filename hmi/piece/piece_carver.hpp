// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hmi/piece/ridges.hpp"
#include "hmi/piece/stock_map.hpp"
#include "hmi/piece/tool_sweep.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::piece {

/// A blank as big as the profile says, else as the job needs, in cells about as wide as high: `columns` of
/// them once round, fewer where 40 of them would be less than the tool's diameter. For a point tool the rows
/// are the layers, if these are evenly apart, and each column is one that a pulse of psi points at.
StockMap blank_of(const verify::JobGeometry& geometry, const Profile& profile, std::size_t columns);

/// Carves a stock map with both heads' tools along the pulses: it gets every position and cuts at each one of
/// psi and Y, at the deepest that either head had there. One thread.
class PieceCarver {
public:
    /// Cuts a model's ridges together with the stock, if there are any; both outlive this.
    PieceCarver(const verify::JobGeometry& geometry, const Profile& profile, StockMap& stock,
                Ridges* ridges = nullptr);

    /// Call it after each instant in which an axis stepped; cuts nothing with the spindle off.
    void settle(const verify::Positions& positions, bool spindle_on);
    /// Cuts only the model's ridges, for steps between those that are settled.
    void settle_ridges(const verify::Positions& positions);
    /// Call it before the stock is read.
    void finish();

private:
    void flush();
    void cut_places();
    template <typename Cut>
    void with_each_head(const verify::Positions& positions, const Cut& cut) const;

    verify::JobGeometry geometry_;
    Ridges* ridges_;
    std::array<ToolSweep, verify::kHeadCount> sweeps_;
    bool reach_different_columns_;
    std::optional<verify::Positions> deepest_;  ///< at one place of psi and Y
};

}  // namespace psicarve::piece
