// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/job.hpp"
#include "shared/profile.hpp"

namespace psicarve::verify {

/// The blank as the tips have carved it so far: for each layer and each of the job's 2 * (point_count - 1)
/// directions the least real radius at which a tip stood within half a cell, at that layer's height or nearer
/// to it than to any other. A cell that no tip reached keeps the blank's radius (the table's largest).
///
/// Real means that tip offsets are added back, R2 stands at 180 degrees plus its angle error and above R1 by
/// its height error. Direction d is the workpiece direction point_angle_pulses(d).
class CarvedSurface {
public:
    /// Requires at least one layer and two points.
    CarvedSurface(const JobView& job, const Profile& profile);

    std::uint32_t layer_count() const noexcept { return layer_count_; }
    std::uint32_t direction_count() const noexcept { return direction_count_; }
    double layer_height_mm(std::uint32_t layer) const noexcept { return layer_height_mm_[layer]; }
    double blank_radius_mm() const noexcept { return blank_radius_mm_; }
    double pulses_per_mm() const noexcept { return pulses_per_mm_; }  ///< of head R1

    /// Carved radii of a layer, by direction [mm].
    std::span<const float> radii_mm(std::uint32_t layer) const noexcept {
        return {radius_mm_.data() + std::size_t{layer} * direction_count_, direction_count_};
    }
    /// Carved minus wanted radius of a layer, by direction [pulses]; negative: too deep.
    std::int32_t deviation_pulses(std::uint32_t layer, std::uint32_t direction) const noexcept;

private:
    std::uint32_t layer_count_ = 0;
    std::uint32_t direction_count_ = 0;
    double pulses_per_mm_ = 1.0;
    double blank_radius_mm_ = 0.0;
    std::vector<double> layer_height_mm_;
    std::vector<float> radius_mm_;
    std::vector<std::int16_t> deviation_;
};

}  // namespace psicarve::verify
