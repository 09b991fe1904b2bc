// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/record_program.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "rtcore/plan/block_list.hpp"
#include "rtcore/plan/path_blocks.hpp"
#include "rtcore/plan/straight_stretch.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

using cycle::BlockKind;
using cycle::MotionBlock;

// No feed over the surface: a program says itself how long each way takes.
constexpr double kNoFeed_mm_s = 1e9;
// More than a window of ways can have.
constexpr int kMostStepsAtOnce = 4096;
// More would be no tolerance of this machine's any more; less is exact to the pulse.
constexpr double kMostTolerances = 1000.0;
constexpr double kLeastTolerance = 0.001;

// A rest may be left any way at once: what was jumped to it and what is jumped from it are not more than one
// jump together.
MachineLimits program_limits(MachineLimits limits) {
    limits.is_program = true;
    limits.feed_mm_s = kNoFeed_mm_s;
    for (AxisMotion& axis : limits.axes) axis.start_stop_pps *= 0.5;
    return limits;
}

}  // namespace

RecordProgram::RecordProgram(const MachineLimits& limits, std::shared_ptr<StepSource> source,
                             const Pulses4& start_pulses, bool is_single, std::size_t part_points)
    : machine_(limits),
      limits_(program_limits(limits)),
      source_(std::move(source)),
      is_single_(is_single),
      part_points_(part_points),
      asked_pulses_(start_pulses),
      speeds_(limits_, curve_accel(limits_)) {
    points_.push_back({start_pulses, 0, 0, false});
    ways_.push_back({});
}

bool RecordProgram::next(MotionBlock& block) {
    while (next_ == blocks_.size()) {
        if (stepped_ && next_stepped(block)) return true;
        if (next_ < blocks_.size()) break;
        if (is_ended_) return false;
        blocks_.clear();
        next_ = 0;
        if (!make_blocks()) return false;
    }
    block = blocks_[next_++];
    return true;
}

// False if the next step has not come yet.
bool RecordProgram::make_blocks() {
    ProgramStep step;
    is_waiting_ = false;
    for (int taken = 0; blocks_.empty() && !stepped_ && !is_ended_; ++taken) {
        // Steps that come to nothing, without end, must not keep the planner from what else is asked of it.
        if (taken == kMostStepsAtOnce) {
            is_waiting_ = true;
            return false;
        }
        switch (source_->next(step)) {
            case Supply::step:
                take(step);
                break;
            case Supply::later:
                is_waiting_ = true;
                return false;
            case Supply::lost:
                come_to_rest();
                halt(ProgramHold::feeder_lost, line_);
                is_ended_ = true;
                break;
            case Supply::refused:
                come_to_rest();
                halt(ProgramHold::refused, line_);
                is_ended_ = true;
                break;
            case Supply::ended:
                come_to_rest();
                end(line_);
                break;
        }
    }
    return true;
}

void RecordProgram::take(const ProgramStep& step) {
    line_ = step.line;
    sequence_ = step.sequence;
    if (step.kind == MotionKind::way || step.kind == MotionKind::arc) {
        const ProgramStep paced = at_the_programs_pace(step);
        return step.shape == cycle::OrderShape::straight ? take_way(paced) : take_stepped(paced);
    }
    come_to_rest();
    switch (step.kind) {
        case MotionKind::way:
        case MotionKind::arc:
            break;
        case MotionKind::dwell:
            dwell(round_to_pulse(step.seconds / machine_.tick_seconds()), step.line);
            break;
        case MotionKind::spindle:
            switch_spindle(step.is_on, step.line);
            break;
        case MotionKind::output:
            switch_outputs(step.outputs, step.is_on, step.line);
            break;
        case MotionKind::stop:
            return halt(static_cast<ProgramHold>(step.reason), step.line);
        case MotionKind::end:
            return end(step.line);
    }
    if (step.ends_block) end_line(step.line);
}

