// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/verify/motor/reach_boundary.hpp"

namespace psicarve::verify {

/// A convex set of states (position [pulses], speed [pulses/s]) that a motor may be in. All speeds are of one
/// sign or none, so positions never turn back inside `run`.
class StateSet {
public:
    StateSet() = default;  ///< the empty set
    /// Every position with every speed of two ranges.
    static StateSet box(Range positions, Range speeds);
    /// All states that a motor reaches within `room` when it may start anywhere in it at `slowest`.
    static StateSet rest(Range room, double slowest, double fastest, double accel);

    bool is_empty() const noexcept { return right_.size() == 0; }
    double slowest() const noexcept { return right_.slowest(); }
    double fastest() const noexcept { return right_.fastest(); }
    std::size_t corners() const noexcept { return right_.size() + left_.size(); }
    const ReachBoundary& boundary(ReachBoundary::Side side) const noexcept {
        return side == ReachBoundary::Side::right ? right_ : left_;
    }
    /// Positions at its slowest speed.
    Range slowest_row() const noexcept { return {-left_.reach(0), right_.reach(0)}; }
    /// All positions that it holds.
    Range positions() const noexcept { return {-left_.furthest(), right_.furthest()}; }

    /// The states after a time, under any acceleration up to +-`accel`, and never faster than `ceiling` on
    /// the way. The error of one step is accel * time^2 / 16 pulses, four times that near the ceiling: states
    /// are left out, never added.
    void run(double time_s, double accel, double ceiling) noexcept;
    /// Every speed may change by up to +-`jump` at once.
    void jump(double jump) noexcept;

    void keep_below(double position) noexcept { keep(right_, left_, position); }
    void keep_above(double position) noexcept { keep(left_, right_, -position); }
    void keep_speeds(Range speeds) noexcept;

    /// Adds positions at its slowest speed, and the convex hull; see ReachBoundary::extend_slowest.
    bool extend_slowest(Range row, double exact_from, double tolerance) noexcept;
    /// The convex hull of both, when that adds no position further than `tolerance` from them.
    bool try_join(const StateSet& other, double tolerance) noexcept;
    void join(const StateSet& other) noexcept;

private:
    void keep(ReachBoundary& capped, ReachBoundary& opposite, double level) noexcept;
    void thin() noexcept;

    ReachBoundary right_;
    ReachBoundary left_;
};

}  // namespace psicarve::verify
