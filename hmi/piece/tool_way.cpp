// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/tool_way.hpp"

#include <algorithm>
#include <cmath>

#include "hmi/piece/piece_carver.hpp"

namespace psicarve::piece {
namespace {

constexpr std::size_t kMostViewCells = 1'000'000;
constexpr std::size_t kLeastViewColumns = 60;
constexpr double kDeepRatio = 1.0 / 16.0;  // of a cell
constexpr std::size_t kPsiAxis = index_of(Axis::psi);
constexpr std::size_t kYAxis = index_of(Axis::y);

}  // namespace

StockMap view_blank_of(const verify::JobGeometry& geometry, const Profile& profile, std::size_t columns) {
    while (true) {
        StockMap stock = blank_of(geometry, profile, columns);
        if (stock.row_count() * stock.column_count() <= kMostViewCells || columns <= kLeastViewColumns)
            return stock;
        columns = std::max(kLeastViewColumns, columns / 2);
    }
}

ToolWay::ToolWay(const verify::JobGeometry& geometry, const StockMap& stock)
    : geometry_(geometry),
      blank_radius_mm_(stock.blank_radius_mm()),
      psi_pulses_(static_cast<double>(geometry.rev_pulses()) / static_cast<double>(stock.column_count())),
      y_pulses_(stock.row_mm() * geometry.y_pulses_per_mm()) {
    for (std::size_t h = 0; h < verify::kHeadCount; ++h)
        deep_pulses_[h] = kDeepRatio * stock.row_mm() * geometry.head(h).pulses_per_mm;
}

double ToolWay::cells_between(const verify::Positions& from, const verify::Positions& to) const noexcept {
    return std::max(std::abs(static_cast<double>(to[kPsiAxis] - from[kPsiAxis])) / psi_pulses_,
                    std::abs(static_cast<double>(to[kYAxis] - from[kYAxis])) / y_pulses_);
}

void ToolWay::between(const verify::Positions& from, const verify::Positions& to, const Cut& cut) const {
    const auto parts = std::max<std::int64_t>(1, std::llround(std::ceil(2.0 * cells_between(from, to))));
    for (std::int64_t part = 1; part < parts; ++part) {
        const double ratio = static_cast<double>(part) / static_cast<double>(parts);
        verify::Positions at{};
        for (std::size_t axis = 0; axis < kAxisCount; ++axis)
            at[axis] = from[axis] + std::llround(ratio * static_cast<double>(to[axis] - from[axis]));
        cut(at);
    }
    cut(to);
}

void ToolWay::go(const verify::Positions& to, const Cut& cut) {
    if (told_) {
        between(*told_, to, [&](const verify::Positions& at) { take(at, cut); });
    } else {
        take(to, cut);
    }
    told_ = to;
}

void ToolWay::go_layer(std::uint32_t layer, std::uint32_t end_step, const Cut& cut) {
    lift();
    for (std::uint32_t step = 0; step < std::min(end_step, geometry_.point_count()); ++step)
        go(geometry_.target(layer, step), cut);
    lift();
}

void ToolWay::take(const verify::Positions& at, const Cut& cut) {
    if (is_outside(at)) return;
    if (cut_ && cells_between(*cut_, at) < near_ratio_) {
        bool is_deeper = false;
        for (std::size_t h = 0; h < verify::kHeadCount; ++h)
            is_deeper = is_deeper || static_cast<double>((*cut_)[h] - at[h]) > deep_pulses_[h];
        if (!is_deeper) return;
    }
    cut_ = at;
    cut(at);
}

/// No tool is further in than its tip.
bool ToolWay::is_outside(const verify::Positions& at) const noexcept {
    for (std::size_t h = 0; h < verify::kHeadCount; ++h) {
        if (geometry_.head(h).real_mm(at[h]) < blank_radius_mm_) return false;
    }
    return true;
}

}  // namespace psicarve::piece
