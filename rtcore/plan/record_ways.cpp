// SPDX-License-Identifier: GPL-3.0-or-later
// How the ways of a program become path points, and how fast they are passed.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "rtcore/plan/record_program.hpp"
#include "rtcore/plan/straight_stretch.hpp"
#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

// Of a way that takes longer at full speed than this, points are added near its ends: speeds change evenly
// between nodes, and there they change much.
constexpr double kLongWay_s = 0.03;
constexpr double kRampParts = 4.0;
constexpr double kRampsApart = 1.25;
// Whole numbers of a longer line would not fit.
constexpr std::int64_t kLongestWayPulses = std::int64_t{1} << 30;
// Of a way that takes longer at full speed, as turns of psi may, cuts to a quarter of a pulse would be
// without number: it is gone by itself, straight and from rest to rest.
constexpr double kLongestCurved_s = 300.0;
// Over so many pulses to each side a staircase of rounded points is compared with the way that the program
// has, and so much of the difference may be the rounding of the two ends alone.
constexpr double kPulsesAround = 16.0;
constexpr double kEndPulses = 1.0;
// Ways around it whose times by their lengths differ by more are no part of the same staircase.
constexpr double kPacesAlike = 3.0;
// Of a way that has hardly a length before rounding a pulse takes so many times as long as the way at most,
// and by that no longer than this.
constexpr double kMostStretch = 4096.0;
constexpr double kLongestStretched_s = 10.0;
// Of four axes no staircase is longer than that.
constexpr double kLeastPaceShare = 0.5;

std::int64_t longest_pulses(const Pulses4& from, const Pulses4& to) {
    std::int64_t longest = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) longest = std::max(longest, std::abs(to[k] - from[k]));
    return longest;
}

double seconds_along(const MachineLimits& limits, const Lanes& way) {
    double length2 = 0.0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double seconds = way[k] / limits.axes[k].speed_pps;
        length2 += seconds * seconds;
    }
    return std::sqrt(length2);
}

Lanes lanes_between(const Pulses4& from, const Pulses4& to) {
    Lanes way;
    for (std::size_t k = 0; k < kAxisCount; ++k) way[k] = static_cast<double>(to[k] - from[k]);
    return way;
}

double seconds_along(const MachineLimits& limits, const Pulses4& from, const Pulses4& to) {
    return seconds_along(limits, lanes_between(from, to));
}

// Of u: the way of one pulse, of the axis that is slowest by it.
double longest_pulse(const MachineLimits& limits) {
    double slowest_pps = limits.axes[0].speed_pps;
    for (const AxisMotion& axis : limits.axes) slowest_pps = std::min(slowest_pps, axis.speed_pps);
    return 1.0 / slowest_pps;
}

}  // namespace

// A step whose time is that of its way in pulses, at the pace of the way that the program has. A way without
// a pulse takes no time: what it asks for is a pace, and no other way's.
ProgramStep RecordProgram::at_the_programs_pace(const ProgramStep& step) {
    ProgramStep paced = step;
    const Lanes rounded = lanes_between(asked_pulses_, step.target_pulses);
    Lanes programmed = rounded;
    for (std::size_t k = 0; k < kAxisCount; ++k)
        programmed[k] += step.rounded_off_pulses[k] - rounded_off_pulses_[k];
    asked_pulses_ = step.target_pulses;
    rounded_off_pulses_ = step.rounded_off_pulses;
    if (step.kind == MotionKind::arc) return paced;
    const double rounded_s = seconds_along(limits_, rounded);
    const double programmed_s = seconds_along(limits_, programmed);
    if (rounded_s > 0.0) {
        const double stretched_s = step.seconds * std::min(rounded_s / programmed_s, kMostStretch);
        paced.seconds = std::min(stretched_s, std::max(step.seconds, kLongestStretched_s));
    } else {
        paced.seconds = 0.0;
    }
    // Between rests alone there are staircases; stepped ways are no part of any.
    if (step.shape == cycle::OrderShape::straight) longer_by_s_ += paced.seconds - step.seconds;
    return paced;
}

bool RecordProgram::is_very_long(const ProgramStep& step) const {
    const Pulses4& from = points_.back().pulses;
    return longest_pulses(from, step.target_pulses) > kLongestWayPulses ||
           seconds_along(limits_, from, step.target_pulses) > kLongestCurved_s;
}

