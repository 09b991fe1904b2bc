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
/// Where several layers have such a point, it is the one of the layer that is due; where none of these is,
/// behind a complete carving that of a layer behind it, else the very first. Remembers what it looked up for
/// a plunge's many pulses.
class CarvingBegins {
public:
    /// The geometry outlives it.
    explicit CarvingBegins(const JobGeometry& geometry);

    /// The very first of the points to be carved.
    CarvePoint first() const noexcept {
        return {geometry_.first_layer(), geometry_.first_step(geometry_.first_layer())};
    }
    bool is_first(const Positions& at) const noexcept { return is_begin_of(first().layer, at); }
    /// No axis is further from the first point than this [pulses].
    bool is_near_first(const Positions& at, std::int64_t most_pulses) const noexcept;

    /// A layer that is to be carved begins where another one does that is not.
    bool are_shared() const noexcept { return are_shared_; }

    /// The layer whose first point this is. `due`: the layer that is to be carved next.
    std::optional<std::uint32_t> layer_at(const Positions& at, std::uint32_t due);
    /// A layer's point, whichever but the last.
    std::optional<CarvePoint> point_at(const Positions& at, std::uint32_t due);

private:
    bool is_begin_of(std::uint32_t layer, const Positions& at) const noexcept;
    bool is_likelier(std::uint32_t layer, std::uint32_t than, std::uint32_t due) const noexcept;
    void look_for_points(const Positions& at);

    const JobGeometry& geometry_;
    bool are_shared_ = false;
    std::optional<std::int64_t> begins_y_;                         ///< height at which `beginning_` begin
    std::vector<std::uint32_t> beginning_;                         ///< layers
    std::optional<std::pair<std::int64_t, std::int64_t>> plunge_;  ///< psi and y of `plunge_points_`
    std::vector<CarvePoint> plunge_points_;                        ///< whatever their radii
};

}  // namespace psicarve::verify
