// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rtcore/plan/bending_weights.hpp"
#include "rtcore/plan/curve_check.hpp"
#include "rtcore/plan/curve_fit.hpp"
#include "rtcore/plan/curve_nodes.hpp"
#include "rtcore/plan/curve_part.hpp"
#include "rtcore/plan/path.hpp"
#include "rtcore/plan/path_pieces.hpp"
#include "rtcore/plan/speed_profile.hpp"

namespace psicarve::plan {

/// The parabolas of a B-spline, one a node, and where each begins [pulses].
void cells_of(const CurveNodes& nodes, std::span<const Lanes> control, std::vector<PathCell>& cells,
              std::vector<Lanes>& cell_at);

/// What timings and curves leave each axis of its acceleration [pulses/s^2].
Lanes curve_accel(const MachineLimits& limits);

/// Makes a path of points into timed pieces: curve, timing, curve and timing again where that is faster,
/// cuts. Keeps its memory from stretch to stretch. Its members: the limits in the units it plans in, its two
/// planners, and memory for a stretch's cells.
class StretchPlanner {
public:
    explicit StretchPlanner(const MachineLimits& limits);

    /// From now on adds all cells of curves to `seen`, in order; it must outlive this.
    void show(std::vector<SeenCell>* seen) noexcept { seen_ = seen; }

    /// Points [first, last] of the path, from stop to stop. Appends to `pieces`; the result is the time that
    /// they take at 100 % [s]. Where no curve is found that keeps the tolerance, pulse by pulse, it comes to
    /// rest in between, in points of the path: pieces say so.
    double plan(std::span<const PathPoint> points, std::span<const PathSpan> spans,
                std::span<const PathCorner> corners, std::size_t first, std::size_t last,
                std::vector<PathPiece>& pieces);

    /// Points [from, last] of a path that begins at rest in `from`, or there goes on where the part decided
    /// before has ended: then at least two points come before it, as they were. The curve as far as `to` is
    /// decided for good; how the path goes on behind `last` does not matter, if that is a few dozen points
    /// later, or `to` itself, where it rests. Fills an empty part. False, and nothing decided, if no such
    /// curve was found that keeps the tolerance wherever it may be cut.
    bool decide(std::span<const PathPoint> points, std::span<const PathSpan> spans,
                std::span<const PathCorner> corners, const DecidedPoints& at, CurvePart& part);

private:
    /// A fitted curve and its timings.
    struct Curve {
        CurveNodes nodes;
        std::vector<Lanes> control;
        std::vector<PathCell> cells;
        std::vector<Lanes> cell_at;  ///< position at each cell's begin [pulses]
        std::array<std::vector<double>, kTimingCount> speed2;
        FittedTimes times;
    };

    struct Path {
        std::span<const PathPoint> points;
        std::span<const PathSpan> spans;
        std::span<const PathCorner> corners;
    };

    double plan_within(const Path& path, std::size_t first, std::size_t last, int divisions,
                       std::vector<PathPiece>& pieces);
    double plan_with_rests(const Path& path, std::size_t first, std::size_t last,
                           std::span<const std::uint32_t> straight, int divisions,
                           std::vector<PathPiece>& pieces);
    double plan_straight(const Path& path, std::size_t span, std::vector<PathPiece>& pieces);
    double plan_curve(const Path& path, std::size_t first, std::size_t last, std::vector<PathPiece>& pieces);
    void begin_curve(const Path& path, std::size_t first, std::size_t last);
    bool go_on_from(std::uint32_t point);
    std::array<double, 4> lengths_around(std::size_t node) const;
    void take_part(std::span<const PathPoint> points, std::span<const PathSpan> spans,
                   const DecidedPoints& at, CurvePart& part);
    double rest_speed2(std::span<const PathSpan> spans, std::size_t point, const Lanes& slope) const;
    bool fit(std::span<const PathPoint> points);
    void time(std::span<const PathSpan> spans);
    void bend_evenly(std::span<const PathPoint> points, std::span<const PathSpan> spans);
    std::size_t node_of(std::size_t span) const;
    void narrow(std::span<const PathPoint> points, const NodeRange& range);
    bool is_within(std::span<const PathPoint> points);
    bool bend_least_where_stuck();
    void gather_narrowed_ranges();
    bool fit_whole();
    bool fit_in_windows();
    bool fit_again(const NodeRange& range);
    bool fit_part(const NodeRange& range, std::size_t decided_last);
    void note_outside();
    Timings least_pace2_of(std::size_t cell) const;
    void limit_speeds();
    void add_pieces(std::span<const PathPoint> points, std::vector<PathPiece>& pieces);
    void show_cells(std::span<const PathCell> cells, bool is_from_rest) const;

    MachineLimits limits_;
    Lanes mm_per_pulse_{};
    double rad_per_pulse_ = 0.0;
    Lanes inverse_speed_{};
    Timings inverse_feed2_{};
    Lanes accel_;
    CurveFit fit_;
    SpeedProfile timing_;
    std::vector<PathSpan> spans_;  ///< with the bands that the curve needs
    std::vector<std::uint32_t> narrowed_;
    std::vector<std::uint32_t> stuck_;  ///< spans outside whose bands are as narrow as they may be
    std::vector<NodeRange> ranges_;     ///< around those
    /// Of a path that goes on: control points before its first node, at it and after it. Then one node stands
    /// before the first, and of its cell only the second half counts.
    std::vector<Lanes> decided_;
    /// Lengths around the middle one of those: what makes the curve there out of them.
    std::array<double, 4> decided_lengths_{};
    std::size_t first_node_ = 0;
    bool is_found_ = true;
    Curve curve_;
    Curve least_bent_;
    std::vector<std::array<bool, 2>> is_fed_;  ///< by cell and head: a part of it may cut
    std::array<std::vector<double>, kTimingCount> bound2_;
    std::array<std::vector<InnerSpeeds2>, kTimingCount> inner2_;
    std::vector<SeenCell>* seen_ = nullptr;
};

}  // namespace psicarve::plan
