// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/lookahead_program.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "rtcore/plan/link_way.hpp"
#include "rtcore/plan/path_blocks.hpp"
#include "rtcore/plan/speed_up.hpp"

namespace psicarve::plan {
namespace {

using cycle::MotionBlock;

// Shapes of a link that are tried: so many parts of each half.
constexpr std::array kLinkParts{1, 3};

}  // namespace

LookaheadProgram::LookaheadProgram(const MachineLimits& limits, std::shared_ptr<const JobView> job,
                                   LayerSpan layers)
    : TableProgram(limits, std::move(job), layers), stretches_(limits_) {
    planned_.is_reference = first_layer_ == 0 && first_step_ == 0 && end_layer_ == job_->layer_count();
    if (is_spiral()) layer_ -= (first_layer_ - job_->finishing_layer()) % layers_at_once();
}

void LookaheadProgram::make_layers() {
    points_.clear();
    const std::uint32_t first = layer_;
    const std::uint32_t pass_end = job_->pass_end(layer_);
    const std::uint32_t end = std::min(layer_ + layers_at_once(), pass_end);
    // One point more at either side belongs to them only so that those corners are seen; where carving begins
    // with a later layer, so does the way to it, for which way axes with backlash come from.
    const bool has_before = !begins_pass();
    const bool has_way = !is_spiral() && first == first_layer_;
    const bool has_after = end < pass_end;
    if (first > first_layer_ && begins_pass()) add_way_to_pass(point_at(first - 1, job_->point_count() - 1));
    if (is_spiral()) {
        gather_rows(end);
    } else {
        gather_layer();
    }
    add_stretches(!has_before ? 0 : has_way ? first_of_layer_ : 1, points_.size() - (has_after ? 2 : 1));
    if (first < first_layer_ || (first == first_layer_ && first_step_ > 0)) begin_in_between();
    if (end > end_layer_) end_in_between();
    layer_ = end;
}

// A layer begins and ends at rest: psi stands still while Y moves on. So do the rows of a spiral made at
// once.
void LookaheadProgram::add_stretches(std::size_t first, std::size_t last) {
    const std::vector<PathSpan> spans = path_spans(limits_, points_);
    const std::vector<PathCorner> corners = path_corners(limits_, spans);
    for (std::size_t i = first + 1; i <= last; ++i) {
        if (i < last && i != first_of_layer_ && !corners[i - 1].is_stop) continue;
        pieces_.clear();
        stretches_.plan(points_, spans, corners, first, i, pieces_);
        add_stretch();
        first = i;
    }
}

void LookaheadProgram::gather_layer() {
    const std::uint32_t count = job_->point_count();
    const auto point = [this](std::uint32_t layer, std::uint32_t step) {
        return PathPoint{point_at(layer, step), layer, step, false};
    };
    if (!begins_pass()) {
        points_.push_back(point(layer_ - 1, count - 2));
        points_.push_back(point(layer_ - 1, count - 1));
        add_fastest_link(PathPoint{points_.back()}, point(layer_, 0));
    }
    first_of_layer_ = points_.size();
    for (std::uint32_t step = 0; step < count; ++step) points_.push_back(point(layer_, step));
    if (layer_ + 1 < job_->pass_end(layer_)) points_.push_back(point(layer_ + 1, 0));
}

// Each row begins in the point that the one before ends in. All of them count as one layer: there is no way
// between them.
void LookaheadProgram::gather_rows(std::uint32_t end) {
    const std::uint32_t steps = job_->point_count() - 1;
    if (!begins_pass()) points_.push_back({point_at(layer_ - 1, steps - 1), layer_, 0, false});
    first_of_layer_ = points_.size();
    points_.push_back({point_at(layer_, 0), layer_, 0, false});
    std::uint32_t step = 0;
    for (std::uint32_t row = layer_; row < end; ++row) {
        for (std::uint32_t i = 1; i <= steps; ++i)
            points_.push_back({point_at(row, i), layer_, ++step, false});
    }
    if (end < job_->pass_end(layer_)) points_.push_back({point_at(end, 1), layer_, ++step, false});
}

// Which shape is the fastest depends on what of it the rounding to whole pulses leaves, and on where motors
// may jump.
void LookaheadProgram::add_fastest_link(const PathPoint& from, const PathPoint& to) {
    double least_s = std::numeric_limits<double>::infinity();
    std::vector<PathPoint> way;
    std::vector<PathPoint> fastest;
    for (const int parts : kLinkParts) {
        way.assign(1, from);
        add_link_way(limits_, from, to, parts, way);
        way.push_back(to);
        const bool is_straight = way.size() == 2;
        const double seconds = is_straight ? 0.0 : seconds_of(way);
        if (seconds < least_s) fastest.swap(way);
        if (is_straight) break;
        least_s = std::min(least_s, seconds);
    }
    points_.insert(points_.end(), fastest.begin() + 1, fastest.end() - 1);
}

/// From rest to rest.
double LookaheadProgram::seconds_of(std::span<const PathPoint> way) {
    const std::vector<PathSpan> spans = path_spans(limits_, way);
    const std::vector<PathCorner> corners = path_corners(limits_, spans);
    double seconds = 0.0;
    std::size_t first = 0;
    for (std::size_t i = 1; i < way.size(); ++i) {
        if (i + 1 < way.size() && !corners[i - 1].is_stop) continue;
        pieces_.clear();
        seconds += stretches_.plan(way, spans, corners, first, i, pieces_);
        first = i;
    }
    return seconds;
}

void LookaheadProgram::add_stretch() {
    std::size_t begin = blocks_.size();
    for (const PathPiece& piece : pieces_) {
        add_block(piece);
        if (!piece.rests) continue;
        blocks_[begin].group_blocks = static_cast<std::uint32_t>(blocks_.size() - begin);
        note_gaps(limits_, std::span(blocks_).subspan(begin));
        begin = blocks_.size();
    }
}

void LookaheadProgram::add_block(const PathPiece& piece) {
    MotionBlock& block = blocks_.emplace_back(path_block(limits_, piece));
    const bool reaches_point = piece.point != PathPiece::kNoPoint && !points_[piece.point].is_on_the_way;
    if (reaches_point && is_spiral()) {
        const std::uint32_t steps = job_->point_count() - 1;
        const std::uint32_t step = points_[piece.point].point - 1;
        reach(block, points_[piece.point].layer + step / steps, step % steps + 1);
    } else if (reaches_point) {
        reach(block, points_[piece.point].layer, points_[piece.point].point);
    }
}

// The layer, or the rows made at once, begin further down than the carving does: what leads up to there is
// left out.
void LookaheadProgram::begin_in_between() {
    const std::uint32_t point = carved_point(job_->joining(), job_->point_count(), first_layer_, first_step_);
    auto run = blocks_.begin();
    auto first = blocks_.begin();
    for (;; ++first) {
        if (first->group_blocks > 0) run = first;
        planned_.points -= first->reaches_points;
        if (first->reaches_points > 0 && first->layer == first_layer_ && first->point == point) break;
    }
    const auto left = static_cast<std::uint32_t>(run->group_blocks - (first + 1 - run));
    blocks_.erase(blocks_.begin(), first + 1);
    if (left > 0) {
        blocks_.front().group_blocks = left;
        note_gaps(limits_, std::span(blocks_).first(left));
        speed_up_from_rest(std::span(blocks_).first(left));
    }
}

// The rows made at once go further up than the carving does: it comes to rest where its last row ends.
void LookaheadProgram::end_in_between() {
    auto run = blocks_.begin();
    auto last = blocks_.begin();
    for (;; ++last) {
        if (last->group_blocks > 0) run = last;
        if (last->reaches_points == 2 && last->layer == end_layer_) break;
    }
    for (auto left_out = last + 1; left_out != blocks_.end(); ++left_out)
        planned_.points -= left_out->reaches_points;
    const bool was_cut = last + 1 != blocks_.end() && (last + 1)->group_blocks == 0;
    blocks_.erase(last + 1, blocks_.end());
    if (!was_cut) return;
    const std::span<MotionBlock> shortened{run, blocks_.end()};
    run->group_blocks = static_cast<std::uint32_t>(shortened.size());
    run->up_axes = run->down_axes = 0;
    note_gaps(limits_, shortened);
    slow_down_to_rest(shortened);
}

}  // namespace psicarve::plan
