// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/table_program.hpp"

#include <algorithm>
#include <utility>

#include "rtcore/plan/approach.hpp"
#include "rtcore/plan/block_list.hpp"

namespace psicarve::plan {
namespace {

using cycle::BlockKind;
using cycle::MotionBlock;

// A stop after so many of a spiral's points costs next to nothing, and what they take of memory is little.
constexpr std::uint32_t kSpiralPointsAtOnce = 8192;

}  // namespace

MachineLimits limits_of_job(const MachineLimits& limits, const JobView& job) {
    MachineLimits result = limits;
    // The feed is the job's own; the profile's is what a slicer puts there.
    if (job.header().feed_mm_s > 0.0) result.feed_mm_s = job.header().feed_mm_s;
    result.outside = heads_outside(job, limits.outside_rule);
    return result;
}

Pulses4 pulses_at(const JobView& job, std::uint32_t layer, std::uint32_t step) {
    const std::uint32_t point = carved_point(job.joining(), job.point_count(), layer, step);
    return {job.r_left_pulses(layer)[point], job.r_right_pulses(layer)[point], job.psi_pulses(layer, point),
            job.y_pulses(layer, point)};
}

std::uint32_t layers_at_once(const JobView& job, std::uint32_t layer) {
    return is_spiral_row(job, layer) ? std::max(1U, kSpiralPointsAtOnce / job.point_count()) : 1;
}

TableProgram::TableProgram(const MachineLimits& limits, std::shared_ptr<const JobView> job, LayerSpan layers)
    : limits_(limits_of_job(limits, *job)),
      job_(std::move(job)),
      first_layer_(layers.first),
      first_step_(layers.first_step),
      end_layer_(std::min(layers.end, job_->layer_count())),
      layer_(layers.first),
      times_(limits_) {}

bool TableProgram::next(MotionBlock& block) {
    while (next_ == blocks_.size()) {
        if (is_ended_) return false;
        blocks_.clear();
        next_ = 0;
        if (layer_ >= end_layer_) {
            is_ended_ = true;
            blocks_.emplace_back();
            blocks_.back().kind = BlockKind::program_end;
        } else {
            make_blocks();
        }
    }
    block = blocks_[next_++];
    return true;
}

void TableProgram::make_blocks() {
    make_layers();
    planned_.seconds += times_.seconds_of(blocks_);
}

void TableProgram::add_way_to_pass(const Pulses4& from_pulses) {
    BlockList list(limits_);
    add_way_between_passes(list, limits_, *job_, from_pulses, layer_);
    for (const MotionBlock& block : list.blocks()) {
        planned_.points += block.reaches_points;
        blocks_.push_back(block);
    }
}

void TableProgram::reach(MotionBlock& block, std::uint32_t layer, std::uint32_t step) {
    block.reaches_points = 1;
    block.layer = layer;
    block.point = carved_point(job_->joining(), job_->point_count(), layer, step);
    if (step + 1 == job_->point_count() && layer + 1 < job_->layer_count() && job_->is_joint(layer + 1, 0)) {
        block.reaches_points = 2;
        block.layer = layer + 1;
        block.point = 0;
    }
    planned_.points += block.reaches_points;
}

}  // namespace psicarve::plan
