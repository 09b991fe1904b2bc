// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/point_times.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace psicarve::plan {
namespace {

using cycle::BlockKind;
using cycle::MotionBlock;

/// An axis that uses less of what it has is not what bounds a way.
constexpr double kAtItsLimit = 0.9;
/// An axis that does not move has no least acceleration (PathTiming).
constexpr double kMoves = 1e29;

double iterations_of(const MotionBlock& block) noexcept {
    std::int64_t longest = 0;
    for (const std::int64_t delta : block.delta_pulses) longest = std::max(longest, std::abs(delta));
    return static_cast<double>(longest);
}

/// When so many iterations of a group are done, from start speed to start speed.
double seconds_to(const GroupLimits& limits, double group_iterations, double done) {
    const auto ramp_s = [&](double way) {
        return (std::sqrt(limits.start_per_s * limits.start_per_s + 2.0 * limits.accel_per_s2 * way) -
                limits.start_per_s) /
               limits.accel_per_s2;
    };
    const double whole_ramp =
        (limits.max_per_s * limits.max_per_s - limits.start_per_s * limits.start_per_s) /
        (2.0 * limits.accel_per_s2);
    const double ramp = std::min(whole_ramp, group_iterations / 2.0);
    if (done <= ramp) return ramp_s(done);
    const double even_s = (group_iterations - 2.0 * ramp) / limits.max_per_s;
    if (done <= group_iterations - ramp) return ramp_s(ramp) + (done - ramp) / limits.max_per_s;
    return 2.0 * ramp_s(ramp) + even_s - ramp_s(group_iterations - done);
}

}  // namespace

PointTimes::PointTimes(const MachineLimits& limits, const JobView& job)
    : limits_(limits), point_count_(job.point_count()) {
    const std::size_t points = std::size_t{job.layer_count()} * point_count_;
    plan_.seconds.resize(points);
    plan_.bounds.resize(points, WayBound::unknown);
}

void PointTimes::add(const MotionBlock& block) {
    const Cost cost = cost_of(block);
    way_s_ += cost.seconds;
    bound_s_[static_cast<std::size_t>(cost.bound)] += cost.seconds;
    if (block.reaches_points > 0) end_way(block);
}

PointTimes::Cost PointTimes::cost_of(const MotionBlock& block) {
    switch (block.kind) {
        case BlockKind::path:
            return cost_of_path(block);
        case BlockKind::line:
        case BlockKind::move:
            return cost_of_line(block);
        case BlockKind::dwell:
            return {static_cast<double>(block.ticks) * limits_.tick_seconds(), WayBound::unknown};
        case BlockKind::define:
        case BlockKind::outputs:
        case BlockKind::halt:
        case BlockKind::program_end:
            break;
    }
    return {};
}

// u's acceleration is one and the same within a segment: its speed squared is linear in u.
PointTimes::Cost PointTimes::cost_of_path(const MotionBlock& block) const {
    const cycle::PathTiming& path = block.path;
    const double start = std::sqrt(path.start_speed2[0]);
    const double end = std::sqrt(path.end_speed2[0]);
    if (start + end <= 0.0) return {};
    const double fastest = std::max(start, end);
    const double accel = std::abs(path.end_speed2[0] - path.start_speed2[0]) / (2.0 * path.length);
    const double pace2 = limits_.pace * limits_.pace;
    Shares shares{};
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double free = path.accel_free[k];
        if (!(free < kMoves) || free <= 0.0) continue;
        const double slope = limits_.axes[k].accel_pps2 / free;  // pulses by u
        const double speed_share = slope * fastest / limits_.axes[k].speed_pps / limits_.pace;
        const double accel_share = (accel + path.accel_bend[k] * fastest * fastest) / free / pace2;
        shares[k] = std::max(speed_share, accel_share);
    }
    return {2.0 * path.length / (start + end), bound_by(shares, WayBound::feed)};
}

PointTimes::Cost PointTimes::cost_of_line(const MotionBlock& block) {
    const double iterations = iterations_of(block);
    if (block.kind == BlockKind::move || block.group_blocks > 0) {
        group_ = {block.start_speed_per_s, block.max_speed_per_s, block.accel_per_s2};
        group_iterations_ =
            block.group_iterations > 0 ? static_cast<double>(block.group_iterations) : iterations;
        done_iterations_ = 0.0;
    }
    if (iterations <= 0.0) return {};
    const double begin_s = seconds_to(group_, group_iterations_, done_iterations_);
    done_iterations_ = std::min(done_iterations_ + iterations, group_iterations_);
    const double seconds = seconds_to(group_, group_iterations_, done_iterations_) - begin_s;
    if (seconds <= 0.0) return {};
    const double speed = iterations / seconds;
    const bool is_even = speed > kAtItsLimit * group_.max_per_s;
    Shares shares{};
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double part = static_cast<double>(std::abs(block.delta_pulses[k])) / iterations;
        const double speed_share = part * speed / limits_.axes[k].speed_pps;
        const double accel_share = is_even ? 0.0 : part * group_.accel_per_s2 / limits_.axes[k].accel_pps2;
        shares[k] = std::max(speed_share, accel_share);
    }
    // Lines of a group go by the least limit of them all, and ways between passes by the plunge's speed.
    return {seconds, bound_by(shares, WayBound::unknown)};
}

WayBound PointTimes::bound_by(const Shares& shares, WayBound if_none) noexcept {
    const auto most = std::ranges::max_element(shares);
    if (*most < kAtItsLimit) return if_none;
    return way_bound_of(static_cast<Axis>(most - shares.begin()));
}

// Where a row of a spiral ends the next one begins: the way leads to the end.
void PointTimes::end_way(const MotionBlock& block) {
    std::size_t reached = std::size_t{block.layer} * point_count_ + block.point;
    const auto most = std::ranges::max_element(bound_s_);
    const auto bound = static_cast<WayBound>(most - bound_s_.begin());
    if (reached < plan_.seconds.size()) {
        plan_.bounds[reached] = bound;
        if (block.reaches_points > 1 && reached > 0) --reached;
        plan_.bounds[reached] = bound;
        plan_.seconds[reached] = static_cast<float>(way_s_);
    }
    way_s_ = 0.0;
    bound_s_ = {};
}

}  // namespace psicarve::plan
