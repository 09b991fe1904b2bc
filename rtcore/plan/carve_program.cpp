// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/carve_program.hpp"

#include <algorithm>
#include <utility>

#include "rtcore/plan/approach.hpp"
#include "rtcore/plan/block_list.hpp"
#include "shared/units.hpp"

namespace psicarve::plan {

using cycle::BlockKind;
using cycle::MotionBlock;

CarveProgram::CarveProgram(const MachineLimits& limits, std::shared_ptr<const JobView> job,
                           std::uint32_t first_layer)
    : limits_(limits), job_(std::move(job)), first_layer_(first_layer), layer_(first_layer) {
    // The feed is the job's own; the profile's is what a slicer puts there.
    if (job_->header().feed_mm_s > 0.0) limits_.feed_mm_s = job_->header().feed_mm_s;
    at_pulses_ = point_at(0);
}

bool CarveProgram::next(MotionBlock& block) {
    while (next_ == blocks_.size()) {
        if (is_ended_) return false;
        blocks_.clear();
        next_ = 0;
        make_layer();
    }
    block = blocks_[next_++];
    return true;
}

Pulses4 CarveProgram::point_at(std::uint32_t step) const {
    const std::uint32_t point = carved_point(job_->joining(), job_->point_count(), layer_, step);
    return {job_->r_left_pulses(layer_)[point], job_->r_right_pulses(layer_)[point],
            job_->psi_pulses(layer_, point), job_->layer_heights_pulses()[layer_]};
}

void CarveProgram::make_layer() {
    BlockList list(limits_);
    if (layer_ == job_->layer_count()) {
        list.end();
        blocks_ = std::move(list.blocks());
        is_ended_ = true;
        return;
    }
    if (layer_ > first_layer_) {
        const Pulses4 start = point_at(0);
        add_link(list, limits_, at_pulses_, start, layer_,
                 carved_point(job_->joining(), job_->point_count(), layer_, 0));
        at_pulses_ = start;
        blocks_ = std::move(list.blocks());
        for (const MotionBlock& link : blocks_) {
            const GroupLimits speeds{link.start_speed_per_s, link.max_speed_per_s, link.accel_per_s2};
            planned_.seconds += group_seconds(speeds, link.group_iterations);
        }
        ++planned_.points;
    }
    make_lines();
    add_lines();
    ++layer_;
}

void CarveProgram::make_lines() {
    lines_.clear();
    for (std::uint32_t step = 1; step < job_->point_count(); ++step) {
        const Pulses4 to = point_at(step);
        TableLine line{};
        for (std::size_t k = 0; k < kAxisCount; ++k) line.delta_pulses[k] = to[k] - at_pulses_[k];
        for (std::size_t head = 0; head < 2; ++head) {
            line.radius_mm[head] =
                mm_from_pulses(std::max(to[head], at_pulses_[head]), limits_.axes[head].pulses_per_unit) +
                limits_.tip_offset_mm[head];
        }
        line.layer = layer_;
        line.point = carved_point(job_->joining(), job_->point_count(), layer_, step);
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
            block.reaches_point = 1;
            block.delta_pulses = line.delta_pulses;
            block.layer = line.layer;
            block.point = line.point;
            if (i == 0) {
                block.group_blocks = static_cast<std::uint32_t>(group.count);
                block.group_iterations = group.iterations;
                block.start_speed_per_s = group.limits.start_per_s;
                block.max_speed_per_s = group.limits.max_per_s;
                block.accel_per_s2 = group.limits.accel_per_s2;
            }
            blocks_.push_back(block);
        }
        planned_.points += group.count;
        planned_.seconds += group_seconds(group.limits, group.iterations);
    }
}

}  // namespace psicarve::plan
