// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/surface/carved_surface.hpp"

#include <algorithm>
#include <cstdlib>

#include "shared/base/units.hpp"

namespace psicarve::verify {

CarvedSurface::CarvedSurface(const JobGeometry& geometry)
    : geometry_(geometry),
      radius_mm_(std::size_t{geometry.row_count()} * geometry.direction_count(),
                 static_cast<float>(geometry.blank_radius_mm())),
      deviation_(radius_mm_.size(), kWithoutPoint),
      reached_(radius_mm_.size(), 0),
      has_points_(geometry.row_count(), 0) {
    expect_points();
}

void CarvedSurface::expect_points() {
    const std::uint32_t first = std::max(geometry_.first_row_layer(), geometry_.first_layer());
    for (std::uint32_t layer = first; layer < geometry_.end_layer(); ++layer) {
        for (std::size_t h = 0; h < kHeadCount; ++h) {
            auto row = geometry_.row_of_point(h, layer, 0);
            for (std::uint32_t point = 0; point < geometry_.point_count(); ++point) {
                if (geometry_.is_spiral()) row = geometry_.row_of_point(h, layer, point);
                const std::uint32_t step =
                    carved_point(geometry_.job().joining(), geometry_.point_count(), layer, point);
                if (!row || step < geometry_.first_step(layer)) continue;
                const std::int64_t psi = geometry_.job().psi_pulses(layer, point);
                const std::uint32_t cell = geometry_.cell_of(geometry_.direction(h, psi));
                deviation_[std::size_t{*row} * direction_count() + cell] = kUntouched;
                has_points_[*row] = 1;
            }
        }
    }
}

double CarvedSurface::layer_height_mm(std::uint32_t layer) const noexcept {
    return static_cast<double>(geometry_.height(layer)) / geometry_.y_pulses_per_mm();
}

double CarvedSurface::height_mm(std::uint32_t layer, std::uint32_t direction) const noexcept {
    return static_cast<double>(geometry_.height(layer, geometry_.direction_of(direction))) /
           geometry_.y_pulses_per_mm();
}

void CarvedSurface::note_deviation(std::uint32_t layer, std::uint32_t cell, std::int64_t pulses) noexcept {
    note_passed(layer, cell, pulses);
    reached_[std::size_t{layer} * direction_count() + cell] |= kCarved;
}

void CarvedSurface::note_passed(std::uint32_t layer, std::uint32_t cell, std::int64_t pulses) noexcept {
    const std::size_t index = std::size_t{layer} * direction_count() + cell;
    std::int16_t& kept = deviation_[index];
    if (pulses < 0) reached_[index] |= kCarved;
    if (kept == kWithoutPoint && pulses >= 0) return;  // no point of the job is here
    const std::int64_t bounded = std::clamp<std::int64_t>(pulses, -kLargest, kLargest);
    if (bounded < kept) kept = static_cast<std::int16_t>(bounded);
}

std::int32_t CarvedSurface::deviation_pulses(std::uint32_t layer, std::uint32_t direction) const noexcept {
    const std::size_t index = std::size_t{layer} * direction_count() + direction;
    const std::int16_t kept = deviation_[index];
    if (kept != kUntouched && kept != kWithoutPoint) return kept;
    if (kept == kWithoutPoint && (reached_[index] & kReached) != 0) return 0;  // swept between two points
    const auto wanted_mm = geometry_.wanted_mm(layer, geometry_.direction_of(direction));
    if (!wanted_mm) return 0;
    return static_cast<std::int32_t>(round_to_pulse((blank_radius_mm() - *wanted_mm) * pulses_per_mm()));
}

bool CarvedSurface::is_carved(std::uint32_t layer, std::uint32_t direction) const noexcept {
    const std::size_t index = std::size_t{layer} * direction_count() + direction;
    if (holds_point(layer, direction)) return (reached_[index] & kCarved) != 0;
    return has_points_[layer] != 0 && (reached_[index] & kReached) != 0;
}

std::int64_t CarvedSurface::max_deviation_pulses() const noexcept {
    return largest_deviation_pulses(false);
}

std::int64_t CarvedSurface::max_carved_deviation_pulses() const noexcept {
    return largest_deviation_pulses(true);
}

std::int64_t CarvedSurface::largest_deviation_pulses(bool of_carved_alone) const noexcept {
    std::int64_t largest = 0;
    for (std::uint32_t layer = 0; layer < layer_count(); ++layer) {
        for (std::uint32_t direction = 0; direction < direction_count(); ++direction) {
            if (deviation_[std::size_t{layer} * direction_count() + direction] == kWithoutPoint) continue;
            if (of_carved_alone && !is_carved(layer, direction)) continue;
            largest = std::max<std::int64_t>(largest, std::abs(deviation_pulses(layer, direction)));
        }
    }
    return largest;
}

std::uint64_t CarvedSurface::uncarved_cells() const noexcept {
    const auto is_unreached = [](std::uint8_t cell) { return (cell & kReached) == 0; };
    return static_cast<std::uint64_t>(std::count_if(reached_.begin(), reached_.end(), is_unreached));
}

void CarvedSurface::clear() {
    if (!is_touched_) return;
    std::fill(radius_mm_.begin(), radius_mm_.end(), static_cast<float>(blank_radius_mm()));
    std::fill(deviation_.begin(), deviation_.end(), kWithoutPoint);
    std::fill(reached_.begin(), reached_.end(), std::uint8_t{0});
    expect_points();
    is_touched_ = false;
}

}  // namespace psicarve::verify
