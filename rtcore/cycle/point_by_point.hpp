// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve::cycle {

/// Point-by-point comparison: after each pulse the sign of a deviation F says which of two axes moves next,
/// so that the steps wind round the line or the arc and are never more than a pulse away from it. All in
/// whole pulses, relative to the line's begin or the arc's centre.
///
///     line to (xe, ye)   F = xe*y - ye*x                F >= 0: x, else y
///     arc                F = x^2 + y^2 - R^2            F >= 0: the axis that leads inwards, else the other
///
/// Lines in other quadrants are mirrored into the first; an arc knows in each quadrant which axis leads
/// inwards. Source: the classic stepwise method of numerical control, docs/interpolation.md. RT: yes.
class PointByPoint {
public:
    struct Step {
        int x;  ///< one of the two is +1 or -1, the other 0
        int y;
        friend bool operator==(const Step&, const Step&) = default;
    };
    struct Point {
        std::int64_t x;
        std::int64_t y;
        friend bool operator==(const Point&, const Point&) = default;
    };

    /// Requires coordinates below 2^31.
    static PointByPoint line(Point end) noexcept;
    /// From `begin` to `end`, a whole turn when they are the same; R is begin's distance. Requires a radius
    /// of 2 to 2^30, and an end as far from the centre as the begin, to a pulse.
    static PointByPoint arc(Point begin, Point end, bool counter_clockwise) noexcept;

    bool is_finished() const noexcept { return quadrants_left_ == 0 && at_ == end_; }
    /// Requires that it is not finished.
    Step next() noexcept;
    Point at() const noexcept;
    /// Of an arc as it begins: whether it passes the circle's end in this direction (one of the two +-1).
    bool passes(int x, int y) const noexcept;

private:
    /// Steps of the quadrant at hand, seen counter-clockwise.
    Step directions() const noexcept;
    bool leads_x() const noexcept;
    void enter_next_quadrant() noexcept;

    bool is_arc_ = false;
    int x_sign_ = 1;  ///< lines: how they were mirrored; arcs: -1 at y makes clockwise counter-clockwise
    int y_sign_ = 1;
    Point at_{};
    Point end_{};
    std::int64_t deviation_ = 0;  ///< F
    int quadrant_ = 0;            ///< of an arc: 0 is x > 0, y >= 0, then counter-clockwise
    int quadrants_left_ = 0;      ///< to pass before the one in which the arc ends
};

}  // namespace psicarve::cycle
