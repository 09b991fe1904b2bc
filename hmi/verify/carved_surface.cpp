// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/carved_surface.hpp"

#include <algorithm>
#include <cstdlib>

#include "shared/units.hpp"

namespace psicarve::verify {

CarvedSurface::CarvedSurface(const JobGeometry& geometry)
    : geometry_(geometry),
      radius_mm_(std::size_t{geometry.layer_count()} * geometry.direction_count(),
                 static_cast<float>(geometry.blank_radius_mm())),
      deviation_(radius_mm_.size(), kUntouched) {}

double CarvedSurface::layer_height_mm(std::uint32_t layer) const noexcept {
    return static_cast<double>(geometry_.height(layer)) / geometry_.y_pulses_per_mm();
}

void CarvedSurface::note_deviation(std::uint32_t layer, std::uint32_t cell, std::int64_t pulses) noexcept {
    std::int16_t& kept = deviation_[std::size_t{layer} * direction_count() + cell];
    const std::int64_t bounded = std::clamp<std::int64_t>(pulses, -kUntouched, kUntouched - 1);
    if (bounded < kept) kept = static_cast<std::int16_t>(bounded);
}

std::int32_t CarvedSurface::deviation_pulses(std::uint32_t layer, std::uint32_t direction) const noexcept {
    const std::int16_t kept = deviation_[std::size_t{layer} * direction_count() + direction];
    if (kept != kUntouched) return kept;
    const auto wanted_mm = geometry_.wanted_mm(layer, geometry_.direction_of(direction));
    if (!wanted_mm) return 0;
    return static_cast<std::int32_t>(round_to_pulse((blank_radius_mm() - *wanted_mm) * pulses_per_mm()));
}

std::int64_t CarvedSurface::max_deviation_pulses() const noexcept {
    std::int64_t largest = 0;
    for (std::uint32_t layer = 0; layer < layer_count(); ++layer) {
        for (std::uint32_t direction = 0; direction < direction_count(); ++direction)
            largest = std::max<std::int64_t>(largest, std::abs(deviation_pulses(layer, direction)));
    }
    return largest;
}

void CarvedSurface::clear() {
    if (!is_touched_) return;
    std::fill(radius_mm_.begin(), radius_mm_.end(), static_cast<float>(blank_radius_mm()));
    std::fill(deviation_.begin(), deviation_.end(), kUntouched);
    is_touched_ = false;
}

}  // namespace psicarve::verify
