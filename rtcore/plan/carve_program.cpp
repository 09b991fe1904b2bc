// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/carve_program.hpp"

#include <algorithm>
#include <utility>

#include "rtcore/plan/approach.hpp"
#include "rtcore/plan/block_list.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {

using cycle::BlockKind;
using cycle::MotionBlock;

CarveProgram::CarveProgram(const MachineLimits& limits, std::shared_ptr<const JobView> job, LayerSpan layers)
    : TableProgram(limits, std::move(job), layers), at_pulses_(point_at(layers.first, layers.first_step)) {}

void CarveProgram::make_layers() {
    if (layer_ > first_layer_ && begins_pass()) {
        add_way_to_pass(at_pulses_);
        at_pulses_ = point_at(layer_, 0);
    } else if (layer_ > first_layer_ && !is_spiral()) {
        add_link_to_layer();
    }
    const std::uint32_t end = std::min({layer_ + layers_at_once(), job_->pass_end(layer_), end_layer_});
    lines_.clear();
    for (; layer_ < end; ++layer_) make_lines();
    add_lines();
}

void CarveProgram::add_link_to_layer() {
    BlockList list(limits_);
    const Pulses4 start = point_at(layer_, 0);
    add_link(list, limits_, at_pulses_, start, layer_,
             carved_point(job_->joining(), job_->point_count(), layer_, 0));
    at_pulses_ = start;
    blocks_ = std::move(list.blocks());
    ++planned_.points;
}

void CarveProgram::make_lines() {
    const std::uint32_t begin = layer_ == first_layer_ ? first_step_ : 0;
    for (std::uint32_t step = begin + 1; step < job_->point_count(); ++step) {
        const Pulses4 to = point_at(layer_, step);
        TableLine line{};
        for (std::size_t k = 0; k < kAxisCount; ++k) line.delta_pulses[k] = to[k] - at_pulses_[k];
        for (std::size_t head = 0; head < 2; ++head) {
            line.radius_mm[head] =
                mm_from_pulses(std::max(to[head], at_pulses_[head]), limits_.axes[head].pulses_per_unit) +
                limits_.tip_offset_mm[head];
            line.is_outside[head] = limits_.outside.holds(head, at_pulses_[head], to[head]);
        }
        line.layer = layer_;
        line.step = step;
        lines_.push_back(line);
        at_pulses_ = to;
    }
}

void CarveProgram::add_lines() {
    for (const LineGroup& group : plan_by_angle(limits_, lines_)) {
        for (std::size_t i = 0; i < group.count; ++i) {
            const TableLine& line = lines_[group.first + i];
            MotionBlock block{};
            block.kind = BlockKind::line;
            block.delta_pulses = line.delta_pulses;
            reach(block, line.layer, line.step);
            if (i == 0) {
                block.group_blocks = static_cast<std::uint32_t>(group.count);
                block.group_iterations = group.iterations;
                block.start_speed_per_s = group.limits.start_per_s;
                block.max_speed_per_s = group.limits.max_per_s;
                block.accel_per_s2 = group.limits.accel_per_s2;
            }
            blocks_.push_back(block);
        }
    }
}

}  // namespace psicarve::plan
