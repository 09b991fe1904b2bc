// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/path_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

constexpr double kLineErrorPulses = 0.25;
// Cut on the chord, a segment is half a pulse from the curve already.
constexpr double kLineErrorOnChordPulses = 0.1;
// Within a bit the curve is taken as straight.
constexpr double kBitErrorPulses = 0.25;
// A segment's u is stretched so that its time and its end speeds are the curve's; by so much at most.
constexpr double kMostStretch = 0.02;
// So much less time than the curve a segment may take at twice the feed, where axes are at their limits.
constexpr double kMostHaste = 0.0005;

std::size_t longest_axis(const Pulses4& line_pulses) {
    std::size_t longest = 0;
    for (std::size_t k = 1; k < kAxisCount; ++k) {
        if (std::abs(line_pulses[k]) > std::abs(line_pulses[longest])) longest = k;
    }
    return longest;
}

/// Where the line's DDA is after so many iterations.
Pulses4 along_line(const Pulses4& from, const Pulses4& line_pulses, std::int64_t iterations) {
    const std::int64_t capacity = std::abs(line_pulses[longest_axis(line_pulses)]);
    Pulses4 pulses = from;
    if (capacity == 0) return pulses;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const std::int64_t count = (capacity / 2 + iterations * std::abs(line_pulses[k])) / capacity;
        pulses[k] += line_pulses[k] < 0 ? -count : count;
    }
    return pulses;
}

}  // namespace

std::size_t bits_in(const PathCell& cell, double length) {
    double bend = 0.0;
    for (const double of_axis : cell.bend) bend = std::max(bend, std::abs(of_axis));
    const double error_pulses = bend * length * length / 8.0;
    if (error_pulses <= kBitErrorPulses) return 1;
    return static_cast<std::size_t>(std::ceil(std::sqrt(error_pulses / kBitErrorPulses)));
}

PieceMaker::PieceMaker(const MachineLimits& limits, std::span<const PathPoint> points,
                       std::uint32_t first_point, const Lanes& start, std::vector<PathPiece>& pieces)
    : limits_(limits),
      points_(points),
      pieces_(pieces),
      at_pulses_(points[first_point].pulses),
      last_point_(first_point),
      heads_are_coarse_(heads_are_coarse(limits)),
      rounds_corners_(rounds_corners(limits)) {
    load(start, bits_begin_);
}

void PieceMaker::begin_cell(const PathCell& cell, const Lanes& at, const Timings& begin2, const Timings& end2,
                            const std::array<double, 2>& rest2) {
    cell_ = &cell;
    cell_at_ = at;
    begin2_ = begin2;
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        rise2_[timing] = (end2[timing] - begin2[timing]) / cell.length;
    }
    rest_begin2_ = rest2[0];
    rest_rise2_ = (rest2[1] - rest2[0]) / cell.length;
}

void PieceMaker::add(double from, double to, std::uint32_t point) {
    const double length = to - from;
    const std::size_t count = bits_in(*cell_, length);
    const double share = 1.0 / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double begin = from + length * (static_cast<double>(i) * share);
        add_bit(begin, i + 1 == count ? to : from + length * (static_cast<double>(i + 1) * share));
    }
    if (point != PathPiece::kNoPoint) flush(point);
}

PSICARVE_FOR_WIDE_REGISTERS
void PieceMaker::add_bit(double from, double to) {
    const bool is_first = bits_.empty();
    const Vec begin = is_first ? bits_begin_ : bits_.back().end;
    const double begin_along = is_first ? 0.0 : bits_.back().along;
    Bit& bit = bits_.emplace_back();
    bit.length = to - from;
    bit.along = begin_along + bit.length;
    bit.rest_speed2 = {rest_begin2_ + from * rest_rise2_, rest_begin2_ + to * rest_rise2_};
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        bit.begin_speed2[timing] = begin2_[timing] + from * rise2_[timing];
        bit.end_speed2[timing] = begin2_[timing] + to * rise2_[timing];
    }
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        bit.begin_speed[timing] = std::sqrt(bit.begin_speed2[timing]);
        bit.end_speed[timing] = std::sqrt(bit.end_speed2[timing]);
        bit.seconds[timing] = 2.0 * bit.length / (bit.begin_speed[timing] + bit.end_speed[timing]);
    }
    if (has_rest())
        bit.rest_seconds = 2.0 * bit.length / (std::sqrt(bit.rest_speed2[0]) + std::sqrt(bit.rest_speed2[1]));
    Vec at, slope, bend;
    load(cell_at_, at);
    load(cell_->slope_begin, slope);
    load(cell_->bend, bend);
    bit.end = at + to * (slope + 0.5 * to * bend);
    // Half its time takes it so far.
    const double share =
        0.25 * (3.0 * bit.begin_speed[0] + bit.end_speed[0]) / (bit.begin_speed[0] + bit.end_speed[0]);
    bit.middle = begin + share * (bit.end - begin);
    const Vec begin_slope = slope + from * bend;
    const Vec end_slope = slope + to * bend;
    bit.slope = begin_slope < 0.0 ? -begin_slope : begin_slope;
    raise_to(bit.slope, Vec(end_slope < 0.0 ? -end_slope : end_slope));
    bit.bend = bend < 0.0 ? -bend : bend;
}