// At rest. What of the line there was is done.
void RecordProgram::end_line(std::uint64_t line) {
    if (is_single_) {
        halt(ProgramHold::single, line);
    } else if (!blocks_.empty()) {
        blocks_.back().ends_line = 1;
    }
}

void RecordProgram::take_way(const ProgramStep& step) {
    if (is_very_long(step)) {
        take_very_long_way(step);
        if (is_single_ && step.ends_block) halt(ProgramHold::single, step.line);
        return;
    }
    const bool has_way = step.target_pulses != points_.back().pulses;
    // It may only bring to rest what it ends.
    if (!has_way && step.ends_block && points_.size() > begin_ + 1) ways_.back().place.ends_line = true;
    const bool is_exact = step.tolerance_mm <= 0.0;
    // An exact way has no tube of the ways before it.
    const double before_mm = tolerance_mm_;
    if (before_mm > 0.0 && (is_exact || step.tolerance_mm != before_mm)) come_to_rest();
    if (!is_exact) tolerance_mm_ = step.tolerance_mm;
    if (has_way) add_way(step);
    const bool halts = is_single_ && step.ends_block;
    if (is_exact || halts) {
        come_to_rest();
    } else if (points_.size() > begin_ + part_points_ + kTailPoints) {
        go_ahead();
    }
    if (halts) halt(ProgramHold::single, step.line);
}

// From rest to rest.
void RecordProgram::take_stepped(const ProgramStep& step) {
    come_to_rest();
    longer_by_s_ = 0.0;
    const Pulses4 from = points_.back().pulses;
    const bool halts = is_single_ && step.ends_block;
    if (step.target_pulses == from && step.kind != MotionKind::arc) {
        if (halts) halt(ProgramHold::single, step.line);
        return;
    }
    cycle::MotionOrder order{};
    order.target_pulses = step.target_pulses;
    order.axes = step.stepped_axes;
    order.shape = step.shape;
    order.centre_pulses = step.centre_pulses;
    stepped_.emplace(limits_, order, from, step.seconds);
    halts_behind_stepped_ = halts;
    ends_behind_stepped_ = step.ends_block && !is_single_;
    // Where a screw has backlash its nut lies where the last step of its axis left it.
    Pulses4 before = step.target_pulses;
    for (std::size_t k = 0; k < kAxisCount; ++k) before[k] -= stepped_->last_direction(k);
    note_gap_ways(limits_, before, step.target_pulses, gap_ways_);
    points_.assign(1, {step.target_pulses, 0, 0, false});
    ways_.assign(1, {});
}

// False: there is none any more, and what follows stands in blocks_.
bool RecordProgram::next_stepped(MotionBlock& block) {
    if (stepped_->next(block) && block.kind != BlockKind::program_end) {
        set_program_line(block, line_);
        set_program_sequence(block, sequence_);
        if (stepped_->is_last() && ends_behind_stepped_) block.ends_line = 1;
        return true;
    }
    stepped_.reset();
    blocks_.clear();
    next_ = 0;
    if (halts_behind_stepped_) halt(ProgramHold::single, line_);
    return false;
}

// Plans all that was gathered; the next window begins where it ends.
void RecordProgram::come_to_rest() {
    if (points_.size() > begin_ + 1) {
        look_at_spans();
        if (is_open_) close_run(next_rest());
        if (points_.size() > 1) plan_stretch(plan_up_to_rests(), points_.size() - 1);
    }
    rest_at(points_.size() - 1);
    tolerance_mm_ = 0.0;
}

/// As far as the last corner that asks for a rest; none: begin_.
std::size_t RecordProgram::plan_up_to_rests() {
    std::size_t first = begin_;
    for (std::size_t i = begin_ + 1; i + 1 < points_.size(); ++i) {
        if (!corners_[i - 1].is_stop) continue;
        plan_stretch(first, i);
        first = i;
    }
    return first;
}

