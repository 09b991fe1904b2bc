// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/stepped_program.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "shared/base/units.hpp"

namespace psicarve::plan {

using cycle::BlockKind;
using cycle::MotionBlock;
using cycle::PointByPoint;

namespace {

Pulses4 target_of(const cycle::MotionOrder& order, const Pulses4& from_pulses) {
    Pulses4 to = from_pulses;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if ((order.axes >> k & 1U) != 0) to[k] = order.target_pulses[k];
    }
    return to;
}

PointByPoint way_of(const cycle::ArcInPlane& plane, bool is_arc) {
    if (is_arc) return PointByPoint::arc(plane.begin, plane.end, plane.counter_clockwise);
    return PointByPoint::line({plane.end.x - plane.begin.x, plane.end.y - plane.begin.y});
}

}  // namespace

SteppedProgram::SteppedProgram(const MachineLimits& limits, const cycle::MotionOrder& order,
                               const Pulses4& from_pulses, double seconds)
    : limits_(&limits),
      plane_(cycle::arc_of(order, from_pulses, target_of(order, from_pulses))),
      way_(way_of(plane_, cycle::is_arc(order))) {
    speeds_ = cycle::is_arc(order) ? arc_speeds() : line_speeds();
    count_groups();
    if (seconds > 0.0) keep_to(length_pulses(cycle::is_arc(order)) / seconds);
}

void SteppedProgram::keep_to(double speed_per_s) {
    speeds_.max_per_s = std::min(speeds_.max_per_s, speed_per_s);
    speeds_.start_per_s = std::min(speeds_.start_per_s, speeds_.max_per_s);
}

// What V steps a second may at most be for a path at the speed F: all of a line has one direction, N steps
// over its length. Of an arc they are as long as the path where only one axis steps, so that V = F.
double SteppedProgram::length_pulses(bool is_arc) const {
    const auto steps = static_cast<double>(steps_);
    if (!is_arc) return steps;
    const auto angle = [](PointByPoint::Point at) {
        return std::atan2(static_cast<double>(at.y), static_cast<double>(at.x));
    };
    const auto radius = static_cast<double>(plane_.radius_pulses);
    const double way = angle(plane_.end) - angle(plane_.begin);
    double turned = std::fmod((plane_.counter_clockwise ? way : -way) + 4.0 * kPi, 2.0 * kPi);
    // Steps are at most the square root of two times as long as the arc.
    if (steps > 1.5 * turned * radius + 8.0) turned += 2.0 * kPi;
    return turned > 0.0 ? std::min(steps, turned * radius) : steps;
}

std::optional<SteppedProgram::Run> SteppedProgram::next_run(PointByPoint& way) {
    if (way.is_finished()) return std::nullopt;
    PointByPoint::Step step = way.next();
    Run run{step.x != 0 ? std::size_t{0} : std::size_t{1}, step.x + step.y, 1};
    for (PointByPoint ahead = way; !ahead.is_finished(); ++run.steps) {
        if (ahead.next() != step) break;
        way = ahead;
    }
    return run;
}

void SteppedProgram::count_groups() {
    std::array<int, 2> last{};
    PointByPoint way = way_;
    while (const auto run = next_run(way)) {
        const bool has_gap = limits_->axes[plane_.axes[run->axis]].backlash_pulses > 0;
        const bool turns = has_gap && last[run->axis] != run->direction;
        last[run->axis] = run->direction;
        last_[plane_.axes[run->axis]] = run->direction;
        steps_ += static_cast<std::uint64_t>(run->steps);
        if (turns || groups_.empty()) groups_.push_back({0, 0});
        ++groups_.back().blocks;
        groups_.back().steps += static_cast<std::uint64_t>(run->steps);
    }
}

// An axis makes its share of the steps, and never more than one in two ticks' time of the pins.
GroupLimits SteppedProgram::line_speeds() const {
    const std::array<std::int64_t, 2> way{std::abs(plane_.end.x - plane_.begin.x),
                                          std::abs(plane_.end.y - plane_.begin.y)};
    const auto steps = static_cast<double>(way[0] + way[1]);
    GroupLimits speeds{limits_->max_iterations_per_s, limits_->max_iterations_per_s, 0.0};
    for (std::size_t i = 0; i < way.size(); ++i) {
        if (way[i] == 0) continue;
        const AxisMotion& axis = limits_->axes[plane_.axes[i]];
        const double ratio = steps / static_cast<double>(way[i]);
        speeds.start_per_s = std::min(speeds.start_per_s, axis.start_stop_pps);
        speeds.max_per_s = std::min(speeds.max_per_s, axis.speed_pps * ratio);
        const double accel = axis.accel_pps2 * ratio;
        speeds.accel_per_s2 = speeds.accel_per_s2 > 0.0 ? std::min(speeds.accel_per_s2, accel) : accel;
    }
    speeds.start_per_s = std::min(speeds.start_per_s, speeds.max_per_s);
    return speeds;
}

// With V steps a second at the angle t an axis moves at V*sin(t)/(|sin(t)| + |cos(t)|): at most V, its
// acceleration at most V^2/R and the ramp's. At a circle's end the axis that runs waits for three steps of
// the other, h steps apart: to lose a step in 2h of them, and to change its pace for that within two steps,
// takes V^2/16h^2. Ramp, circle and end get a third each of what the axis has.
GroupLimits SteppedProgram::arc_speeds() const {
    GroupLimits speeds{limits_->max_iterations_per_s, limits_->max_iterations_per_s, 0.0};
    for (const std::size_t k : plane_.axes) {
        const AxisMotion& axis = limits_->axes[k];
        const double third = axis.accel_pps2 / 3.0;
        speeds.start_per_s = std::min(speeds.start_per_s, axis.start_stop_pps);
        speeds.max_per_s = std::min({speeds.max_per_s, axis.speed_pps,
                                     std::sqrt(third * static_cast<double>(plane_.radius_pulses)),
                                     std::max(axis.start_stop_pps, 4.0 * end_steps() * std::sqrt(third))});
        speeds.accel_per_s2 = speeds.accel_per_s2 > 0.0 ? std::min(speeds.accel_per_s2, third) : third;
    }
    speeds.start_per_s = std::min(speeds.start_per_s, speeds.max_per_s);
    return speeds;
}

// Of the radius R, rounded up, the outermost steps are made where the circle leaves R - 1.
double SteppedProgram::end_steps() const {
    const std::int64_t inner = plane_.radius_pulses - 1;
    const std::int64_t square =
        plane_.begin.x * plane_.begin.x + plane_.begin.y * plane_.begin.y - inner * inner;
    return std::sqrt(static_cast<double>(std::max<std::int64_t>(square, 1)));
}

bool SteppedProgram::next(MotionBlock& block) {
    if (is_ended_) return false;
    block = MotionBlock{};
    const auto run = next_run(way_);
    if (!run) {
        block.kind = BlockKind::program_end;
        is_ended_ = true;
        return true;
    }
    block.kind = BlockKind::line;
    block.delta_pulses[plane_.axes[run->axis]] = run->direction * run->steps;
    if (blocks_left_ == 0) {
        const Group& group = groups_[group_++];
        blocks_left_ = group.blocks;
        block.group_blocks = group.blocks;
        block.group_iterations = group.steps;
        block.start_speed_per_s = speeds_.start_per_s;
        block.max_speed_per_s = speeds_.max_per_s;
        block.accel_per_s2 = speeds_.accel_per_s2;
    }
    --blocks_left_;
    return true;
}

}  // namespace psicarve::plan