void PieceMaker::flush(std::uint32_t point) {
    std::size_t first = 0;
    while (first < bits_.size()) {
        const std::size_t end = longest(first);
        const bool reaches = end == bits_.size();
        const std::int64_t done = line_done(point);
        // Where corners are rounded the curve is in the point only where it rests.
        const bool is_in_point = reaches && !rounds_corners_;
        add_piece(first, end, is_in_point ? points_[point].pulses : cut_at(end, point),
                  reaches ? point : PathPiece::kNoPoint);
        if (is_cut_on_line(point)) {
            pieces_.back().line_pulses = line_to(point);
            pieces_.back().line_done = done;
        }
        first = end;
    }
    last_point_ = point;
    bits_begin_ = bits_.back().end;
    bits_.clear();
}

// The table, and axes that have backlash, never turn back between two points for a pulse. Between layers Y
// does not either, which would take a head back into the layer it has left, and a head is never further in
// than at both ends.
void PieceMaker::keep_way(std::uint32_t point, Pulses4& pulses) const {
    const PathPoint& from = points_[last_point_];
    const PathPoint& to = points_[point];
    const bool is_link = is_between_layers(from, to);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (is_link && k < 2) pulses[k] = std::max(pulses[k], std::min(from.pulses[k], to.pulses[k]));
        const bool goes_one_way =
            (k == index_of(Axis::psi) && !rounds_corners_) || (is_link && k == index_of(Axis::y));
        if (!goes_one_way && limits_.tick.axes[k].backlash_pulses == 0) continue;
        pulses[k] = std::clamp(pulses[k], std::min(at_pulses_[k], to.pulses[k]),
                               std::max(at_pulses_[k], to.pulses[k]));
    }
    if (limits_.is_program) return keep_travel(from.pulses, to.pulses, pulses);
    if (!is_link) keep_height(from.pulses, to.pulses, pulses);
}

// Where the curve leans beyond an end that stands at a limit.
void PieceMaker::keep_travel(const Pulses4& from, const Pulses4& to, Pulses4& pulses) const {
    const cycle::SoftLimits& soft = limits_.tick.soft_limits;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        std::int64_t least = soft.least_pulses[k];
        if (k < soft.core_pulses.size()) least = std::max(least, soft.core_pulses[k]);
        pulses[k] = std::clamp(pulses[k], std::min({least, from[k], to[k]}),
                               std::max({soft.most_pulses[k], from[k], to[k]}));
    }
    keep_tips_apart(from, to, pulses);
}

// RecordRules has looked at ends alone. Between two cuts one head may go in and the other out: by half a
// pulse of each both are closer there than at either cut. Where an end has no such half pulses to give,
// neither head goes further in than at the ends.
void PieceMaker::keep_tips_apart(const Pulses4& from, const Pulses4& to, Pulses4& pulses) const {
    const cycle::SoftLimits& soft = limits_.tick.soft_limits;
    const auto sum_mm = [&soft](const Pulses4& at) {
        return soft.mm_per_pulse[0] * static_cast<double>(at[0]) +
               soft.mm_per_pulse[1] * static_cast<double>(at[1]);
    };
    const double needed_mm = tips_need_mm(soft);
    const double ends_mm = std::min(sum_mm(from), sum_mm(to));
    if (ends_mm < needed_mm) {
        for (std::size_t k = 0; k < kHeads; ++k) pulses[k] = std::max(pulses[k], std::min(from[k], to[k]));
    }
    const double missing_mm = std::min(needed_mm, ends_mm) - sum_mm(pulses);
    if (missing_mm <= 0.0) return;
    // A head that has backlash would turn round by it; the other one, if there is one without, gives way
    // alone.
    const auto& axes = limits_.tick.axes;
    const bool is_shared = (axes[0].backlash_pulses > 0) == (axes[1].backlash_pulses > 0);
    for (std::size_t k = 0; k < kHeads; ++k) {
        if (!is_shared && axes[k].backlash_pulses > 0) continue;
        const double part_mm = is_shared ? 0.5 * missing_mm : missing_mm;
        pulses[k] += static_cast<std::int64_t>(std::ceil(part_mm / soft.mm_per_pulse[k]));
    }
}

