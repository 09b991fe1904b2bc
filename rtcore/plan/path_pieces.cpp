// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/path_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "shared/units.hpp"

namespace psicarve::plan {
namespace {

constexpr double kLineErrorPulses = 0.25;
// Within a bit the curve is taken as straight.
constexpr double kBitErrorPulses = 0.25;
// A segment's u is stretched so that its time and its end speeds are the curve's; by so much at most.
constexpr double kMostStretch = 0.05;
// So many segments of unequal length are tried before a point's way is cut bit by bit.
constexpr std::size_t kMostBitsInALine = 16;

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
    return static_cast<std::size_t>(std::max(1.0, std::ceil(std::sqrt(error_pulses / kBitErrorPulses))));
}

PieceMaker::PieceMaker(const MachineLimits& limits, std::span<const PathPoint> points,
                       std::uint32_t first_point, const Lanes& start, std::vector<PathPiece>& pieces)
    : limits_(limits),
      points_(points),
      pieces_(pieces),
      at_pulses_(points[first_point].pulses),
      last_point_(first_point),
      bits_begin_(start) {}

void PieceMaker::begin_cell(const PathCell& cell, const Lanes& at, const Timings& begin2,
                            const Timings& end2) {
    cell_ = &cell;
    cell_at_ = at;
    begin2_ = begin2;
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        rise2_[timing] = (end2[timing] - begin2[timing]) / cell.length;
    }
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

void PieceMaker::add_bit(double from, double to) {
    Bit bit{};
    bit.length = to - from;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double bend = cell_->bend[k];
        bit.end[k] = cell_at_[k] + to * (cell_->slope_begin[k] + 0.5 * to * bend);
        bit.slope[k] = std::max(std::abs(cell_->slope_begin[k] + from * bend),
                                std::abs(cell_->slope_begin[k] + to * bend));
        bit.bend[k] = std::abs(bend);
    }
    for (std::size_t timing = 0; timing < kTimingCount; ++timing) {
        bit.begin_speed2[timing] = begin2_[timing] + from * rise2_[timing];
        bit.end_speed2[timing] = begin2_[timing] + to * rise2_[timing];
    }
    bit.begin_speed = std::sqrt(bit.begin_speed2[0]);
    bit.end_speed = std::sqrt(bit.end_speed2[0]);
    bit.seconds = 2.0 * bit.length / (bit.begin_speed + bit.end_speed);
    bits_.push_back(bit);
}

