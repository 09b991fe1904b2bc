// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rtcore/plan/path.hpp"
#include "rtcore/plan/path_pieces.hpp"
#include "rtcore/plan/program_step.hpp"
#include "rtcore/plan/speed_profile.hpp"

namespace psicarve::plan {

/// Which points of a path a curve is decided between, by their index.
struct DecidedPoints {
    std::size_t from;
    std::size_t to;
    std::size_t last;  ///< known so far; `to` itself: the path rests there
};

/// A cell of a curve that was planned for good; for a yardstick that times the same curve in its own way.
struct SeenCell {
    PathCell cell;
    bool is_from_rest;
};

/// A decided part of a path's curve, from point to point: what its timing needs to know. Cells that stand on
/// the first or the last point are there by halves.
struct CurvePart {
    std::vector<PathPoint> points;
    std::vector<RecordPlace> lines;  ///< of the program, by point: of the way that reaches it
    Lanes begin_at;                  ///< where the curve begins [pulses]
    std::vector<PathCell> cells;
    std::vector<Lanes> cell_at;           ///< position at each cell's begin [pulses]
    std::vector<std::uint32_t> point_at;  ///< index of the point that a cell holds, or PathPiece::kNoPoint
    std::vector<double> point_along;      ///< and how far from the cell's begin
    std::array<std::vector<double>, kTimingCount> bound2;  ///< as SpeedLimits; rests are not in them
    std::array<std::vector<InnerSpeeds2>, kTimingCount> inner2;
    double rest_begin2;  ///< the speed squared of a rest at its begin, and at its end
    double rest_end2;
};

}  // namespace psicarve::plan