// Along a layer Y goes where the curve has it, but only so far from the straight way over psi that the DDA's
// half pulses of both keep it within the tolerance and a pulse of the way, psi being known to a pulse.
void PieceMaker::keep_height(const Pulses4& from, const Pulses4& to, Pulses4& pulses) const {
    const auto rise = static_cast<double>(to[kY] - from[kY]);
    const auto turn = static_cast<double>(to[kPsi] - from[kPsi]);
    const double slope = turn == 0.0 ? 0.0 : rise / turn;
    const double way = static_cast<double>(from[kY]) + slope * static_cast<double>(pulses[kPsi] - from[kPsi]);
    const double off = 0.5 + 0.5 * std::abs(slope) + (rise == 0.0 ? 0.0 : height_tolerance_pulses(limits_));
    const auto least = static_cast<std::int64_t>(std::ceil(way - off));
    const auto most = static_cast<std::int64_t>(std::floor(way + off));
    pulses[kY] = std::clamp(pulses[kY], least, most);
    pulses[kY] = std::clamp(pulses[kY], std::min(at_pulses_[kY], to[kY]), std::max(at_pulses_[kY], to[kY]));
}

bool PieceMaker::is_cut_on_line(std::uint32_t point) const {
    return heads_are_coarse_ && !is_between_layers(points_[last_point_], points_[point]);
}

Pulses4 PieceMaker::line_to(std::uint32_t point) const {
    Pulses4 line;
    for (std::size_t k = 0; k < kAxisCount; ++k)
        line[k] = points_[point].pulses[k] - points_[last_point_].pulses[k];
    return line;
}

/// Its DDA's iterations that are in pieces already.
std::int64_t PieceMaker::line_done(std::uint32_t point) const {
    const std::size_t longest = longest_axis(line_to(point));
    return std::abs(at_pulses_[longest] - points_[last_point_].pulses[longest]);
}

Pulses4 PieceMaker::cut_at(std::size_t end, std::uint32_t point) const {
    Pulses4 pulses;
    for (std::size_t k = 0; k < kAxisCount; ++k) pulses[k] = round_to_pulse(bits_[end - 1].end[k]);
    const Pulses4& from = points_[last_point_].pulses;
    const Pulses4& to = points_[point].pulses;
    const double share = bits_[end - 1].along / bits_.back().along;
    if (is_cut_on_line(point)) {
        const Pulses4 line = line_to(point);
        const std::int64_t capacity = std::abs(line[longest_axis(line)]);
        const std::int64_t way = round_to_pulse(static_cast<double>(capacity) * share);
        return along_line(from, line, std::clamp(way, line_done(point), capacity));
    }
    if (!cuts_follow_table(limits_, greatest_radii_mm(limits_, from, to))) {
        const auto way = static_cast<double>(to[kPsi] - from[kPsi]);
        pulses[kPsi] = from[kPsi] + round_to_pulse(way * share);
    }
    keep_way(point, pulses);
    return pulses;
}

std::size_t PieceMaker::longest(std::size_t first) {
    const std::size_t most = std::min(bits_.size(), first + kMostBitsInALine);
    Together together{};
    for (std::size_t i = first; i < most; ++i) {
        for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
            together.seconds[timing] += bits_[i].seconds[timing];
        }
        together.rest_seconds += bits_[i].rest_seconds;
        together.length += bits_[i].length;
        together_[i - first] = together;
    }
    for (std::size_t end = most; end > first + 1; --end) {
        if (is_straight(first, end)) return end;
    }
    return first + 1;
}

// At 100 % its u is stretched until it takes as long as the curve. At twice the feed, and on the way to a
// rest, it may take longer, but not less: axes may be at their limits there.
bool PieceMaker::set_line(std::size_t first, std::size_t end, std::size_t timing, Line& line) const {
    const Together& together = together_[end - 1 - first];
    const double mean_speed = 0.5 * (bits_[first].begin_speed[0] + bits_[end - 1].end_speed[0]);
    const double length = mean_speed * together.seconds[0];
    if (timing == 0 && std::abs(length - together.length) > kMostStretch * together.length) return false;
    line = line_of(length, bits_[first].begin_speed[timing], bits_[end - 1].end_speed[timing],
                   together.seconds[timing]);
    if (timing == 0) line.time_share = 1.0;
    return timing == 0 || line.time_share >= 1.0 - kMostHaste;
}

