// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

using Positions = std::array<std::int64_t, kAxisCount>;

inline constexpr std::size_t kHeadCount = 2;
inline constexpr std::array<Axis, kHeadCount> kHeads{Axis::r1, Axis::r2};

/// The layers that a trace should have carved: counted as by `psicarve start --from-layer`, `--layers` and
/// `--from-point`.
struct LayerRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;                     ///< 0: all that follow
    std::optional<std::uint32_t> first_point{};  ///< of the first layer's table; nothing: from its begin
};

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

/// Where the job's points lie on the workpiece: all that verifying needs besides the pins. The wanted surface
/// is the finishing pass': its rows count from 0 with that pass' first layer. Directions are workpiece
/// directions in psi pulses, 0 <= direction < one revolution.
class JobGeometry {
public:
    static Result<JobGeometry> make(const JobView& job, const Profile& profile,
                                    const LayerRange& layers = {});

    const JobView& job() const noexcept { return job_; }
    const HeadGeometry& head(std::size_t h) const noexcept { return heads_[h]; }
    std::uint32_t layer_count() const noexcept { return job_.layer_count(); }
    std::uint32_t point_count() const noexcept { return job_.point_count(); }
    /// Layer of the job that is the surface's first row.
    std::uint32_t first_row_layer() const noexcept { return job_.finishing_layer(); }
    std::uint32_t row_count() const noexcept { return layer_count() - first_row_layer(); }
    /// In the layers that are to be carved.
    std::uint64_t total_points() const noexcept {
        return std::uint64_t{end_layer_ - first_layer_} * point_count() - first_step_;
    }
    std::uint32_t first_layer() const noexcept { return first_layer_; }
    std::uint32_t end_layer() const noexcept { return end_layer_; }
    /// Of a layer's points, in the order of carving, the one with which it is to begin.
    std::uint32_t first_step(std::uint32_t layer) const noexcept {
        return layer == first_layer_ ? first_step_ : 0;
    }
    std::uint32_t direction_count() const noexcept { return 2 * (point_count() - 1); }
    std::int64_t rev_pulses() const noexcept { return rev_pulses_; }
    double rad_per_pulse() const noexcept { return rad_per_pulse_; }
    double tolerance_mm() const noexcept { return tolerance_mm_; }
    double y_pulses_per_mm() const noexcept { return y_pulses_per_mm_; }
    double blank_radius_mm() const noexcept { return blank_radius_mm_; }
    /// Whether rows rise as they turn: each holds every direction once, at a height of its own.
    bool is_spiral() const noexcept { return job_.joining() == Joining::spiral && row_count() > 1; }
    std::int64_t height(std::uint32_t row) const noexcept { return row_heights()[row]; }
    /// Height of a row at this direction of the piece.
    std::int64_t height(std::uint32_t row, std::int64_t direction_pulses) const noexcept;

    /// Axis positions of the point that is carved as the layer's `step`-th; psi is the job's absolute angle.
    Positions target(std::uint32_t layer, std::uint32_t step) const noexcept;
    /// The layer's point at this psi, up to whole turns, and y, whatever its radii: in the order of carving.
    std::optional<std::uint32_t> step_at(std::uint32_t layer, const Positions& at) const noexcept;

    /// The row that lies nearest to a height in this direction; nothing when it is further from the
    /// outermost rows than half the distance to their neighbours.
    std::optional<std::uint32_t> row_at(std::int64_t height_pulses,
                                        std::int64_t direction_pulses) const noexcept;
    /// The row that a head's tip carves at a point of the finishing pass; nothing before that.
    std::optional<std::uint32_t> row_of_point(std::size_t h, std::uint32_t layer,
                                              std::uint32_t point) const noexcept;

    /// Direction that a head faces at a table angle.
    std::int64_t direction(std::size_t h, std::int64_t psi_pulses) const noexcept;
    /// The nearest of the job's directions.
    std::uint32_t cell_of(std::int64_t direction_pulses) const noexcept;
    /// Direction of a cell's middle.
    std::int64_t direction_of(std::uint32_t cell) const noexcept;

    /// Wanted real radius, on the straight lines between the row's points [mm]. Nothing where the job has no
    /// radius (a large height error can leave such places).
    std::optional<double> wanted_mm(std::uint32_t row, std::int64_t direction_pulses) const noexcept;

    /// Real radius that a head must not undercut at a Y position: its own side of the nearest row, which was
    /// sampled where its tip stands; where there is none, the other head's row at the tip's height; then the
    /// nearer end of its own row across the gap that an angle error leaves [mm].
    std::optional<double> floor_mm(std::size_t h, std::int64_t y_pulses,
                                   std::int64_t direction_pulses) const noexcept;

    /// A place where a tip may be: at this height of the piece no deeper than this radius.
    struct KnownTip {
        std::int64_t height_pulses;
        double radius_mm;
    };
    /// The deeper of the radii next below and next above a tip in a direction, in either head's rows and in
    /// `more` [mm]. For level layers beside a spiral's rows, which in one direction each head has at heights
    /// of its own.
    std::optional<double> least_around(std::int64_t tip_height_pulses, std::int64_t direction_pulses,
                                       std::span<const KnownTip> more) const noexcept;

private:
    enum class Gap { empty, bridged };
    /// On a head's side of this row; where a spiral's rings meet the rows that rise, the deeper of the two.
    std::optional<double> least_near(std::size_t h, std::uint32_t row, std::int64_t y_pulses,
                                     std::int64_t direction_pulses) const noexcept;
    /// Height on the piece at which this head carves the row's point in this direction; it must have one
    /// there.
    std::int64_t tip_height(std::size_t h, std::uint32_t row, std::int64_t direction_pulses) const noexcept;
    std::optional<double> on_row(std::size_t h, std::uint32_t row, std::int64_t direction_pulses,
                                 Gap gap = Gap::bridged) const noexcept;

    std::span<const std::int64_t> row_heights() const noexcept {
        return job_.layer_heights_pulses().subspan(first_row_layer());
    }

    JobView job_;
    std::array<HeadGeometry, kHeadCount> heads_;
    std::int64_t rev_pulses_ = 1;
    double rad_per_pulse_ = 0.0;
    double y_pulses_per_mm_ = 1.0;
    double tolerance_mm_ = 0.0;
    std::uint32_t first_layer_ = 0;
    std::uint32_t first_step_ = 0;
    std::uint32_t end_layer_ = 0;
    double blank_radius_mm_ = 0.0;
    std::int64_t outer_margin_low_ = 0;  ///< a tip this far below the lowest row still counts as in that row
    std::int64_t outer_margin_high_ = 0;
};

}  // namespace psicarve::verify
