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
    this->start(start.position_pulses);
}

void ProgramRule::start(const Positions& positions) {
    start_ = positions;
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

void ProgramRule::settle(std::int64_t time_ns, const Positions& positions, bool spindle_on) {
    if (phase_ == Phase::over) return;
    if (phase_ == Phase::waiting) {
        if (positions == start_) return;
        ways_ = std::make_unique<WayReader>(program_, profile_, scale_, start_);
        phase_ = Phase::running;
        left_ns_ = last_ns_ = time_ns;
        if (Live* first = live(0)) {
            first->is_on = true;
            first->is_waiting = true;
        }
    }
    if (phase_ == Phase::lost) find_again(time_ns, positions);
    if (phase_ != Phase::running) return;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        bounds_.least_pulses[k] = std::min(bounds_.least_pulses[k], positions[k]);
        bounds_.most_pulses[k] = std::max(bounds_.most_pulses[k], positions[k]);
    }
    follow(time_ns, positions);
    if (phase_ == Phase::running) judge_spindle(time_ns, spindle_on);
}

void ProgramRule::follow(std::int64_t time_ns, const Positions& at) {
    std::size_t last = 0;  // that the path may have been on
    for (std::size_t n = 0; n < window_.size(); ++n) {
        if (window_[n].is_on) last = n;
        if (std::exchange(window_[n].is_waiting, false)) window_[n].begun_ns = time_ns;
    }
    const bool was_at_end = !window_.empty() && window_[last].is_at_end;
    bool is_before_at_end = false;
    bool is_on_any = false;
    for (std::size_t n = 0; n <= last || is_before_at_end; ++n) {
        Live* const way = n < kMostWays ? live(n) : nullptr;
        if (way == nullptr) break;
        const bool comes = is_before_at_end;
        if (comes && !way->is_on) {
            if (!way->begun_ns) way->begun_ns = time_ns;
            way->share = {};
        }
        way->is_on = (way->is_on || comes) && stays_on(*way, at);
        // From rest it begins with the pulse that leaves it.
        if (comes && way->is_on) way->is_waiting = window_[n - 1].demand.is_exact;
        is_before_at_end = note_end(*way, time_ns, at);
        is_on_any = is_on_any || way->is_on;
    }
    if (!is_on_any) return breach(last, was_at_end, time_ns, at);
    leave_behind();
    if (window_.front().is_at_end || !window_.front().demand.is_exact) last_ns_ = time_ns;
}

bool ProgramRule::stays_on(Live& way, const Positions& at) {
    const WayTolerance tolerance = tolerance_of(way);
    double off_mm = 0.0;
    std::array<double, kHeadCount> shares{};
    for (std::size_t head = 0; head < kHeadCount; ++head) {
        const auto nearest = way.demand.way.nearest(head, at, tolerance, way.share[head]);
        if (nearest.mm > tolerance.mm) return false;
        shares[head] = nearest.share;
        if (nearest.share < way.share[head] - way.demand.way.back_share(head, tolerance)) return false;
        way.share[head] = std::max(way.share[head], nearest.share);
        off_mm = std::max(off_mm, nearest.mm);
    }
    if (apart_mm(way, at, shares) > 0.0) return false;
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

/// Whether all of a way was gone along: a circle's end is where it begins.
bool ProgramRule::has_come(const Live& way) const noexcept {
    const WayTolerance tolerance = tolerance_of(way);
    for (std::size_t head = 0; head < kHeadCount; ++head)
        if (way.share[head] < 1.0 - way.demand.way.back_share(head, tolerance)) return false;
    return true;
}

/// Whether the path is on the way, and now at its end.
bool ProgramRule::note_end(Live& way, std::int64_t time_ns, const Positions& at) {
    if (way.demand.is_exact) return note_rest(way, time_ns, at);
    if (!way.is_on || !has_come(way)) return false;
    for (std::size_t head = 0; head < kHeadCount; ++head)
        if (way.demand.way.from_end_mm(head, at, way.demand.slack_pulses) > tolerance_of(way).mm)
            return false;
    way.ended_ns = time_ns;
    return true;
}

/// The same where it ends at rest.
bool ProgramRule::note_rest(Live& way, std::int64_t time_ns, const Positions& at) {
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
    if (way.is_at_end && !was_at_end) way.ended_ns = time_ns;
    if (was_at_end && !way.is_at_end) {
        judge_rest(way, time_ns);
        way.is_on = false;
    }
    return way.is_at_end;
}

/// Ways that the path can no longer be on are done.
void ProgramRule::leave_behind() {
    while (!window_.front().is_on) {
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
        if (!stays_on(*way, at)) continue;
        way->is_on = true;
        way->begun_ns = time_ns;
        // Nobody knows when it began.
        way->demand.seconds = 0.0;
        stretch_ = {};
        window_.erase(window_.begin(), window_.begin() + static_cast<std::ptrdiff_t>(n));
        phase_ = Phase::running;
        return;
    }
}

}  // namespace psicarve::verify