bool PieceMaker::set_rest_line(std::size_t first, std::size_t end, Line& line) const {
    const Together& together = together_[end - 1 - first];
    const double mean_speed = 0.5 * (bits_[first].begin_speed[0] + bits_[end - 1].end_speed[0]);
    line = line_of(mean_speed * together.seconds[0], std::sqrt(bits_[first].rest_speed2[0]),
                   std::sqrt(bits_[end - 1].rest_speed2[1]), together.rest_seconds);
    return line.time_share >= 1.0 - kMostHaste;
}

PieceMaker::Line PieceMaker::line_of(double length, double speed, double end_speed, double bits_seconds) {
    const double seconds = 2.0 * length / (speed + end_speed);
    return {speed, 0.5 * (end_speed - speed) / seconds, 1.0 / length, seconds / bits_seconds};
}

// Compared at the bits' middles and ends, at the instants at which the curve is there: in a bit the
// difference is a parabola.
PSICARVE_FOR_WIDE_REGISTERS
bool PieceMaker::is_straight(std::size_t first, std::size_t end) {
    const Vec from = first > 0 ? bits_[first - 1].end : bits_begin_;
    const Vec way = bits_[end - 1].end - from;
    const double most_error = heads_are_coarse_ ? kLineErrorOnChordPulses : kLineErrorPulses;
    std::array<Line, kTimingCount> lines{};
    const bool is_one = together_[end - 1 - first].seconds[0] == together_[end - 1 - first].seconds[1];
    if (!set_line(first, end, 0, lines[0]) || (!is_one && !set_line(first, end, 1, lines[1]))) return false;
    Line rest{};
    if (has_rest() && !set_rest_line(first, end, rest)) return false;
    const auto raise_error = [&](const Line& line, double seconds, const Vec& at, Vec& error)
        __attribute__((always_inline)) {
        const double after = seconds * line.time_share;
        const double share = after * (line.speed + line.half_accel * after) * line.inverse_length;
        const Vec off = at - (from + share * way);
        raise_to(error, Vec(off < 0.0 ? -off : off));
    };
    const auto is_near = [&](std::size_t i) __attribute__((always_inline)) {
        const Bit& bit = bits_[i];
        const Timings seconds = i > first ? together_[i - 1 - first].seconds : Timings{};
        const double rest_seconds = i > first ? together_[i - 1 - first].rest_seconds : 0.0;
        Vec error{};
        raise_error(lines[0], seconds[0] + 0.5 * bit.seconds[0], bit.middle, error);
        raise_error(lines[0], seconds[0] + bit.seconds[0], bit.end, error);
        if (!is_one) raise_error(lines[1], seconds[1] + bit.seconds[1], bit.end, error);
        if (has_rest()) raise_error(rest, rest_seconds + bit.rest_seconds, bit.end, error);
        return greatest_of(error) <= most_error;
    };
    // What was off a longer line is likely to be off this one.
    if (worst_ >= first && worst_ < end && !is_near(worst_)) return false;
    for (std::size_t i = first; i < end; ++i) {
        if (is_near(i)) continue;
        worst_ = i;
        return false;
    }
    return true;
}

PSICARVE_FOR_WIDE_REGISTERS
void PieceMaker::add_piece(std::size_t first, std::size_t end, const Pulses4& to, std::uint32_t point) {
    PathPiece& piece = pieces_.emplace_back();
    piece.point = point;
    const double seconds = together_[end - 1 - first].seconds[0];
    const double length = together_[end - 1 - first].length;
    Vec slope{}, bend{};
    for (std::size_t i = first; i < end; ++i) {
        raise_to(slope, bits_[i].slope);
        raise_to(bend, bits_[i].bend);
    }
    for (std::size_t k = 0; k < kAxisCount; ++k) piece.delta_pulses[k] = to[k] - at_pulses_[k];
    at_pulses_ = to;
    piece.begin_speed2 = bits_[first].begin_speed2;
    piece.end_speed2 = bits_[end - 1].end_speed2;
    piece.rest_speed2 = {bits_[first].rest_speed2[0], bits_[end - 1].rest_speed2[1]};
    piece.length = 0.5 * seconds * (bits_[first].begin_speed[0] + bits_[end - 1].end_speed[0]);
    // In stretched u slopes are as much flatter.
    const double stretch = length / piece.length;
    store(Vec(slope * stretch), piece.slope);
    store(Vec(bend * (stretch * stretch)), piece.bend);
}

}  // namespace psicarve::plan