void RecordProgram::take_very_long_way(const ProgramStep& step) {
    come_to_rest();
    const Pulses4 from = points_.back().pulses;
    const std::int64_t parts = longest_pulses(from, step.target_pulses) / kLongestWayPulses + 1;
    for (std::int64_t part = 1; part <= parts; ++part) {
        ProgramStep to = step;
        const double share = static_cast<double>(part) / static_cast<double>(parts);
        to.seconds = step.seconds / static_cast<double>(parts);
        to.tolerance_mm = 0.0;
        to.ends_block = step.ends_block && part == parts;
        for (std::size_t k = 0; k < kAxisCount && part < parts; ++k)
            to.target_pulses[k] =
                from[k] + round_to_pulse(share * static_cast<double>(step.target_pulses[k] - from[k]));
        add_way(to);
        come_to_rest();
    }
}

// Near its ends a long way gets points of its own, on the chord to half a pulse.
void RecordProgram::add_way(const ProgramStep& step) {
    const Pulses4 from = points_.back().pulses;
    const std::size_t first = points_.size();
    const Lanes way = lanes_between(from, step.target_pulses);
    const double length = seconds_along(limits_, way);
    std::vector<double> shares;
    if (step.tolerance_mm > 0.0 && length > kLongWay_s) {
        Lanes slope;
        for (std::size_t k = 0; k < kAxisCount; ++k) slope[k] = way[k] / length;
        const double ramp = 0.5 / accel_along_way(limits_, slope);
        const double apart = ramp / kRampParts;
        const double most = std::min(kRampsApart * ramp, 0.5 * length);
        for (int i = 1; i * apart < most; ++i) {
            const double at = i * apart;
            shares.push_back(at / length);
            shares.push_back(1.0 - at / length);
        }
    }
    std::sort(shares.begin(), shares.end());
    for (const double share : shares) {
        Pulses4 on_the_way;
        for (std::size_t k = 0; k < kAxisCount; ++k) on_the_way[k] = from[k] + round_to_pulse(way[k] * share);
        if (on_the_way != points_.back().pulses && on_the_way != step.target_pulses)
            points_.push_back({on_the_way, 0, 0, false});
    }
    points_.push_back({step.target_pulses, 0, 0, false});
    ways_.resize(points_.size(),
                 {{step.line, step.sequence, step.is_rapid, 0}, least_pace2(step, first), 0.0});
    ways_.back().place.marks = step.ends_block ? cycle::kEndsLine : 0;
    ways_.back().longer_by_s = std::exchange(longer_by_s_, 0.0);
}

// Along the way, points from `first` on, u passes at most as fast as its least time allows.
Timings RecordProgram::least_pace2(const ProgramStep& step, std::size_t first) const {
    double length = 0.0;
    for (std::size_t i = first; i < points_.size(); ++i)
        length += seconds_along(limits_, points_[i - 1].pulses, points_[i].pulses);
    const double pace = step.seconds / length;
    const double quickest = step.is_rapid ? 1.0 : 1.0 / kFeedFactor[1];
    return {pace * pace, quickest * quickest * pace * pace};
}

// Points a pulse or two apart lie on a staircase, which is longer than the way that the program has by up to
// 41 %. The curve hardly follows it, but u does: it passes so much faster. Not beyond where the program is
// much slower or quicker: what the staircase of a quick way is longer would make a slow way beside it
// quicker.
void RecordProgram::set_paces() {
    std::vector<double> pace;
    for (std::size_t i = 0; i < spans_.size(); ++i) pace.push_back(std::sqrt(ways_[i + 1].least_pace2[0]));
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        const double share = staircase_share(pace, i);
        for (std::size_t timing = 0; timing < kTimingCount; ++timing)
            spans_[i].least_pace2[timing] = share * share * ways_[i + 1].least_pace2[timing];
    }
}

// The time that the program asks for around a span, as a share of what its staircase takes there.
double RecordProgram::staircase_share(const std::vector<double>& pace, std::size_t span) const {
    const double pulse = longest_pulse(limits_);
    double most_pace = 0.0;
    double asked_s = 0.0;
    double longer_by_s = 0.0;
    const auto add = [&](std::size_t i) {
        if (pace[i] > kPacesAlike * pace[span] || pace[span] > kPacesAlike * pace[i]) return false;
        most_pace = std::max(most_pace, pace[i]);
        asked_s += pace[i] * spans_[i].length;
        longer_by_s += ways_[i + 1].longer_by_s;
        return true;
    };
    add(span);
    double length = 0.0;
    for (std::size_t i = span; i-- > 0 && length < kPulsesAround * pulse && add(i);)
        length += spans_[i].length;
    length = 0.0;
    for (std::size_t i = span + 1; i < spans_.size() && length < kPulsesAround * pulse && add(i); ++i)
        length += spans_[i].length;
    const double rounding_s = longer_by_s - kEndPulses * pulse * most_pace;
    return rounding_s > 0.0 ? std::max(kLeastPaceShare, 1.0 - rounding_s / asked_s) : 1.0;
}

}  // namespace psicarve::plan
