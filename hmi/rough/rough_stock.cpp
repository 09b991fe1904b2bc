// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/rough/rough_stock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hmi/tool/tool.hpp"
#include "shared/base/units.hpp"

namespace psicarve::rough {
namespace {

constexpr double kCellsAcrossTool = 12.0;
constexpr std::size_t kLeastColumns = 90;
constexpr std::size_t kMostColumns = 7200;
constexpr double kMostRows = 20'000.0;

}  // namespace

RoughStock::RoughStock(const Rings& rings, const Profile& profile)
    : rings_(rings),
      blank_mm_(profile.blank.reach_mm()),
      top_mm_(profile.blank.height_mm > 0.0 ? profile.blank.height_mm : std::numeric_limits<double>::max()) {
    if (profile.tool.shape == ToolShape::point) {
        for (std::size_t i = 0; i < rings.ring_count() * rings.cell_count(); ++i) {
            const double direction_rad = rings.direction_rad(i % rings.cell_count());
            places_.push_back(static_cast<float>(profile.blank.surface_mm(direction_rad)));
        }
        return;
    }
    const tool::Tool tool = tool::tool_of(profile.tool, 1.0);
    const double reach_mm = tool.radius;
    const double bottom_mm = std::max(0.0, rings.height_mm(0) - reach_mm);
    const double top_mm = std::min(top_mm_, rings.height_mm(rings.ring_count() - 1) + reach_mm);
    if (top_mm <= bottom_mm) return;
    const double cell_mm = 2.0 * reach_mm / kCellsAcrossTool;
    const double columns = std::ceil(2.0 * kPi * blank_mm_ / cell_mm);
    const auto column_count = static_cast<std::size_t>(
        std::clamp(columns, static_cast<double>(kLeastColumns), static_cast<double>(kMostColumns)));
    const double rows = std::clamp(std::ceil((top_mm - bottom_mm) / cell_mm), 1.0, kMostRows);
    map_.emplace(blank_mm_, bottom_mm, (top_mm - bottom_mm) / rows, static_cast<std::size_t>(rows),
                 column_count);
    map_->stand_off(profile.blank);
    tool_cut_.emplace(tool, *map_);
    steps_per_cell_ = std::max<std::size_t>(1, column_count / rings.cell_count());
}

RoughStock::Contact RoughStock::contact(const TipPlace& place) const noexcept {
    const RoughHead& head = rings_.head(place.head);
    return {rings_.direction_rad(place.cell) + head.turn_rad, rings_.height_mm(place.ring) + head.height_mm};
}

double RoughStock::bite_mm(const TipPlace& place) {
    const Contact at = contact(place);
    if (tool_cut_) return tool_cut_->bite_mm(at.direction_rad, at.height_mm, std::max(0.0, place.tip_mm));
    if (places_.empty() || !has_material(at.height_mm)) return 0.0;
    const auto stands_mm = static_cast<double>(places_[place.ring * rings_.cell_count() + place.cell]);
    return std::max(0.0, stands_mm - place.tip_mm);
}

template <typename Visit>
void RoughStock::visit_steps(const TipPlace& place, const TipPlace& next, std::size_t first,
                             const Visit& visit) const {
    const Contact at = contact(place);
    const double turn_rad = std::remainder(contact(next).direction_rad - at.direction_rad, 2.0 * kPi);
    for (std::size_t step = first; step < steps_per_cell_; ++step) {
        const double part = static_cast<double>(step) / static_cast<double>(steps_per_cell_);
        const double tip_mm = place.tip_mm + part * (next.tip_mm - place.tip_mm);
        visit(at.direction_rad + part * turn_rad, at.height_mm, std::max(0.0, tip_mm));
    }
}

double RoughStock::bite_between_mm(const TipPlace& place, const TipPlace& next) {
    double most_mm = 0.0;
    if (!tool_cut_) return most_mm;
    visit_steps(place, next, 1, [&](double direction_rad, double height_mm, double tip_mm) {
        most_mm = std::max(most_mm, tool_cut_->bite_mm(direction_rad, height_mm, tip_mm));
    });
    return most_mm;
}

void RoughStock::cut(const TipPlace& place, const TipPlace& next) {
    if (tool_cut_) {
        return visit_steps(place, next, 0, [this](double direction_rad, double height_mm, double tip_mm) {
            tool_cut_->at(direction_rad, height_mm, tip_mm);
        });
    }
    const Contact at = contact(place);
    if (places_.empty() || !has_material(at.height_mm)) return;
    float& radius = places_[place.ring * rings_.cell_count() + place.cell];
    radius = std::min(radius, static_cast<float>(place.tip_mm));
}

void RoughStock::restore(const Saved& saved) {
    if (map_) *map_ = *saved.map;
    places_ = saved.places;
}

}  // namespace psicarve::rough
