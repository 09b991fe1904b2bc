// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rtcore/cycle/motion_block.hpp"

namespace psicarve::cycle {

/// What is known to be allowed in a path's segment: both profiles, and the accelerations that keep every axis
/// within its limits. All per tick, of u. RT: yes.
class SegmentLimits {
public:
    /// The value of both profiles at one place [per tick^2], and their slopes within the segment.
    struct Profiles {
        double low, high;
        double low_slope, high_slope;
    };

    explicit SegmentLimits(double period_s) noexcept : period_s_(period_s) {}
    void enter(const PathTiming& timing) noexcept { timing_ = timing; }

    const PathTiming& timing() const noexcept { return timing_; }
    double period_s() const noexcept { return period_s_; }
    /// du/dt with which motion may begin and end in a jump.
    double start_stop_speed() const noexcept { return double{timing_.start_stop_speed} * period_s_; }
    Profiles profiles_at(double way) const noexcept;

    /// The largest d2u/dt2 that is known to be allowed at this place and speed, and the least. The largest is
    /// negative where none is known but to slow down.
    double rising_accel(const Profiles& profiles, double speed) const noexcept;
    double falling_accel(const Profiles& profiles, double speed) const noexcept;
    /// That of a profile with this (du/dt)^2 [u^2/s^2] at begin and end, scaled down to this speed.
    double accel_along(const std::array<double, 2>& speed2, double way, double speed) const noexcept;

private:
    double spare_accel(double speed2) const noexcept;

    double period_s_;
    PathTiming timing_{};
};

}  // namespace psicarve::cycle
