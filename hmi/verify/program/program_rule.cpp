// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/program/program_rule.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace psicarve::verify {
namespace {

/// No more ways are followed at once: they would all have to lie within one tolerance.
constexpr std::size_t kMostWays = 4096;
/// After a breach the path is looked for on so many of the next ways, now and then.
constexpr std::size_t kWaysAhead = 32;
constexpr std::uint64_t kLookEvery = 16;
constexpr double kRounding_mm = 1e-9;

}  // namespace

ProgramRule::ProgramRule(JudgedProgram program, const Profile& profile, OffenceLog& log)
    : program_(std::move(program)), profile_(profile), scale_(profile), log_(log) {
    log_.set_judged(1);
}

void ProgramRule::begin(const TraceStart& start) {
    tick_ns_ = start.period_ns;
    present_ = start.present;
    this->start(start.position_pulses);
}

void ProgramRule::start(const Positions& positions) {
    start_ = at_ = positions;
    told_switches_ = 0;
    ways_.reset();
    window_.clear();
    place_ = {};
    phase_ = Phase::waiting;
    ways_done_ = 0;
    stretch_ = {};
    gathered_.reset();
    lowered_.clear();
    lowered_s_ = 0.0;
    lowered_count_ = 0;
    times_ = {};
    way_over_ns_ = 0;
    is_way_from_rest_ = true;
    seen_ns_ = rested_ns_ = spun_up_ns_ = 0;
    is_at_rest_ = was_spindle_on_ = false;
    rest_before_s_ = INFINITY;
    bounds_ = {positions, positions};
    most_off_mm_ = 0.0;
}

/// What homing did was no program.
void ProgramRule::redefine(std::int64_t, const Positions& positions) {
    RuleResult none;
    none.judged = true;
    log_.restore(1, none);
    start(positions);
}

/// The way n behind the window's first; nothing: there is none.
ProgramRule::Live* ProgramRule::live(std::size_t n) {
    while (window_.size() <= n) {
        auto next = ways_->next();
        if (!next) return nullptr;
        window_.emplace_back(*next);
    }
    return &window_[n];
}

WayTolerance ProgramRule::tolerance_of(const Live& way) const noexcept {
    return {way.demand.tolerance_mm + kRounding_mm, way.demand.slack_pulses};
}

void ProgramRule::settle(std::int64_t time_ns, const Positions& positions, SignalWord levels) {
    const bool spindle_on = (levels & bit_of(Signal::spindle)) != 0;
    was_spindle_off_ = !spindle_on || (was_spindle_off_ && (phase_ == Phase::over || positions == at_));
    if (phase_ == Phase::over) return;
    if (phase_ == Phase::waiting) {
        was_spindle_on_ = spindle_on;
        if (positions == start_) return;
        ways_ = std::make_unique<WayReader>(program_, profile_, scale_, start_);
        phase_ = Phase::running;
        left_ns_ = last_ns_ = seen_ns_ = time_ns;
        if (Live* first = live(0)) {
            begin_way(*first, time_ns);
            first->is_on = true;
            follow(time_ns, start_, true);
            if (phase_ == Phase::running && !window_.empty()) window_.front().is_waiting = true;
        }
    }
    note_rested(time_ns, spindle_on);
    if (phase_ == Phase::lost) find_again(time_ns, positions);
    if (phase_ != Phase::running) return;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        bounds_.least_pulses[k] = std::min(bounds_.least_pulses[k], positions[k]);
        bounds_.most_pulses[k] = std::max(bounds_.most_pulses[k], positions[k]);
    }
    follow(time_ns, positions);
    at_ = positions;
    if (phase_ == Phase::running) judge_switches(time_ns, levels);
}

/// At the end of the way before. It may have begun earlier, too.
void ProgramRule::begin_way(Live& way, std::int64_t time_ns) {
    if (!way.begun_ns) {
        way.begun_ns = work_ns(time_ns);
        way.begun_at_ns = time_ns;
    }
    if (!way.demand.way.is_arc() || !way.is_on) way.share = {};
    if (!way.demand.way.is_arc()) return;
    for (Reach& reach : way.reach) {
        if (!way.is_on) reach.clear();
        if (reach.empty() || reach.front().least > 0.0) reach.insert(reach.begin(), {0.0, 0.0});
    }
}

