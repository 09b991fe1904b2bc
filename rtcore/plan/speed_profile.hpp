// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "rtcore/plan/path.hpp"
#include "rtcore/plan/wide.hpp"

namespace psicarve::plan {

/// A piece of curve with constant q'' (pulses and seconds of u).
struct PathCell {
    double length;  ///< > 0
    Lanes slope_begin;
    Lanes slope_end;
    Lanes bend;
};

/// The greatest (du/dt)^2 at a quarter, at the half and at three quarters of a cell.
using InnerSpeeds2 = std::array<double, 3>;

/// What one timing of a path keeps to.
struct SpeedLimits {
    std::span<const double>
        bound2;  ///< cells + 1; the first and the last are the speeds to begin and end with
    std::span<const InnerSpeeds2> inner2;  ///< one entry a cell
};

/// The fastest timing of a chain of cells: x = (du/dt)^2 at every cell bound, linear in between, with
///
///     |q' * x' / 2 + q'' * x| <= a_k          in the middle of every cell: its mean acceleration
///                             <= 1.25 a_k     at its ends, less in long cells: a fiftieth of a pulse at most
///     x <= the limits at the cells' ends and in between
///
/// The left side is linear in u. In a curve whose q'' changes evenly the cells' steps of q'' would cost time
/// at every cell's end though the mean is what a motor follows; without any limit at the ends greedy passes
/// zigzag where an axis turns back. A backward pass finds the fastest speeds from which the end can be
/// reached, a forward pass goes as fast as they allow. O(cells). Source: Pham and Pham, A new approach to
/// time-optimal path parameterization based on reachability analysis, IEEE Trans. Robotics 34 (2018).
class SpeedProfile {
public:
    explicit SpeedProfile(const Lanes& accel);

    /// What all timings of a path share.
    void set_path(std::span<const PathCell> cells);
    void solve(const SpeedLimits& limits, std::vector<double>& speed2);
    /// Two timings side by side: each waits for its own cell before, so both take hardly longer than one.
    void solve_both(const std::array<SpeedLimits, 2>& limits, std::array<std::vector<double>, 2>& speed2);

private:
    /// |x + tilt * z| <= most, by axis, for the squared speeds x and z at a cell's begin and end.
    struct AxisRows {
        Vec most, tilt, inverse_tilt;
    };
    /// What the axes' accelerations ask of a cell in its middle and at both its ends.
    struct AccelRows {
        std::array<AxisRows, 3> at;
    };
    /// Three inner places of a cell, and the limit at its begin: x + kInnerTilt * z <= most.
    class CellRows;
    class Passes;

    Lanes inverse_accel_;
    WideVector<AccelRows> rows_;
    std::array<std::vector<double>, 2> reachable2_;
};

/// What an axis may accelerate at a cell's ends, as a share of what it may in the middle.
double greatest_end_share(double length, double inverse_accel);

/// Seconds that a cell takes between these speeds.
double cell_seconds(double length, double begin_speed2, double end_speed2);

}  // namespace psicarve::plan
