// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hmi/surface/job_geometry.hpp"

namespace psicarve::verify {

/// The blank as the tips have carved it so far: for each layer of the finishing pass (its rows, from 0) and
/// each of the job's 2 * (point_count - 1) directions the least real radius at which a tip stood within half
/// a cell, at that layer's height or nearer to it than to any other. A cell that no tip reached keeps the
/// blank's radius (the table's largest).
///
/// Real means that tip offsets are added back, R2 stands at 180 degrees plus its angle error and above R1 by
/// its height error. Direction d is the workpiece direction point_angle_pulses(d).
class CarvedSurface {
public:
    explicit CarvedSurface(const JobGeometry& geometry);

    std::uint32_t layer_count() const noexcept { return geometry_.row_count(); }
    std::uint32_t direction_count() const noexcept { return geometry_.direction_count(); }
    double layer_height_mm(std::uint32_t layer) const noexcept;
    /// Whether rows rise as they turn: never lower than the one before in the same direction, but not level.
    bool is_spiral() const noexcept { return geometry_.is_spiral(); }
    double height_mm(std::uint32_t layer, std::uint32_t direction) const noexcept;
    double blank_radius_mm() const noexcept { return geometry_.blank_radius_mm(); }
    double pulses_per_mm() const noexcept { return geometry_.head(0).pulses_per_mm; }  ///< of head R1

    /// Carved radii of a layer, by direction [mm].
    std::span<const float> radii_mm(std::uint32_t layer) const noexcept {
        return {radius_mm_.data() + std::size_t{layer} * direction_count(), direction_count()};
    }
    /// Carved minus wanted radius of a cell [pulses]; negative: too deep. The way between two points is
    /// judged by rule 1 and changes nothing here as long as that rule holds.
    std::int32_t deviation_pulses(std::uint32_t layer, std::uint32_t direction) const noexcept;
    /// The largest of these, without its sign, among the cells that hold a point of the job or were cut too
    /// deep.
    std::int64_t max_deviation_pulses() const noexcept;
    /// The same among those of them that were carved, or cut too deep.
    std::int64_t max_carved_deviation_pulses() const noexcept;
    /// Whether a point here was carved or missed, or the cell was cut too deep; between the points of a
    /// layer that is to be carved, whether a tip was here at all.
    bool is_carved(std::uint32_t layer, std::uint32_t direction) const noexcept;
    /// Whether a point that is to be carved lies here, or the cell was cut too deep.
    bool holds_point(std::uint32_t layer, std::uint32_t direction) const noexcept {
        return deviation_[std::size_t{layer} * direction_count() + direction] != kWithoutPoint;
    }
    /// Cells that no tip reached. R2's errors of angle and height leave such cells in a complete carving.
    std::uint64_t uncarved_cells() const noexcept;

    // For the verifier as it follows the pins.

    /// A tip reaches this radius in a cell.
    void touch(std::uint32_t layer, std::uint32_t cell, float radius_mm) noexcept {
        const std::size_t index = std::size_t{layer} * direction_count() + cell;
        float& radius = radius_mm_[index];
        if (radius_mm < radius) radius = radius_mm;
        reached_[index] |= kReached;
        is_touched_ = true;
    }
    /// For code that shows an earlier state again: sets the cell as it was then.
    void put(std::uint32_t layer, std::uint32_t cell, float radius_mm) noexcept {
        radius_mm_[std::size_t{layer} * direction_count() + cell] = radius_mm;
        is_touched_ = true;
    }
    /// Notes how far from the wanted radius a tip came at a point; the deepest stays.
    void note_deviation(std::uint32_t layer, std::uint32_t cell, std::int64_t pulses) noexcept;
    /// The same of a tip that only came by: unless it cut too deep the point is not carved.
    void note_passed(std::uint32_t layer, std::uint32_t cell, std::int64_t pulses) noexcept;
    /// Makes it a fresh blank.
    void clear();

private:
    static constexpr std::int16_t kUntouched = 32767;
    static constexpr std::int16_t kWithoutPoint = 32766;  ///< no point of the job lies in this cell
    static constexpr std::int16_t kLargest = 32765;
    static constexpr std::uint8_t kReached = 1;  ///< bits of `reached_`
    static constexpr std::uint8_t kCarved = 2;

    void expect_points();
    std::int64_t largest_deviation_pulses(bool of_carved_alone) const noexcept;

    JobGeometry geometry_;
    bool is_touched_ = false;
    std::vector<float> radius_mm_;
    std::vector<std::int16_t> deviation_;
    std::vector<std::uint8_t> reached_;
    std::vector<std::uint8_t> has_points_;  ///< by layer: 1 where any are to be carved
};

}  // namespace psicarve::verify