// The machine rests there, and all before it is planned.
void RecordProgram::rest_at(std::size_t point) {
    drop_points(point);
    begin_ = 0;
    is_open_ = false;
}

void RecordProgram::drop_points(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        note_gap_ways(limits_, points_[i].pulses, points_[i + 1].pulses, gap_ways_);
    points_.erase(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(count));
    ways_.erase(ways_.begin(), ways_.begin() + static_cast<std::ptrdiff_t>(count));
}

// Tubes of a stretch that goes on stay as they were.
void RecordProgram::look_at_spans() {
    if (!is_open_) set_limits();
    spans_ = path_spans(limits_, points_);
    set_paces();
    corners_ = path_corners(limits_, spans_, gap_ways_);
}

void RecordProgram::set_limits() {
    const double given_mm = tolerance_mm_ > 0.0 ? tolerance_mm_ : machine_.path_tolerance_mm;
    const double least_mm = kLeastTolerance * machine_.path_tolerance_mm;
    const double most_mm = kMostTolerances * machine_.path_tolerance_mm;
    limits_.path_tolerance_mm = std::clamp(given_mm, least_mm, most_mm);
    if (stretches_ && planned_tolerance_mm_ == limits_.path_tolerance_mm) return;
    planned_tolerance_mm_ = limits_.path_tolerance_mm;
    stretches_.emplace(limits_);
    stretches_->show(seen_);
}

void RecordProgram::plan_stretch(std::size_t first, std::size_t last) {
    pieces_.clear();
    if (last == first + 1) {
        Pulses4 way;
        for (std::size_t k = 0; k < kAxisCount; ++k)
            way[k] = points_[last].pulses[k] - points_[first].pulses[k];
        add_straight_stretch(limits_, spans_[first], way, static_cast<std::uint32_t>(last), pieces_);
        const PathSpan& span = spans_[first];
        if (seen_ != nullptr) seen_->push_back({{span.length, span.slope, span.slope, {}}, true});
    } else {
        stretches_->plan(points_, spans_, corners_, first, last, pieces_);
    }
    for (PathPiece& piece : pieces_) {
        if (piece.point != PathPiece::kNoPoint) piece.point -= static_cast<std::uint32_t>(first);
    }
    add_group(lines_of(first, last), 0);
}

std::vector<RecordPlace> RecordProgram::lines_of(std::size_t first, std::size_t last) const {
    std::vector<RecordPlace> lines;
    for (std::size_t i = first; i <= last; ++i) lines.push_back(ways_[i].place);
    return lines;
}

// The pieces as groups of blocks, each from rest to rest or joined to others, the last of them to one with a
// way in the material; `lines` by point.
void RecordProgram::add_group(std::span<const RecordPlace> lines, unsigned joints, bool feed_follows) {
    std::size_t begin = blocks_.size();
    std::size_t point = 1;
    for (const PathPiece& piece : pieces_) {
        MotionBlock& block = blocks_.emplace_back(path_block(machine_, piece));
        block.joints = static_cast<std::uint8_t>(joints);
        set_program_line(block, lines[point].line);
        set_program_sequence(block, lines[point].sequence);
        if (lines[point].is_rapid) block.way = cycle::WayKind::rapid;
        if (piece.point != PathPiece::kNoPoint && piece.point < lines.size()) {
            if (lines[piece.point].ends_line && !is_single_) block.ends_line = 1;
            if (piece.point + 1 < lines.size()) point = piece.point + 1;
        }
        if (!piece.rests && &piece != &pieces_.back()) continue;
        blocks_[begin].group_blocks = static_cast<std::uint32_t>(blocks_.size() - begin);
        const std::span run = std::span(blocks_).subspan(begin);
        note_gaps(machine_, run);
        note_feed_ahead(run, feed_follows && !piece.rests);
        begin = blocks_.size();
    }
}

}  // namespace psicarve::plan
