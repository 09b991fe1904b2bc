// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "hmi/surface/job_geometry.hpp"
#include "hmi/verify/path/carve_progress.hpp"

namespace psicarve::verify {

/// Finds the job's points where rule 1 follows none: in layers that are not judged, and in dry runs. With
/// planner "angle" speeds may jump there.
///
/// With the spindle on all axes meet at a point. In a dry run the heads stand still outside, while table and
/// Y go as they would. It begins at rest on a point, and lasts until a head moves, the spindle is on or
/// psi turns against the job's way. Where
/// a head would have been the long axis of a line, table and Y have their last pulse of it before it ends:
/// the joint is somewhere between that and their next one, and jumps at both cover it.
class JointFinder {
public:
    /// The geometry outlives it. `is_of_dry_run`: a dry run was asked for; else none is looked for.
    JointFinder(const JobGeometry& geometry, bool is_of_dry_run);

    /// Positions are these without a motion: at the trace's begin, or where they are defined anew.
    void stand_at(const Positions& positions) noexcept;
    /// Whether speeds may jump in this instant.
    bool settle(std::int64_t time_ns, const Positions& positions, bool spindle_on);

private:
    bool is_met(const Positions& at);
    bool passes_dry(const Positions& at);
    void end_dry() noexcept { is_dry_ = ends_late_ = false; }
    const std::vector<CarvePoint>& points_at(const Positions& at);
    void look_for_layers(std::int64_t y_pulses);
    bool turns_back(const Positions& from, const Positions& to);
    bool ends_late(CarvePoint point) const noexcept;

    const JobGeometry& geometry_;
    bool is_of_dry_run_;
    std::vector<std::uint32_t> by_height_;  ///< layers, by the height of their first points
    std::int64_t most_rise_ = 0;            ///< of a layer, from end to end [pulses]
    std::optional<std::int64_t> height_;    ///< of `layers_`
    std::vector<std::uint32_t> layers_;     ///< that may have points there
    std::optional<std::pair<std::int64_t, std::int64_t>> place_;  ///< psi and y of `points_`
    std::vector<CarvePoint> points_;                              ///< whatever their radii
    Positions last_{};
    std::int64_t moved_ns_ = 0;  ///< when any axis last did
    bool is_dry_ = false;
    bool ends_late_ = false;  ///< in a dry run, at a point whose line goes on without table and Y
};

}  // namespace psicarve::verify
