// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/workpiece.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "shared/base/units.hpp"

namespace psicarve::sim {
namespace {

// Finer than a caliper reads on a blank of this kind. Uncut cells take no memory.
constexpr std::size_t kColumns = 14'400;
constexpr double kRow_mm = 0.01;
// A cell: the radius in hundredths of a micrometre, above the head's bit. Never 0 once it is cut.
constexpr double kRadiusSteps_per_mm = 1e5;

constexpr std::uint32_t cell_of(double radius_mm, std::size_t head) noexcept {
    const auto steps = static_cast<std::uint32_t>(std::max(1.0, radius_mm * kRadiusSteps_per_mm + 0.5));
    return steps << 1 | static_cast<std::uint32_t>(head);
}

}  // namespace

std::unique_ptr<Workpiece> Workpiece::make(const SimConfig& config) {
    const auto rows = static_cast<std::size_t>(std::ceil(config.blank.height_mm / kRow_mm));
    // The kernel provides only the used pages of a large calloc.
    Cells cells{static_cast<std::uint32_t*>(std::calloc(rows * kColumns, sizeof(std::uint32_t)))};
    if (cells == nullptr) return nullptr;
    return std::unique_ptr<Workpiece>{new Workpiece(config, rows, std::move(cells))};
}

Workpiece::Workpiece(const SimConfig& config, std::size_t rows, Cells cells)
    : heads_(config.heads),
      turns_per_pulse_(1.0 / static_cast<double>(config.axis(Axis::psi).pulses_per_turn)),
      blank_radius_mm_(config.blank.diameter_mm / 2.0),
      rows_(rows),
      cells_(std::move(cells)) {
    for (const Axis axis : {Axis::r1, Axis::r2, Axis::y})
        mm_per_pulse_[index_of(axis)] = 1.0 / config.axis(axis).pulses_per_mm;
}

void Workpiece::cut(Axis head, const std::array<std::int64_t, kAxisCount>& positions_pulses) noexcept {
    const std::size_t k = index_of(head);
    const auto at_mm = [&](Axis axis) {
        return static_cast<double>(positions_pulses[index_of(axis)]) * mm_per_pulse_[index_of(axis)];
    };
    const double radius_mm = at_mm(head) + heads_[k].tip_mm;
    const double height_mm = at_mm(Axis::y) + heads_[k].height_mm;
    if (radius_mm >= blank_radius_mm_ || height_mm < 0.0) return;
    const auto row = static_cast<std::size_t>(height_mm / kRow_mm);
    if (row >= rows_) return;
    const double turns = static_cast<double>(positions_pulses[index_of(Axis::psi)]) * turns_per_pulse_ +
                         heads_[k].direction_deg / kDegPerRev;
    const double part = turns - std::floor(turns);
    const std::size_t column = std::min(static_cast<std::size_t>(part * kColumns), kColumns - 1);
    std::uint32_t& cell = cells_[row * kColumns + column];
    const std::uint32_t left = cell_of(radius_mm, k);
    if (cell == 0 || left >> 1 < cell >> 1) cell = left;
    if (touches_[k].load(std::memory_order_relaxed) == kUntouched)
        touches_[k].store(positions_pulses[k], std::memory_order_relaxed);
}

std::vector<Cut> Workpiece::cuts() const {
    std::vector<Cut> all;
    for (std::size_t i = 0; i < rows_ * kColumns; ++i) {
        const std::uint32_t cell = cells_[i];
        if (cell == 0) continue;
        const std::size_t row = i / kColumns;
        all.push_back({.direction_deg = (static_cast<double>(i % kColumns) + 0.5) * kDegPerRev / kColumns,
                       .height_mm = (static_cast<double>(row) + 0.5) * kRow_mm,
                       .radius_mm = static_cast<double>(cell >> 1) / kRadiusSteps_per_mm,
                       .head = (cell & 1U) == 0 ? Axis::r1 : Axis::r2});
    }
    return all;
}

std::optional<std::int64_t> Workpiece::first_touch_pulses(Axis head) const noexcept {
    const std::int64_t at = touches_[index_of(head)].load(std::memory_order_relaxed);
    return at == kUntouched ? std::nullopt : std::optional<std::int64_t>{at};
}

std::string csv_of(const std::vector<Cut>& cuts) {
    std::string text = "direction_deg,height_mm,radius_mm,head\n";
    for (const Cut& cut : cuts) {
        char line[80];
        (void)std::snprintf(line, sizeof line, "%.4f,%.3f,%.5f,%s\n", cut.direction_deg, cut.height_mm,
                            cut.radius_mm, cut.head == Axis::r1 ? "r1" : "r2");
        text += line;
    }
    return text;
}

}  // namespace psicarve::sim
