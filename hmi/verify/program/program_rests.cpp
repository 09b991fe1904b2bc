// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ProgramRule that knows of rests: which are those that the program asks for, how long they are,
// and what may have been gone along in them.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "hmi/verify/program/program_rule.hpp"

namespace psicarve::verify {
namespace {

constexpr std::int64_t kRestSlackTicks = 2;

}  // namespace

/// Rests that the program asks for are no time of the ways beside them: a spindle's spin-up would hide the
/// fastest of arcs.
void ProgramRule::note_rested(std::int64_t time_ns, bool spindle_on) noexcept {
    if (is_at_rest_) rested_ns_ += time_ns - seen_ns_;
    seen_ns_ = time_ns;
    is_at_rest_ = false;
    if (spindle_on == was_spindle_on_) return;
    was_spindle_on_ = spindle_on;
    if (spindle_on) spun_up_ns_ = time_ns + std::llround(profile_.job.spindle_spinup_s * 1e9);
    for (Live& way : window_)
        if (way.is_at_end && !way.switched_ns) way.switched_ns = time_ns;
}

/// Whether the path stands at an end that the program asks for a rest at, and is on no other way: not on the
/// way to there still, nor on one behind it since before, which only passes the place.
bool ProgramRule::rests_for_sure(const Positions& at) const noexcept {
    for (std::size_t n = 0; n < window_.size(); ++n) {
        const Live& way = window_[n];
        if (way.is_at_end && way.demand.asks_for_rest) {
            const auto passes = [&](const Live& later) {
                return later.is_on && later.came_ns < way.ended_ns;
            };
            return std::none_of(window_.begin() + static_cast<std::ptrdiff_t>(n) + 1, window_.end(), passes);
        }
        if (way.is_on && (may_go_on(way) || !is_near_end(way, at))) return false;
    }
    return false;
}

/// Which part of a way, from its begin, the path may go along without leaving the place. A line is gone
/// along to its end, or by its pulses.
double ProgramRule::near_share(const Live& way, const Positions& at) const noexcept {
    if (way.demand.way.is_arc()) return std::min(way.share[0], way.share[1]);
    return is_all_near(way, at) ? 1.0 : 0.0;
}

bool ProgramRule::is_all_near(const Live& way, const Positions& at) const noexcept {
    if (way.demand.is_exact) return false;
    for (std::size_t head = 0; head < kHeadCount; ++head) {
        const ProgrammedWay& along = way.demand.way;
        if (along.from_mm(along.from(), head, at, way.demand.slack_pulses) > tolerance_of(way).mm)
            return false;
        if (along.from_mm(along.to(), head, at, way.demand.slack_pulses) > tolerance_of(way).mm) return false;
    }
    return true;
}

/// The same, up to their ends, of ways that lead to where the path rests now, if it does.
void ProgramRule::note_hidden(const Positions& at) noexcept {
    std::size_t leading = 0;
    double dwells_s = 0.0;
    for (std::size_t n = 0; n < window_.size(); ++n) {
        if (!window_[n].is_at_end) continue;
        leading = n + 1;
        if (window_[n].passes == 0) dwells_s += window_[n].demand.dwell_s;
    }
    for (std::size_t n = 0; n < leading; ++n) {
        Live& way = window_[n];
        if (!way.is_on) continue;
        if (way.is_at_end) way.dwells_s = dwells_s + (way.passes > 0 ? way.demand.dwell_s : 0.0);
        double share = is_all_near(way, at) ? 1.0 : 0.0;
        if (way.demand.way.is_arc())
            share = 1.0 - std::max(way.reach[0].front().least, way.reach[1].front().least);
        way.hidden_end = std::max(way.hidden_end, share);
    }
}

/// Whether the path may leave the end to the pulse and still be on the way: on arcs so small that it may not
/// have come far, or may have turns to go.
bool ProgramRule::may_go_on(const Live& way) const noexcept {
    if (!way.is_on || !way.demand.way.is_arc()) return false;
    for (std::size_t head = 0; head < kHeadCount; ++head) {
        const double left = 1.0 - way.reach[head].front().least;
        const ProgrammedWay& along = way.demand.way;
        if (left < 0.5 && left <= along.back_share(head, along.end_pulses(), tolerance_of(way))) return false;
    }
    return true;
}

/// The same where it ends at rest. `comes`: it may begin only now, where it is short.
bool ProgramRule::note_rest(Live& way, std::int64_t time_ns, const Positions& at, bool comes) {
    std::int64_t off = 0;
    int axes = 0;
    Axis axis = Axis::r1;
    for (const Axis other : kAllAxes) {
        const std::int64_t pulses =
            std::abs(at[index_of(other)] - way.demand.way.end_pulses()[index_of(other)]);
        if (pulses > 0) ++axes;
        if (pulses <= off) continue;
        off = pulses;
        axis = other;
    }
    const bool is_there = way.is_on && has_come(way);
    if (is_there && std::pair{off, axes} <= std::pair{way.nearest_pulses, way.nearest_axes}) {
        way.nearest_pulses = off;
        way.nearest_axes = axes;
        way.nearest_axis = axis;
    }
    const bool was_at_end = std::exchange(way.is_at_end, is_there && off == 0);
    if (way.is_at_end && !was_at_end) {
        way.ended_ns = time_ns;
        way.done_ns = work_ns(time_ns);
        way.has_gone_on = false;
        way.switched_ns.reset();
    }
    if (was_at_end && !way.is_at_end) {
        way.rested_ns = std::max(way.rested_ns, time_ns - way.ended_ns);
        way.has_gone_on = may_go_on(way) || (comes && way.is_on);
        if (way.has_gone_on)
            ++way.passes;
        else
            way.is_on = false;
    }
    return way.is_at_end;
}

bool ProgramRule::is_too_short(const Live& way, std::int64_t rested_ns) const noexcept {
    return seconds_from_ns(rested_ns + kRestSlackTicks * tick_ns_) < way.demand.dwell_s;
}

/// The path leaves the end of a way before its dwell is over: it only passed it, if it may be on any other
/// way. `is_on_before`: on one before it.
bool ProgramRule::leaves_too_soon(std::size_t n, std::int64_t time_ns, bool is_on_before) {
    const Live& way = window_[n];
    if (!is_too_short(way, time_ns - way.ended_ns)) return false;
    const auto passes = [&](const Live& later) { return later.is_on && later.came_ns < way.ended_ns; };
    if (is_on_before || way.has_gone_on ||
        std::any_of(window_.begin() + static_cast<std::ptrdiff_t>(n) + 1, window_.end(), passes))
        return true;
    judge_rest(way, time_ns);
    return false;
}

/// The path was at an end up to the way n, and not for as long as the program has it rest there.
const ProgramRule::Live* ProgramRule::short_rest_at(std::size_t n) const noexcept {
    for (std::size_t k = 0; k <= n; ++k)
        if (window_[k].rested_ns > 0 && is_too_short(window_[k], window_[k].rested_ns)) return &window_[k];
    return nullptr;
}

/// What came to be on a way at a rest that was none did not.
void ProgramRule::take_back(Live& way, std::int64_t since_ns) noexcept {
    if (!way.is_on || way.came_ns < since_ns) return;
    way.is_on = false;
    way.is_at_end = false;
    if (way.begun_at_ns >= since_ns) way.begun_ns.reset();
}

/// How much of the rest at a way's end the program does not ask for: until the spindle is switched, or
/// besides its dwells. How long other rests are is not known.
double ProgramRule::free_rest_s(const Live& way) const noexcept {
    if (way.switched_ns) return seconds_from_ns(*way.switched_ns - way.ended_ns);
    return std::max(seconds_from_ns(way.rested_ns) - way.dwells_s, 0.0);
}

/// The same for the ways behind it: once the spindle, if it was switched, has come to its speed.
double ProgramRule::free_rest_behind_s(const Live& way) const noexcept {
    if (!way.switched_ns) return free_rest_s(way);
    const std::int64_t left_ns = way.ended_ns + way.rested_ns;
    return seconds_from_ns(std::max<std::int64_t>(left_ns - std::max(spun_up_ns_, *way.switched_ns), 0));
}

void ProgramRule::judge_rest(const Live& way, std::int64_t time_ns) {
    if (!is_too_short(way, way.rested_ns) || !log_.count(1, time_ns)) return;
    report(time_ns, short_rest(way), way.demand.line);
}

Offence ProgramRule::short_rest(const Live& way) const {
    Offence offence;
    offence.fault = "dwell";
    offence.measured = seconds_from_ns(way.rested_ns);
    offence.allowed = way.demand.dwell_s;
    offence.bound = Bound::at_least;
    offence.unit = "s";
    offence.sentence = "the rest behind a way is too short";
    return offence;
}

}  // namespace psicarve::verify
