// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "rtcore/plan/chord_plane.hpp"
#include "rtcore/plan/path.hpp"
#include "rtcore/plan/program_tube.hpp"

namespace psicarve::plan {

/// Both heads' spaces (R, r * psi, Y) around a span of a program and its neighbours.
class PolylineSpace {
public:
    PolylineSpace(const MachineLimits& limits, std::span<const PathPoint> points, std::size_t span_at,
                  const PathSpan& span, JudgedPlaces places);

    /// How far from the polyline, as a share of what is allowed.
    double share_of_allowed(const Lanes& at, std::size_t head) const;

private:
    using SpaceVector = std::array<double, kSpaceAxisCount>;

    double rounding_mm(const PathSpan& span, std::size_t head, JudgedPlaces places) const;
    bool moves_beside(std::size_t axis) const;
    double off2_mm2(const Lanes& at, std::size_t head, std::size_t chord) const;

    std::span<const PathPoint> points_;
    std::size_t span_at_;
    std::array<SpaceVector, kHeads> pulses_mm_{};
    std::array<double, kHeads> allowed_mm_{};
};

}  // namespace psicarve::plan
