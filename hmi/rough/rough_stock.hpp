// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hmi/piece/stock_map.hpp"
#include "hmi/piece/tool_cut.hpp"
#include "hmi/rough/rings.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::rough {

/// A head's tip over a cell of a ring.
struct TipPlace {
    std::size_t head;
    std::size_t ring;
    std::size_t cell;
    double tip_mm;
};

/// The rest of the blank after the passes so far. For a tool that has a size a map of radii, twelve cells
/// across the tool; for a point one place for each cell of each ring.
class RoughStock {
public:
    /// Requires a blank with a radius. Where the blank does not reach the rings' heights nothing is ever cut.
    RoughStock(const Rings& rings, const Profile& profile);
    RoughStock(const RoughStock&) = delete;
    RoughStock& operator=(const RoughStock&) = delete;

    /// How deep, along the radius, the tool would cut from this place.
    double bite_mm(const TipPlace& place);
    /// The same on the straight way between two neighbouring cells, both left out.
    double bite_between_mm(const TipPlace& place, const TipPlace& next);
    /// Cuts from this place, and on the straight way towards a neighbouring cell, where the tip goes next.
    void cut(const TipPlace& place, const TipPlace& next);

    /// The present state, to return to.
    struct Saved {
        std::optional<piece::StockMap> map;
        std::vector<float> places;
    };
    Saved saved() const { return {map_, places_}; }
    void restore(const Saved& saved);

private:
    struct Contact {
        double direction_rad;
        double height_mm;
    };
    Contact contact(const TipPlace& place) const noexcept;
    /// Calls `visit(direction [rad], height [mm], tip's radius [mm])` from a place on towards its neighbour.
    template <typename Visit>
    void visit_steps(const TipPlace& place, const TipPlace& next, std::size_t first,
                     const Visit& visit) const;
    bool has_material(double height_mm) const noexcept { return height_mm <= top_mm_ && height_mm >= 0.0; }

    const Rings& rings_;
    double blank_mm_;
    double top_mm_;
    std::size_t steps_per_cell_ = 1;
    std::optional<piece::StockMap> map_;
    std::optional<piece::ToolCut> tool_cut_;  ///< into map_
    std::vector<float> places_;               ///< for a point tool
};

}  // namespace psicarve::rough
