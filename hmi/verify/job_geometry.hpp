// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "shared/job.hpp"
#include "shared/profile.hpp"
#include "shared/result.hpp"
#include "shared/signal.hpp"

namespace psicarve::verify {

using Positions = std::array<std::int64_t, kAxisCount>;

inline constexpr std::size_t kHeadCount = 2;
inline constexpr std::array<Axis, kHeadCount> kHeads{Axis::r1, Axis::r2};

/// One tool head as it stands in the machine.
struct HeadGeometry {
    double pulses_per_mm = 1.0;
    double tip_offset_mm = 0.0;             ///< real radius = counted radius + this
    std::int64_t facing_pulses = 0;         ///< workpiece direction it faces at table angle 0
    std::int64_t height_offset_pulses = 0;  ///< its tip stands this much above the Y position

    double real_mm(std::int64_t radius_pulses) const noexcept {
        return static_cast<double>(radius_pulses) / pulses_per_mm + tip_offset_mm;
    }
};

/// Where the job's points lie on the workpiece: everything that verifying needs besides the pins.
/// Directions are workpiece directions in psi pulses, 0 <= direction < one revolution.
class JobGeometry {
public:
    static Result<JobGeometry> make(const JobView& job, const Profile& profile);

    const JobView& job() const noexcept { return job_; }
    const HeadGeometry& head(std::size_t h) const noexcept { return heads_[h]; }
    std::uint32_t layer_count() const noexcept { return job_.layer_count(); }
    std::uint32_t point_count() const noexcept { return job_.point_count(); }
    std::uint64_t total_points() const noexcept { return std::uint64_t{layer_count()} * point_count(); }
    std::uint32_t direction_count() const noexcept { return 2 * (point_count() - 1); }
    std::int64_t rev_pulses() const noexcept { return rev_pulses_; }
    double rad_per_pulse() const noexcept { return rad_per_pulse_; }
    double tolerance_mm() const noexcept { return tolerance_mm_; }
    double y_pulses_per_mm() const noexcept { return y_pulses_per_mm_; }
    double blank_radius_mm() const noexcept { return blank_radius_mm_; }
    /// Rows that rise as they turn: each holds every direction once, at a height of its own.
    bool is_spiral() const noexcept { return job_.joining() == Joining::spiral && layer_count() > 1; }
    std::int64_t height(std::uint32_t layer) const noexcept { return job_.layer_heights_pulses()[layer]; }
    /// Of a layer where the piece's direction is this.
    std::int64_t height(std::uint32_t layer, std::int64_t direction_pulses) const noexcept;

    /// Axis positions of the point that is carved as the layer's `step`-th; psi is the job's absolute angle.
    Positions target(std::uint32_t layer, std::uint32_t step) const noexcept;

    /// The layer that lies nearest to a height in this direction; nothing when it is further from the
    /// outermost layers than half the distance to their neighbours.
    std::optional<std::uint32_t> layer_at(std::int64_t height_pulses,
                                          std::int64_t direction_pulses) const noexcept;
    /// The layer of the surface that a head's tip works on at a point.
    std::optional<std::uint32_t> layer_of_point(std::size_t h, std::uint32_t layer,
                                                std::uint32_t point) const noexcept;

    /// Direction that a head faces at a table angle.
    std::int64_t direction(std::size_t h, std::int64_t psi_pulses) const noexcept;
    /// The nearest of the job's directions.
    std::uint32_t cell_of(std::int64_t direction_pulses) const noexcept;
    /// Direction of a cell's middle.
    std::int64_t direction_of(std::uint32_t cell) const noexcept;

    /// Wanted real radius, on the straight lines between the layer's points [mm]. Nothing where the job says
    /// nothing (a large height error can leave such places).
    std::optional<double> wanted_mm(std::uint32_t layer, std::int64_t direction_pulses) const noexcept;

    /// Real radius that a head must not undercut at a Y position: its own row of the nearest layer, which was
    /// sampled where its tip stands; where that says nothing, the other head's row at the tip's height; then
    /// the nearer end of its own row across the gap that an angle error leaves [mm].
    std::optional<double> floor_mm(std::size_t h, std::int64_t y_pulses,
                                   std::int64_t direction_pulses) const noexcept;

private:
    enum class Gap { empty, bridged };
    /// On a head's row of this layer; where a spiral's rings meet the rows that rise, on the deeper of the
    /// two.
    std::optional<double> least_near(std::size_t h, std::uint32_t layer, std::int64_t y_pulses,
                                     std::int64_t direction_pulses) const noexcept;
    std::optional<double> on_row(std::size_t h, std::uint32_t row, std::int64_t direction_pulses,
                                 Gap gap = Gap::bridged) const noexcept;

    JobView job_;
    std::array<HeadGeometry, kHeadCount> heads_;
    std::int64_t rev_pulses_ = 1;
    double rad_per_pulse_ = 0.0;
    double y_pulses_per_mm_ = 1.0;
    double tolerance_mm_ = 0.0;
    double blank_radius_mm_ = 0.0;
    std::int64_t outer_margin_low_ = 0;  ///< how far below the lowest layer still counts as that layer
    std::int64_t outer_margin_high_ = 0;
};

}  // namespace psicarve::verify