void ProgramRule::follow(std::int64_t time_ns, const Positions& at, bool is_at_begin) {
    std::size_t last = 0;  // that the path may have been on
    for (std::size_t n = 0; n < window_.size(); ++n) {
        if (window_[n].is_on) last = n;
        // A switch at rest is no begin.
        if (at != at_ && std::exchange(window_[n].is_waiting, false)) window_[n].begun_ns = work_ns(time_ns);
    }
    const bool was_at_end = !window_.empty() && window_[last].is_at_end;
    bool is_before_at_end = false;
    bool is_on_any = false;
    bool rests_here = is_at_begin;
    std::optional<std::int64_t> too_short_since_ns;
    for (std::size_t n = 0; n <= last || is_before_at_end; ++n) {
        Live* const way = n < kMostWays ? live(n) : nullptr;
        if (way == nullptr) break;
        const bool comes = is_before_at_end;
        const bool is_from_rest = comes && window_[n - 1].demand.is_exact;
        if (too_short_since_ns) take_back(*way, *too_short_since_ns);
        const bool was_on = way->is_on;
        const bool had_begun = way->begun_ns.has_value();
        if (comes) begin_way(*way, time_ns);
        way->is_on = (was_on || comes) && stays_on(*way, at);
        if (way->is_on && !was_on) way->came_ns = time_ns;
        // From rest it begins with the pulse that leaves it.
        if (is_from_rest && way->is_on && !had_begun) way->is_waiting = true;
        if (!way->is_on && !had_begun) way->begun_ns.reset();
        if ((comes || is_at_begin) && rests_here) way->hidden_begin = way->is_on ? near_share(*way, at) : 0.0;
        const bool rested = way->is_at_end;
        is_before_at_end = note_end(*way, time_ns, at, comes);
        if (rested && !way->is_at_end && leaves_too_soon(n, time_ns, is_on_any))
            too_short_since_ns = way->ended_ns;
        rests_here = rests_here || way->is_at_end;
        is_on_any = is_on_any || way->is_on;
    }
    if (!is_on_any) return breach(last, was_at_end, time_ns, at);
    is_at_rest_ = rests_for_sure(at);
    note_hidden(at);
    leave_behind();
    if (window_.front().is_at_end || !window_.front().demand.is_exact) last_ns_ = time_ns;
}

bool ProgramRule::stays_on(Live& way, const Positions& at) {
    return way.demand.way.is_arc() ? stays_on_arc(way, at) : stays_on_line(way, at);
}

bool ProgramRule::stays_on_line(Live& way, const Positions& at) {
    const WayTolerance tolerance = tolerance_of(way);
    double off_mm = 0.0;
    std::array<double, kHeadCount> shares{};
    for (std::size_t head = 0; head < kHeadCount; ++head) {
        const auto nearest = way.demand.way.nearest(head, at, tolerance);
        if (nearest.mm > tolerance.mm) return false;
        shares[head] = nearest.share;
        if (nearest.share < way.share[head] - way.demand.way.back_share(head, at, tolerance)) return false;
        way.share[head] = std::max(way.share[head], nearest.share);
        off_mm = std::max(off_mm, nearest.mm);
    }
    if (apart_mm(way, at, shares) > 0.0) return false;
    most_off_mm_ = std::max(most_off_mm_, off_mm);
    return true;
}

