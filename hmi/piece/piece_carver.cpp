// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/piece_carver.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::piece {
namespace {

// A small piece under a large tool needs no finer cells than the tool shows.
constexpr double kCellsAcrossTool = 40.0;
constexpr std::size_t kLeastColumns = 180;
// With a margin for rounding.
constexpr double kHalfPulse = 0.500001;
// The material that a point leaves above and below the layers does not matter.
constexpr double kLeastMargin_mm = 0.5;
constexpr double kMostRows = 20'000.0;

/// From layer to layer where all are equally far from each other, to a pulse; else 0.
double even_pitch_mm(const verify::JobGeometry& geometry) {
    // A spiral closes with a ring at the height of the row before.
    const std::uint32_t count = geometry.row_count() - (geometry.is_spiral() ? 1U : 0U);
    if (count < 2) return 0.0;
    const auto first = static_cast<double>(geometry.height(0));
    const double pitch =
        (static_cast<double>(geometry.height(count - 1)) - first) / static_cast<double>(count - 1);
    for (std::uint32_t layer = 0; layer < count; ++layer) {
        if (std::abs(static_cast<double>(geometry.height(layer)) - first - layer * pitch) > 1.0) return 0.0;
    }
    return pitch / geometry.y_pulses_per_mm();
}

/// The blank about the table's axis, and as far out as it reaches.
StockMap round_blank(const verify::JobGeometry& geometry, const Profile& profile, std::size_t columns) {
    const bool is_point = profile.tool.shape == ToolShape::point;
    const double radius_mm = std::max(
        profile.blank.radius_mm > 0.0 ? profile.blank.reach_mm() : geometry.blank_radius_mm(), 0.001);
    const double margin_mm = std::max(kLeastMargin_mm, is_point ? 0.0 : 0.5 * profile.tool.diameter_mm);
    const double scale = 1.0 / geometry.y_pulses_per_mm();
    const double first_mm = static_cast<double>(geometry.height(0)) * scale;
    const double last_mm = static_cast<double>(geometry.height(geometry.row_count() - 1)) * scale;
    const double top_mm = profile.blank.height_mm > 0.0 ? profile.blank.height_mm : last_mm + margin_mm;
    const double lowest_mm = first_mm - margin_mm;
    const double bottom_mm = profile.blank.height_mm > 0.0 ? std::min(0.0, first_mm) : lowest_mm;
    if (is_point) {
        // Its cuts have no width: each ray must be one that a pulse points at, each row one that is carved.
        columns = std::min(columns, static_cast<std::size_t>(geometry.rev_pulses()));
        if (const double pitch_mm = even_pitch_mm(geometry); pitch_mm > 0.0) {
            const double below = std::round((first_mm - bottom_mm) / pitch_mm - 0.5);
            const double above = std::round((top_mm - first_mm) / pitch_mm - 0.5);
            const double rows = std::max(0.0, below) + 1.0 + std::max(0.0, above);
            if (rows <= kMostRows) {
                return StockMap(radius_mm, first_mm - (std::max(0.0, below) + 0.5) * pitch_mm, pitch_mm,
                                static_cast<std::size_t>(rows), columns);
            }
        }
    }
    if (!is_point) {
        // A cut's cost grows with the square of this.
        const double most = std::ceil(2.0 * kPi * radius_mm * kCellsAcrossTool / profile.tool.diameter_mm);
        if (most < static_cast<double>(columns))
            columns = std::min(columns, std::max(kLeastColumns, static_cast<std::size_t>(most)));
    }
    const double cell_mm = 2.0 * kPi * radius_mm / static_cast<double>(columns);
    const double height_mm = std::max(cell_mm, top_mm - bottom_mm);
    const double rows = std::clamp(std::ceil(height_mm / cell_mm), 1.0, kMostRows);
    return StockMap(radius_mm, bottom_mm, height_mm / rows, static_cast<std::size_t>(rows), columns);
}

ToolSweep sweep_of(const verify::JobGeometry& geometry, const Profile& profile, StockMap& stock) {
    return ToolSweep(tool::tool_of(profile.tool, 1.0), stock, kHalfPulse * geometry.rad_per_pulse(),
                     kPointReach_pulses / geometry.y_pulses_per_mm());
}

/// Neither head reaches the other's columns within a sweep, so that they need not take turns.
bool are_opposite(const verify::JobGeometry& geometry) {
    const double between_rad =
        static_cast<double>(geometry.head(0).facing_pulses - geometry.head(1).facing_pulses) *
        geometry.rad_per_pulse();
    const double off_rad = std::abs(std::remainder(between_rad - kPi, 2.0 * kPi));
    return off_rad + 2.0 * ToolSweep::kMostTurn_rad + 2.0 * kWidest_rad < kPi;
}

}  // namespace

StockMap blank_of(const verify::JobGeometry& geometry, const Profile& profile, std::size_t columns) {
    StockMap stock = round_blank(geometry, profile, columns);
    if (profile.blank.reach_mm() > profile.blank.radius_mm) stock.stand_off(profile.blank);
    return stock;
}

PieceCarver::PieceCarver(const verify::JobGeometry& geometry, const Profile& profile, StockMap& stock,
                         Ridges* ridges)
    : geometry_(geometry),
      ridges_(ridges),
      sweeps_{sweep_of(geometry, profile, stock), sweep_of(geometry, profile, stock)},
      reach_different_columns_(are_opposite(geometry)) {}

void PieceCarver::settle(const verify::Positions& positions, bool spindle_on) {
    if (!spindle_on) return flush();
    if (deepest_ && (*deepest_)[kPsi] == positions[kPsi] && (*deepest_)[kY] == positions[kY]) {
        for (std::size_t h = 0; h < verify::kHeadCount; ++h)
            (*deepest_)[h] = std::min((*deepest_)[h], positions[h]);
        return;
    }
    flush();
    deepest_ = positions;
}

void PieceCarver::finish() {
    flush();
    cut_places();
}

void PieceCarver::cut_places() {
    for (ToolSweep& sweep : sweeps_) sweep.flush();
}

void PieceCarver::settle_ridges(const verify::Positions& positions) {
    if (ridges_ == nullptr) return;
    with_each_head(positions, [this](std::size_t, double direction_rad, double height_mm, double tip_mm) {
        ridges_->cut(direction_rad, height_mm, tip_mm);
    });
}

void PieceCarver::flush() {
    if (!deepest_) return;
    with_each_head(*deepest_, [this](std::size_t h, double direction_rad, double height_mm, double tip_mm) {
        sweeps_[h].at(direction_rad, height_mm, tip_mm);
        if (!reach_different_columns_) sweeps_[h].flush();
    });
    settle_ridges(*deepest_);
    deepest_.reset();
}

template <typename Cut>
void PieceCarver::with_each_head(const verify::Positions& positions, const Cut& cut) const {
    for (std::size_t h = 0; h < verify::kHeadCount; ++h) {
        const verify::HeadGeometry& head = geometry_.head(h);
        const double direction_rad =
            static_cast<double>(geometry_.direction(h, positions[kPsi])) * geometry_.rad_per_pulse();
        const double height_mm =
            static_cast<double>(positions[kY] + head.height_offset_pulses) / geometry_.y_pulses_per_mm();
        cut(h, direction_rad, height_mm, std::max(0.0, head.real_mm(positions[h])));
    }
}

}  // namespace psicarve::piece
