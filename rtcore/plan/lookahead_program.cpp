// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/lookahead_program.hpp"

#include <algorithm>
#include <utility>

namespace psicarve::plan {
namespace {

using cycle::BlockKind;
using cycle::MotionBlock;

// Stands for "no limit" where an axis does not move.
constexpr float kNoLimit = 1e30F;

MachineLimits with_feed_of(const MachineLimits& limits, const JobView& job) {
    MachineLimits result = limits;
    // The feed is the job's own; the profile's is what a slicer puts there.
    if (job.header().feed_mm_s > 0.0) result.feed_mm_s = job.header().feed_mm_s;
    return result;
}

cycle::PathTiming timing_of(const MachineLimits& limits, const PathPiece& piece) {
    cycle::PathTiming timing{};
    timing.length = piece.length;
    timing.start_speed2 = piece.begin_speed2;
    timing.end_speed2 = piece.end_speed2;
    double jump = 1.0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        timing.accel_free[k] = kNoLimit;
        if (piece.slope[k] <= 0.0) continue;
        timing.accel_free[k] = static_cast<float>(limits.axes[k].accel_pps2 / piece.slope[k]);
        timing.accel_bend[k] = static_cast<float>(piece.bend[k] / piece.slope[k]);
        jump = std::min(jump, limits.axes[k].start_stop_pps / piece.slope[k]);
    }
    timing.start_stop_speed = static_cast<float>(jump);
    return timing;
}

}  // namespace

LookaheadProgram::LookaheadProgram(const MachineLimits& limits, std::shared_ptr<const JobView> job,
                                   std::uint32_t first_layer)
    : limits_(with_feed_of(limits, *job)),
      job_(std::move(job)),
      stretches_(limits_),
      first_layer_(first_layer),
      layer_(first_layer) {
    planned_.is_reference = first_layer == 0;
}

bool LookaheadProgram::next(MotionBlock& block) {
    while (next_ == blocks_.size()) {
        if (is_ended_) return false;
        blocks_.clear();
        next_ = 0;
        make_layer();
    }
    block = blocks_[next_++];
    return true;
}

PathPoint LookaheadProgram::point_at(std::uint32_t layer, std::uint32_t step) const {
    const std::uint32_t point = carved_point(job_->joining(), job_->point_count(), layer, step);
    return {{job_->r_left_pulses(layer)[point], job_->r_right_pulses(layer)[point],
             job_->psi_pulses(layer, point), job_->layer_heights_pulses()[layer]},
            layer,
            point,
            false};
}

void LookaheadProgram::make_layer() {
    if (layer_ == job_->layer_count()) {
        MotionBlock end{};
        end.kind = BlockKind::program_end;
        blocks_.push_back(end);
        is_ended_ = true;
        return;
    }
    gather_points();
    // One point more at either side belongs to them only so that those corners are seen.
    const std::size_t begin = layer_ > first_layer_ ? 1 : 0;
    const std::size_t last = points_.size() - (layer_ + 1 < job_->layer_count() ? 2 : 1);
    const std::vector<PathSpan> spans = path_spans(limits_, points_);
    const std::vector<PathCorner> corners = path_corners(limits_, spans);
    std::size_t first = begin;
    for (std::size_t i = begin + 1; i <= last; ++i) {
        // A layer begins and ends at rest: psi stands still while Y moves on.
        const bool begins_layer = i == first_of_layer_;
        if (i < last && !begins_layer && !corners[i - 1].is_stop) continue;
        pieces_.clear();
        planned_.seconds += stretches_.plan(points_, spans, corners, first, i, pieces_);
        add_stretch();
        first = i;
    }
    ++layer_;
}

void LookaheadProgram::gather_points() {
    points_.clear();
    const std::uint32_t count = job_->point_count();
    if (layer_ > first_layer_) {
        points_.push_back(point_at(layer_ - 1, count - 2));
        points_.push_back(point_at(layer_ - 1, count - 1));
        add_way_between(points_.back(), point_at(layer_, 0));
    }
    first_of_layer_ = points_.size();
    for (std::uint32_t step = 0; step < count; ++step) points_.push_back(point_at(layer_, step));
    if (layer_ + 1 < job_->layer_count()) points_.push_back(point_at(layer_ + 1, 0));
}

// Half-way up one layer's cut ends and the next one's begins. Heads that have to move out do so below, those
// that move in do so above: then neither ever stands deeper than the layer it is in asks.
void LookaheadProgram::add_way_between(const PathPoint& from, const PathPoint& to) {
    constexpr std::size_t kY = index_of(Axis::y);
    const std::int64_t rise_pulses = to.pulses[kY] - from.pulses[kY];
    PathPoint below = from;
    below.layer = to.layer;
    below.is_on_the_way = true;
    below.pulses[kY] += rise_pulses / 2;
    PathPoint above = below;
    above.pulses[kY] += 1;
    bool moves_out = false;
    bool moves_in = false;
    for (std::size_t head = 0; head < 2; ++head) {
        below.pulses[head] = above.pulses[head] = std::max(from.pulses[head], to.pulses[head]);
        moves_out = moves_out || to.pulses[head] > from.pulses[head];
        moves_in = moves_in || to.pulses[head] < from.pulses[head];
    }
    if (moves_out && below.pulses != from.pulses) points_.push_back(below);
    if (moves_in && above.pulses != to.pulses) points_.push_back(above);
}

void LookaheadProgram::add_stretch() {
    const std::size_t begin = blocks_.size();
    for (const PathPiece& piece : pieces_) add_block(piece);
    blocks_[begin].group_blocks = static_cast<std::uint32_t>(blocks_.size() - begin);
    note_gaps(std::span(blocks_).subspan(begin));
}

// A run has a stop wherever an axis with backlash turns round: in it such an axis goes one way.
void LookaheadProgram::note_gaps(std::span<MotionBlock> run) const {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (limits_.tick.axes[k].backlash_pulses == 0) continue;
        const auto moves = [k](const MotionBlock& block) { return block.delta_pulses[k] != 0; };
        const auto first = std::find_if(run.begin(), run.end(), moves);
        if (first == run.end()) continue;
        std::uint8_t& axes = first->delta_pulses[k] > 0 ? run.front().up_axes : run.front().down_axes;
        axes = static_cast<std::uint8_t>(axes | 1U << k);
    }
}

void LookaheadProgram::add_block(const PathPiece& piece) {
    MotionBlock block{};
    block.kind = BlockKind::path;
    block.delta_pulses = piece.delta_pulses;
    block.path = timing_of(limits_, piece);
    if (piece.point != PathPiece::kNoPoint && !points_[piece.point].is_on_the_way) {
        ++planned_.points;
        block.reaches_point = 1;
        block.layer = points_[piece.point].layer;
        block.point = points_[piece.point].point;
    }
    blocks_.push_back(block);
}

}  // namespace psicarve::plan
