// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/block_list.hpp"

#include <algorithm>
#include <cstdlib>

namespace psicarve::plan {

using cycle::BlockKind;
using cycle::MotionBlock;

namespace {

Pulses4 along(Axis axis, std::int64_t way_pulses) {
    Pulses4 delta{};
    delta[index_of(axis)] = way_pulses;
    return delta;
}

SpeedCaps cap(Axis axis, double speed_pps) {
    SpeedCaps caps{};
    caps[index_of(axis)] = speed_pps;
    return caps;
}

}  // namespace

MotionBlock& BlockList::add_motion(const Pulses4& delta_pulses, const SpeedCaps& caps) {
    const GroupLimits group = line_limits(*limits_, delta_pulses, caps);
    MotionBlock block{};
    block.kind = BlockKind::move;
    block.group_blocks = 1;
    block.delta_pulses = delta_pulses;
    block.start_speed_per_s = group.start_per_s;
    block.max_speed_per_s = group.max_per_s;
    block.accel_per_s2 = group.accel_per_s2;
    std::int64_t capacity = 0;
    for (const std::int64_t delta : delta_pulses) capacity = std::max(capacity, std::abs(delta));
    block.group_iterations = static_cast<std::uint64_t>(capacity);
    return blocks_.emplace_back(block);
}

void BlockList::move(const Pulses4& delta_pulses, const SpeedCaps& caps) {
    if (delta_pulses != Pulses4{}) add_motion(delta_pulses, caps);
}

void BlockList::seek(Axis axis, cycle::Until until, std::int64_t way_pulses, double speed_pps) {
    MotionBlock& block = add_motion(along(axis, way_pulses), cap(axis, speed_pps));
    block.until = until;
    block.axis = static_cast<std::uint8_t>(axis);
    block.is_homing = 1;
}

void BlockList::latch(std::int64_t position_pulses) {
    blocks_.back().latch = cycle::Latch::at_edge;
    blocks_.back().position_pulses = position_pulses;
}

void BlockList::homing_move(Axis axis, std::int64_t way_pulses, double speed_pps) {
    MotionBlock& block = add_motion(along(axis, way_pulses), cap(axis, speed_pps));
    block.axis = static_cast<std::uint8_t>(axis);
    block.is_homing = 1;
}

void BlockList::define(Axis axis, std::int64_t position_pulses) {
    MotionBlock block{};
    block.kind = BlockKind::define;
    block.axis = static_cast<std::uint8_t>(axis);
    block.position_pulses = position_pulses;
    blocks_.push_back(block);
}

void BlockList::outputs(std::uint8_t enable_mask, cycle::Spindle spindle) {
    MotionBlock block{};
    block.kind = BlockKind::outputs;
    block.enable_mask = enable_mask;
    block.spindle = spindle;
    if (spindle == cycle::Spindle::off) block.switched_off = kAllSwitchedOutputs;
    blocks_.push_back(block);
}

void BlockList::dwell(std::int64_t ticks) {
    if (ticks <= 0) return;
    MotionBlock block{};
    block.kind = BlockKind::dwell;
    block.ticks = ticks;
    blocks_.push_back(block);
}

// A block without any way ends at once and still marks its point.
void BlockList::reach(std::uint32_t layer, std::uint32_t point) {
    if (blocks_.empty() || blocks_.back().kind != BlockKind::move || blocks_.back().reaches_points != 0) {
        add_motion({}, {});
    }
    blocks_.back().reaches_points = 1;
    blocks_.back().layer = layer;
    blocks_.back().point = point;
}

void BlockList::end() {
    MotionBlock block{};
    block.kind = BlockKind::program_end;
    blocks_.push_back(block);
}

}  // namespace psicarve::plan
