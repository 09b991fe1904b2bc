// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "hmi/surface/job_geometry.hpp"
#include "hmi/verify/path/carve_progress.hpp"

namespace psicarve::verify {

/// Finds the point of a job with which carving may begin where the axes stand; psi up to whole turns.
/// Where several layers have such a point, it is the one of the layer that is due. Remembers what it looked
/// up for a plunge's many pulses.
class CarvingBegins {
public:
    /// The geometry outlives it.
    explicit CarvingBegins(const JobGeometry& geometry) noexcept : geometry_(geometry) {}

    /// The very first of the points to be carved.
    CarvePoint first() const noexcept {
        return {geometry_.first_layer(), geometry_.first_step(geometry_.first_layer())};
    }
    bool is_first(const Positions& at) const noexcept { return is_begin_of(first().layer, at); }
    /// No axis is further from the first point than this [pulses].
    bool is_near_first(const Positions& at, std::int64_t most_pulses) const noexcept;

    /// The layer whose first point this is.
    std::optional<std::uint32_t> layer_at(const Positions& at, const CarveProgress& progress);
    /// A layer's point, whichever but the last.
    std::optional<CarvePoint> point_at(const Positions& at, const CarveProgress& progress);

private:
    bool is_begin_of(std::uint32_t layer, const Positions& at) const noexcept;
    std::optional<std::uint32_t> step_at(std::uint32_t layer, const Positions& at) const noexcept;
    void look_for_points(const Positions& at);

    const JobGeometry& geometry_;
    std::optional<std::int64_t> begins_y_;                         ///< height at which `beginning_` begin
    std::vector<std::uint32_t> beginning_;                         ///< layers
    std::optional<std::pair<std::int64_t, std::int64_t>> plunge_;  ///< psi and y of `plunge_points_`
    std::vector<CarvePoint> plunge_points_;                        ///< whatever their radii
};

}  // namespace psicarve::verify
