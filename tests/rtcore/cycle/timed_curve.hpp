// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rtcore/cycle/motion_block.hpp"

namespace psicarve::cycle {

using Axis4 = std::array<double, kAxisCount>;

/// Per axis, in pulses and ticks.
struct CurveLimits {
    Axis4 speed{0.4, 0.4, 0.4, 0.4};
    Axis4 accel{2e-4, 2e-4, 2e-4, 2e-4};
    Axis4 jump{0.02, 0.02, 0.02, 0.02};
    double feed = 1e9;  ///< du/dt of the 100 % profile at most
};

/// A random curve of four axes that is made of parabolas, one a segment: q' is linear and q'' constant in it,
/// so that what an axis does along a profile can be bounded exactly from a segment's ends. Timed as fast as
/// the limits allow: backward and forward over the segments, in each the small linear programme solved by
/// trying its corners.
class TimedCurve {
public:
    TimedCurve(std::uint64_t seed, std::size_t segments, const CurveLimits& limits);

    std::size_t segments() const { return bend_.size(); }
    double length() const { return length_; }
    const CurveLimits& limits() const { return limits_; }
    /// dq/du and d2q/du2 in a segment, `way` from its begin.
    Axis4 slope(std::size_t segment, double way) const;
    const Axis4& bend(std::size_t segment) const { return bend_[segment]; }
    /// The square of the planned speed there, profile 0 or 1 [per tick^2].
    double speed2(std::size_t profile, std::size_t segment, double way) const;
    /// At the nodes of the first segments: the square of the greatest speed within the axes' limits from
    /// which the last of them ends at rest, and that a motion from the begin has [per tick^2].
    std::vector<double> rest_speed2(std::size_t segments) const;
    /// With whole pulses; every tenth segment's end is a point.
    const std::vector<MotionBlock>& blocks() const { return blocks_; }

private:
    void shape(std::uint64_t seed, std::size_t segments);
    std::vector<double> caps(double feed) const;
    std::vector<double> timed(double feed) const;
    std::vector<double> timed_within(std::vector<double> most) const;
    void fill_blocks();

    CurveLimits limits_;
    double length_ = 0.0;
    std::vector<Axis4> slope_;  ///< at the nodes
    std::vector<Axis4> bend_;
    std::vector<Axis4> place_;  ///< at the nodes
    std::array<std::vector<double>, 2> speed2_;
    std::vector<MotionBlock> blocks_;
};

}  // namespace psicarve::cycle