bool ProgramRule::stays_on_arc(Live& way, const Positions& at) {
    const WayTolerance tolerance = tolerance_of(way);
    std::array<Reach, kHeadCount> reach = way.reach;
    double off_mm = 0.0;
    for (std::size_t head = 0; head < kHeadCount; ++head) {
        if (!way.demand.way.go_on(head, at, tolerance, reach[head])) return false;
        const ShareRange range{reach[head].front().least, reach[head].back().most};
        off_mm = std::max(off_mm, way.demand.way.nearest_within(head, at, tolerance, range).mm);
    }
    if (apart_on_arc_mm(way, at, reach) > 0.0) return false;
    way.reach = std::move(reach);
    for (std::size_t head = 0; head < kHeadCount; ++head) way.share[head] = way.reach[head].back().most;
    most_off_mm_ = std::max(most_off_mm_, off_mm);
    return true;
}

/// By how much more than they may the heads are at two places of a way. Each alone is that near to its own,
/// and rounds a corner as it likes: together they may be off twice as much.
double ProgramRule::apart_mm(const Live& way, const Positions& at,
                             const std::array<double, kHeadCount>& shares) const noexcept {
    const WayTolerance tolerance{2.0 * tolerance_of(way).mm, way.demand.slack_pulses + 1.0};
    return way.demand.way.from_one_place_mm(at, tolerance, shares) - tolerance.mm;
}

double ProgramRule::apart_on_arc_mm(const Live& way, const Positions& at,
                                    const std::array<Reach, kHeadCount>& reach) const noexcept {
    const WayTolerance tolerance{2.0 * tolerance_of(way).mm, way.demand.slack_pulses + 1.0};
    const ShareRange range{std::min(reach[0].front().least, reach[1].front().least),
                           std::max(reach[0].back().most, reach[1].back().most)};
    return way.demand.way.from_one_place_within_mm(at, tolerance, range) - tolerance.mm;
}

/// Whether all of a way was gone along: a circle's end is where it begins.
bool ProgramRule::has_come(const Live& way) const noexcept {
    const WayTolerance tolerance = tolerance_of(way);
    for (std::size_t head = 0; head < kHeadCount; ++head) {
        const ProgrammedWay& along = way.demand.way;
        const double back = along.is_arc() ? 0.0 : along.back_share(head, along.end_pulses(), tolerance);
        if (way.share[head] < 1.0 - back) return false;
    }
    return true;
}

bool ProgramRule::is_near_end(const Live& way, const Positions& at) const noexcept {
    if (way.demand.is_exact) return way.is_at_end;
    if (!has_come(way)) return false;
    const ProgrammedWay& along = way.demand.way;
    for (std::size_t head = 0; head < kHeadCount; ++head)
        if (along.from_mm(along.to(), head, at, way.demand.slack_pulses) > tolerance_of(way).mm) return false;
    return true;
}

/// Whether the path is on the way, and now at its end.
bool ProgramRule::note_end(Live& way, std::int64_t time_ns, const Positions& at, bool comes) {
    if (way.demand.is_exact) return note_rest(way, time_ns, at, comes);
    if (!way.is_on || !is_near_end(way, at)) return false;
    way.ended_ns = time_ns;
    way.done_ns = work_ns(time_ns);
    return true;
}

/// Ways that the path can no longer be on are done.
void ProgramRule::leave_behind() {
    while (!window_.front().is_on) {
        if (window_.front().has_gone_on) judge_rest(window_.front(), window_.front().ended_ns);
        note_time(window_.front());
        ++ways_done_;
        window_.pop_front();
    }
    const bool rests = window_.front().is_at_end && window_.size() > 1;
    place_.line = window_[rests ? 1 : 0].demand.line;
}

void ProgramRule::find_again(std::int64_t time_ns, const Positions& at) {
    if (looks_++ % kLookEvery != 0) return;
    for (std::size_t n = 0; n < kWaysAhead; ++n) {
        Live* const way = live(n);
        if (way == nullptr) return;
        way->share = {};
        way->reach.fill({{0.0, 1.0}});
        if (!stays_on(*way, at)) continue;
        way->is_on = true;
        way->begun_ns = work_ns(time_ns);
        // When it began is not known.
        way->demand.time = {};
        stretch_ = {};
        window_.erase(window_.begin(), window_.begin() + static_cast<std::ptrdiff_t>(n));
        phase_ = Phase::running;
        return;
    }
}

}  // namespace psicarve::verify