void PieceMaker::flush(std::uint32_t point) {
    std::size_t first = 0;
    while (first < bits_.size()) {
        const std::size_t end = longest(first);
        const bool reaches = end == bits_.size();
        const std::int64_t done = line_done(point);
        add_piece(first, end, reaches ? points_[point].pulses : cut_at(end, point),
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
        const bool goes_one_way = k == index_of(Axis::psi) || (is_link && k == index_of(Axis::y));
        if (!goes_one_way && limits_.tick.axes[k].backlash_pulses == 0) continue;
        pulses[k] = std::clamp(pulses[k], std::min(at_pulses_[k], to.pulses[k]),
                               std::max(at_pulses_[k], to.pulses[k]));
    }
    if (is_link) return;
    // Along a layer Y is where the table is on its straight way to the point.
    constexpr std::size_t kPsi = index_of(Axis::psi);
    constexpr std::size_t kY = index_of(Axis::y);
    const auto rise = static_cast<double>(to.pulses[kY] - from.pulses[kY]);
    const auto turn = static_cast<double>(to.pulses[kPsi] - from.pulses[kPsi]);
    const auto turned = static_cast<double>(pulses[kPsi] - from.pulses[kPsi]);
    pulses[kY] = from.pulses[kY] + (turn == 0.0 ? 0 : round_to_pulse(rise * turned / turn));
}

bool PieceMaker::is_cut_on_line(std::uint32_t point) const {
    return heads_are_coarse(limits_) && !is_between_layers(points_[last_point_], points_[point]);
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
    constexpr std::size_t kPsi = index_of(Axis::psi);
    Pulses4 pulses;
    for (std::size_t k = 0; k < kAxisCount; ++k) pulses[k] = round_to_pulse(bits_[end - 1].end[k]);
    const Pulses4& from = points_[last_point_].pulses;
    const Pulses4& to = points_[point].pulses;
    if (is_cut_on_line(point)) {
        const Pulses4 line = line_to(point);
        const std::size_t longest = longest_axis(line);
        const std::int64_t way =
            line[longest] < 0 ? from[longest] - pulses[longest] : pulses[longest] - from[longest];
        return along_line(from, line, std::clamp(way, line_done(point), std::abs(line[longest])));
    }
    keep_way(point, pulses);
    if (cuts_follow_table(limits_, greatest_radii_mm(limits_, from, to))) return pulses;
    double length = 0.0;
    double part = 0.0;
    for (std::size_t i = 0; i < bits_.size(); ++i) {
        length += bits_[i].length;
        if (i < end) part = length;
    }
    const auto way = static_cast<double>(to[kPsi] - from[kPsi]);
    pulses[kPsi] = from[kPsi] + round_to_pulse(way * part / length);
    keep_way(point, pulses);
    return pulses;
}

std::size_t PieceMaker::longest(std::size_t first) const {
    const std::size_t most = std::min(bits_.size(), first + kMostBitsInALine);
    for (std::size_t end = most; end > first + 1; --end) {
        if (is_straight(first, end)) return end;
    }
    return first + 1;
}

// Compared at the bits' middles and ends, at the instants at which the curve is there: in a bit the
// difference is a parabola.
bool PieceMaker::is_straight(std::size_t first, std::size_t end) const {
    const Lanes& from = first > 0 ? bits_[first - 1].end : bits_begin_;
    const Lanes& to = bits_[end - 1].end;
    double seconds = 0.0;
    double length = 0.0;
    for (std::size_t i = first; i < end; ++i) {
        seconds += bits_[i].seconds;
        length += bits_[i].length;
    }
    const double begin_speed = bits_[first].begin_speed;
    const double end_speed = bits_[end - 1].end_speed;
    const double mean_speed = 0.5 * (begin_speed + end_speed);
    if (std::abs(mean_speed * seconds - length) > kMostStretch * length) return false;
    const double half_accel = 0.5 * (end_speed - begin_speed) / seconds;
    const auto is_near = [&](double at_seconds, const Lanes& at) {
        const double share = at_seconds * (begin_speed + half_accel * at_seconds) / (mean_speed * seconds);
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if (std::abs(at[k] - (from[k] + share * (to[k] - from[k]))) > kLineErrorPulses) return false;
        }
        return true;
    };
    double at_seconds = 0.0;
    for (std::size_t i = first; i < end; ++i) {
        const Bit& bit = bits_[i];
        const Lanes& begin = i > 0 ? bits_[i - 1].end : bits_begin_;
        // Half its time takes it so far.
        const double share =
            0.25 * (3.0 * bit.begin_speed + bit.end_speed) / (bit.begin_speed + bit.end_speed);
        Lanes middle;
        for (std::size_t k = 0; k < kAxisCount; ++k) middle[k] = begin[k] + share * (bit.end[k] - begin[k]);
        if (!is_near(at_seconds + 0.5 * bit.seconds, middle)) return false;
        at_seconds += bit.seconds;
        if (!is_near(at_seconds, bit.end)) return false;
    }
    return true;
}

void PieceMaker::add_piece(std::size_t first, std::size_t end, const Pulses4& to, std::uint32_t point) {
    PathPiece piece{};
    piece.point = point;
    double seconds = 0.0;
    double length = 0.0;
    for (std::size_t i = first; i < end; ++i) {
        seconds += bits_[i].seconds;
        length += bits_[i].length;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            piece.slope[k] = std::max(piece.slope[k], bits_[i].slope[k]);
            piece.bend[k] = std::max(piece.bend[k], bits_[i].bend[k]);
        }
    }
    for (std::size_t k = 0; k < kAxisCount; ++k) piece.delta_pulses[k] = to[k] - at_pulses_[k];
    at_pulses_ = to;
    piece.begin_speed2 = bits_[first].begin_speed2;
    piece.end_speed2 = bits_[end - 1].end_speed2;
    piece.length = 0.5 * seconds * (bits_[first].begin_speed + bits_[end - 1].end_speed);
    // In stretched u slopes are as much flatter.
    const double stretch = length / piece.length;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        piece.slope[k] *= stretch;
        piece.bend[k] *= stretch * stretch;
    }
    pieces_.push_back(piece);
}

}  // namespace psicarve::plan
