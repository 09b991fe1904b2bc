// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ProgramRule that judges and tells.
#include <algorithm>
#include <string>
#include <utility>

#include "hmi/verify/program/program_rule.hpp"

namespace psicarve::verify {
namespace {

/// A path that passes a place at rest by less than this was to reach it.
constexpr std::int64_t kNearPulses = 64;
constexpr std::int64_t kSlackTicks = 2;
/// Ways are judged by their time when they are so many tolerances long, or end at rest.
constexpr double kTolerancesAStretch = 20.0;
/// A way that is less of a pulse, but has one, takes no more than this makes of it.
constexpr double kLeastPulses = 0.05;
/// Less than that is a matter of whole pulses in whole ticks.
constexpr double kHardlyLowered = 0.98;

ShareRange whole_of(const Reach& reach) noexcept {
    return reach.empty() ? ShareRange{0.0, 1.0} : ShareRange{reach.front().least, reach.back().most};
}

}  // namespace

void ProgramRule::report(std::int64_t time_ns, Offence offence, std::uint64_t line) {
    offence.rule = 1;
    offence.time_ns = time_ns;
    CarvePlace place;
    place.line = line;
    log_.describe(std::move(offence), place);
}

/// From the end of the way before, or from leaving the rest that is there.
void ProgramRule::note_kind(const Live& way) {
    const std::int64_t left_ns = way.begun_ns.value_or(way_over_ns_);
    const std::int64_t begun_ns = is_way_from_rest_ ? std::max(way_over_ns_, left_ns) : way_over_ns_;
    const std::int64_t taken_ns = std::max<std::int64_t>(way.done_ns - begun_ns, 0);
    (way.demand.time.programmed_s > 0.0 ? times_.feed_s : times_.rapid_s) += seconds_from_ns(taken_ns);
    way_over_ns_ = std::max(way_over_ns_, way.done_ns);
    is_way_from_rest_ = way.demand.is_exact;
}

/// Way after way, in their order.
void ProgramRule::note_time(const Live& way) {
    note_kind(way);
    Stretch& all = stretch_;
    if (!way.demand.goes_on) note_lowered();
    if (all.ways++ == 0) {
        all.goes_on = way.demand.goes_on;
        all.begun_ns = way.begun_ns.value_or(way.done_ns);
        all.first_line = way.demand.line;
        all.rests_s = rest_before_s_;
    }
    const WayTime& time = way.demand.time;
    const double wanted_s = time.programmed_s / program_.override_ratio;
    const double length_mm = way.demand.way.length_mm();
    all.programmed_s += time.before_s + time.programmed_s;
    all.asked_s += time.programmed_s;
    all.stepped_s += time.stepped_s;
    all.passes += way.passes;
    all.hidden_s += std::min(way.hidden_begin + way.hidden_end, 1.0) * wanted_s;
    if (way.demand.is_exact) all.rests_s += free_rest_s(way);
    if (way.demand.is_exact && way.has_gone_on) {
        all.spent_s += std::min(all.hidden_s, all.rests_s);
        all.hidden_s = 0.0;
        all.rests_s = free_rest_behind_s(way);
    }
    all.length_mm += length_mm;
    all.tolerance_mm = std::max(all.tolerance_mm, way.demand.tolerance_mm);
    if (length_mm > 0.0) all.slowest_s_per_mm = std::max(all.slowest_s_per_mm, wanted_s / length_mm);
    all.pulse_s = std::max(all.pulse_s, pulse_seconds(way));
    const bool rests = way.demand.is_exact && !way.has_gone_on;
    if (!rests && all.length_mm < kTolerancesAStretch * all.tolerance_mm) return;
    if (!rests && way.demand.is_exact) return;
    judge_time(way);
    all = {};
    all.is_from_rest = rests;
    rest_before_s_ = rests ? free_rest_behind_s(way) : 0.0;
}

/// At the feed. Rounding makes a pulse of what is hardly a part of one.
double ProgramRule::pulse_seconds(const Live& way) const noexcept {
    const ProgrammedWay& along = way.demand.way;
    const double of_parts_s = way.demand.time.programmed_s / std::max(along.most_pulses(), kLeastPulses);
    const double of_whole_s =
        along.is_arc() ? 0.0 : way.demand.time.stepped_s / static_cast<double>(along.whole_pulses());
    return std::max(of_parts_s, of_whole_s) / program_.override_ratio;
}

/// Half a pulse is missing at each end, ticks are whole, and where the path does not rest, it passes an end
/// somewhere within the tolerance.
double ProgramRule::slack_seconds(const Live& way) const noexcept {
    const int passed_ends = (stretch_.is_from_rest ? 0 : 1) + (way.demand.is_exact ? 0 : 1);
    return (2.0 + stretch_.passes) * stretch_.pulse_s + seconds_from_ns(kSlackTicks * tick_ns_) +
           passed_ends * stretch_.tolerance_mm * stretch_.slowest_s_per_mm + stretch_.spent_s +
           std::min(stretch_.hidden_s, stretch_.rests_s);
}

/// Whole pulses make a staircase longer than the line through it, or leave ways out: neither the programmed
/// time nor that along the pulses is asked for alone.
void ProgramRule::judge_time(const Live& way) {
    const double wanted_s = std::min(stretch_.programmed_s, stretch_.stepped_s) / program_.override_ratio;
    const double slack_s = slack_seconds(way);
    // A way without a pulse of its own is done before the next pulse begins it.
    const double taken_s = seconds_from_ns(std::max<std::int64_t>(way.done_ns - stretch_.begun_ns, 0));
    if (wanted_s > 0.0) gather_lowered(way, taken_s - slack_s);
    if (taken_s >= wanted_s - slack_s || !log_.count(1, way.ended_ns)) return;
    Offence offence;
    offence.fault = "feed";
    offence.measured = taken_s;
    offence.allowed = wanted_s;
    offence.bound = Bound::at_least;
    offence.unit = "s";
    offence.sentence = stretch_.ways == 1 ? "a way took less time than its feed asks for"
                                          : std::to_string(stretch_.ways) +
                                                " ways took less time than their feeds ask for, the last";
    report(way.ended_ns, std::move(offence), way.demand.line);
}

void ProgramRule::gather_lowered(const Live& way, double taken_s) {
    const double asked_s = std::max(stretch_.asked_s, stretch_.stepped_s);
    if (asked_s >= kHardlyLowered * taken_s) return;
    if (!stretch_.goes_on || (gathered_ && gathered_->last_line != stretch_.first_line)) note_lowered();
    if (!gathered_) gathered_ = LoweredFeed{.first_line = stretch_.first_line};
    gathered_->last_line = way.demand.line;
    gathered_->asked_s += asked_s;
    gathered_->taken_s += taken_s;
}

void ProgramRule::note_lowered() {
    if (!gathered_) return;
    const LoweredFeed now = *gathered_;
    gathered_.reset();
    lowered_s_ += now.lost_s();
    ++lowered_count_;
    const auto worse = [](const LoweredFeed& one, const LoweredFeed& other) {
        return one.lost_s() > other.lost_s();
    };
    const auto at = std::upper_bound(lowered_.begin(), lowered_.end(), now, worse);
    if (at == lowered_.end() && lowered_.size() == kMostLowered) return;
    lowered_.insert(at, now);
    if (lowered_.size() > kMostLowered) lowered_.pop_back();
}

/// It came near an end at rest, and not to it.
bool ProgramRule::has_missed(const Live& way) const noexcept {
    return way.demand.is_exact && way.nearest_pulses > 0 && way.nearest_pulses <= kNearPulses;
}

/// The path is on no way any more. `n`: the last one that it may have been on.
void ProgramRule::breach(std::size_t n, bool was_at_end, std::int64_t time_ns, const Positions& at) {
    const bool is_past_all = n >= window_.size();
    const bool goes_on = is_past_all || (was_at_end && live(n + 1) == nullptr);
    const bool misses_end = !is_past_all && !was_at_end && has_missed(window_[n]);
    if (const Live* const rest = is_past_all ? nullptr : short_rest_at(n)) {
        judge_rest(*rest, time_ns);
    } else if (!ways_->failure() && log_.count(1, time_ns)) {
        Offence offence = is_past_all ? Offence{} : off_the_way(window_[n], at);
        if (misses_end) offence = missed_end(window_[n]);
        if (goes_on) {
            offence.fault = "goes-on";
            offence.measured = 1.0;
            offence.allowed = 0.0;
            offence.unit = "pulses";
            offence.sentence = "an axis moves though all ways of the program are done";
        }
        report(time_ns, std::move(offence), is_past_all ? 0 : window_[n].demand.line);
    }
    if (goes_on) {
        if (!is_past_all) ++ways_done_;
        phase_ = Phase::over;
        return;
    }
    // It is looked for on this way, too, unless it has just come to its end.
    window_.erase(window_.begin(),
                  window_.begin() + static_cast<std::ptrdiff_t>(misses_end || was_at_end ? n + 1 : n));
    for (Live& way : window_) way.is_on = false;
    phase_ = Phase::lost;
    looks_ = 0;
}

Offence ProgramRule::missed_end(const Live& way) const {
    Offence offence;
    offence.fault = "end-missed";
    offence.axis = way.nearest_axis;
    offence.measured = static_cast<double>(way.nearest_pulses);
    offence.bound = Bound::exactly;
    offence.unit = "pulses";
    offence.sentence =
        "the end of a way at which the machine rests was not reached: " + shown_name(way.nearest_axis) +
        (way.nearest_axes == 1 ? " alone was off" : " was off most");
    return offence;
}

Offence ProgramRule::goes_back(Offence offence, double back_mm, double allowed_mm) const {
    offence.fault = "goes-back";
    offence.measured = back_mm;
    offence.allowed = allowed_mm;
    offence.sentence = "the path goes back along the way";
    return offence;
}

Offence ProgramRule::heads_apart(Offence offence, double apart_mm) const {
    offence.fault = "heads-apart";
    offence.measured = offence.allowed + apart_mm;
    offence.axis.reset();
    offence.sentence = "the heads are not at one place of the way";
    return offence;
}

Offence ProgramRule::off_the_way(const Live& way, const Positions& at) const {
    Offence offence;
    const WayTolerance tolerance = tolerance_of(way);
    offence.fault = "off-the-way";
    offence.unit = "mm";
    offence.allowed = way.demand.tolerance_mm;
    const bool is_arc = way.demand.way.is_arc();
    std::array<double, kHeadCount> shares{};
    for (std::size_t head = 0; head < kHeadCount; ++head) {
        const auto nearest =
            is_arc ? way.demand.way.nearest_within(head, at, tolerance, whole_of(way.reach[head]))
                   : way.demand.way.nearest(head, at, tolerance);
        shares[head] = nearest.share;
        if (nearest.mm <= offence.measured) continue;
        offence.measured = nearest.mm;
        offence.axis = kHeads[head];
    }
    offence.sentence =
        shown_name(offence.axis.value_or(Axis::r1)) + " is off the way, 1.5 pulses of each axis left out";
    for (std::size_t head = 0; head < kHeadCount; ++head) {
        if (const auto back = back_of(way, head, at, shares[head])) {
            offence.axis = kHeads[head];
            return goes_back(std::move(offence), back->mm, back->allowed_mm);
        }
    }
    if (offence.measured > tolerance.mm) return offence;
    const double apart_mm = is_arc ? apart_on_arc_mm(way, at, way.reach) : this->apart_mm(way, at, shares);
    return heads_apart(std::move(offence), std::max(apart_mm, 0.0));
}

/// How far back along its way a head has come, if it has. On an arc all that is behind the places where it
/// may have been is too far.
std::optional<ProgramRule::Back> ProgramRule::back_of(const Live& way, std::size_t head, const Positions& at,
                                                      double share) const noexcept {
    const ProgrammedWay& along = way.demand.way;
    const WayTolerance tolerance = tolerance_of(way);
    double allowed = along.back_share(head, at, tolerance);
    double behind = way.share[head] - share;
    if (along.is_arc()) {
        const double least = way.reach[head].front().least;
        const auto last = along.last_near(head, at, tolerance, {0.0, least});
        if (!last || along.nearest_within(head, at, tolerance, whole_of(way.reach[head])).mm <= tolerance.mm)
            return std::nullopt;
        behind = least - *last;
        allowed = 0.0;
    }
    if (behind <= allowed) return std::nullopt;
    return Back{behind * along.length_mm(), allowed * along.length_mm()};
}

void ProgramRule::finish(std::int64_t time_ns, SignalWord levels) {
    if (!ways_) ways_ = std::make_unique<WayReader>(program_, profile_, scale_, start_);
    const bool is_over = phase_ == Phase::over;
    judge_end(time_ns);
    judge_last_switches(time_ns, levels, is_over || phase_ == Phase::over);
    note_lowered();
    phase_ = Phase::over;
    // A wrong program judges nothing, wherever the trace ends.
    ways_->pass_rest();
}

void ProgramRule::judge_end(std::int64_t time_ns) {
    if (phase_ == Phase::over) return;
    const bool is_done = phase_ == Phase::running && window_.back().is_at_end && window_.back().is_on &&
                         live(window_.size()) == nullptr;
    if (is_done) {
        for (Live& way : window_)
            if (way.is_at_end) way.rested_ns = std::max(way.rested_ns, time_ns - way.ended_ns);
        for (const Live& way : window_) note_time(way);
        ways_done_ += window_.size();
        last_ns_ = window_.back().ended_ns;
        phase_ = Phase::over;
    }
    if (is_done || live(0) == nullptr || ways_->failure()) return;
    if (const Live* const rest = short_rest_at(window_.size() - 1)) return judge_rest(*rest, time_ns);
    if (!log_.count(1, time_ns)) return;
    Offence offence;
    offence.fault = "ends-early";
    offence.measured = static_cast<double>(ways_done_);
    offence.bound = Bound::at_least;
    offence.allowed = static_cast<double>(ways_done_ + 1);
    offence.unit = "ways";
    offence.sentence = "the trace ends before the program";
    const Live& last = window_.front();
    if (has_missed(last) && last.is_on) offence = missed_end(last);
    report(time_ns, std::move(offence), last.demand.line);
}

}  // namespace psicarve::verify
