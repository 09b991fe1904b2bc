// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/path_rule.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

#include "shared/units.hpp"

namespace psicarve::verify {

namespace {

constexpr std::size_t kPsi = index_of(Axis::psi);
constexpr std::size_t kY = index_of(Axis::y);
constexpr std::int64_t kNearPulses = 64;  // how far off the first point a carving is still recognised
constexpr double kHeightSlackPulses = 1.0;

}  // namespace

PathRule::PathRule(const JobGeometry& geometry, CarvedSurface& surface, OffenceLog& log)
    : geometry_(geometry), surface_(surface), log_(log) {
    log_.set_judged(1);
}

void PathRule::begin(const Positions& positions, bool spindle_on) {
    last_ = positions;
    spindle_on_ = spindle_on;
    before_attempt_ = log_.result(1);
    aim(0, 0);
    phase_ = Phase::approach;
    place_ = {};
}

double PathRule::carve_seconds() const noexcept {
    return is_complete_ && has_left_ ? seconds_from_ns(arrived_ns_ - left_ns_) : 0.0;
}

std::int64_t PathRule::forward(std::int64_t psi_pulses) const noexcept {
    return (psi_pulses - to_[kPsi]) * psi_sign_;
}

void PathRule::settle(std::int64_t time_ns, const Positions& positions, bool spindle_on) {
    // Switched off together with the last pulse, the spindle still ran for it.
    const bool ran = spindle_on || spindle_on_;
    if (is_guess_ && visited_ == 0 && ran && is_first_point(positions)) {
        log_.restore(1, before_guess_);
        phase_ = Phase::approach;
    }
    if (phase_ == Phase::done && ran && is_first_point(positions)) end_attempt(time_ns);
    const bool was_outward = std::exchange(is_outward_, is_outward_from_last(positions));
    if (was_outward && !is_outward_) keep_retraction();
    Positions at = positions;
    at[kPsi] -= psi_offset_;
    switch (phase_) {
        case Phase::segment:
            follow_segment(time_ns, at);
            break;
        case Phase::link:
            follow_link(time_ns, at);
            break;
        case Phase::approach:
            follow_approach(time_ns, positions, ran);
            break;
        case Phase::done:
            touch(time_ns, at);
            break;
    }
    last_ = positions;
    if (spindle_on_ && !spindle_on && phase_ != Phase::approach) end_attempt(time_ns);
    spindle_on_ = spindle_on;
}

bool PathRule::is_outward_from_last(const Positions& positions) const noexcept {
    return positions[kPsi] == last_[kPsi] && positions[kY] == last_[kY] && positions[0] >= last_[0] &&
           positions[1] >= last_[1];
}

void PathRule::redefine(std::int64_t time_ns, const Positions& positions) {
    if (phase_ != Phase::approach) end_attempt(time_ns);
    if (!ended_at_ && !is_complete_) {
        // Whatever was counted before the first homing meant nothing.
        surface_.clear();
        log_.restore(1, before_attempt_);
    }
    last_ = positions;
}

bool PathRule::is_first_point(const Positions& at) const noexcept {
    const Positions first = geometry_.target(0, 0);
    return at[0] == first[0] && at[1] == first[1] && at[kY] == first[kY] &&
           (at[kPsi] - first[kPsi]) % geometry_.rev_pulses() == 0;
}

bool PathRule::was_near_first_point() const noexcept {
    const Positions first = geometry_.target(0, 0);
    const std::int64_t rest = std::abs((last_[kPsi] - first[kPsi]) % geometry_.rev_pulses());
    return std::abs(last_[0] - first[0]) <= kNearPulses && std::abs(last_[1] - first[1]) <= kNearPulses &&
           std::abs(last_[kY] - first[kY]) <= kNearPulses &&
           std::min(rest, geometry_.rev_pulses() - rest) <= kNearPulses;
}

void PathRule::follow_approach(std::int64_t time_ns, const Positions& at, bool spindle_on) {
    if (spindle_on && is_first_point(at)) {
        start(at[kPsi]);
        reach(time_ns);
        return;
    }
    if (!spindle_on || at[kPsi] == last_[kPsi] || !was_near_first_point()) {
        touch(time_ns, at);
        return;
    }
    // Psi turns away from the first point though it was never quite reached.
    before_guess_ = log_.result(1);
    start(last_[kPsi]);
    is_guess_ = true;
    Positions left = last_;
    left[kPsi] -= psi_offset_;
    note_closest(left);
    miss(time_ns, left);
    Positions now = at;
    now[kPsi] -= psi_offset_;
    follow_segment(time_ns, now);
}

void PathRule::start(std::int64_t psi_pulses) {
    const std::int64_t rev = geometry_.rev_pulses();
    const std::int64_t first = geometry_.target(0, 0)[kPsi];
    const double turns = static_cast<double>(psi_pulses - first) / static_cast<double>(rev);
    psi_offset_ = round_to_pulse(turns) * rev;
    visited_ = 0;
    is_guess_ = false;
    has_left_ = false;
    is_complete_ = false;
    max_line_mm_ = 0.0;
    max_line_pulses_ = 0.0;
    ended_at_.reset();
    retraction_ = {};
    at_start_ = log_.result(1);
    is_holding_ = false;
    aim(0, 0);
}

void PathRule::end_attempt(std::int64_t time_ns) {
    is_complete_ = phase_ == Phase::done;
    if (!is_complete_) {
        ended_at_ = place_;
        ended_near_ = near_;
        ended_ns_ = time_ns;
    }
    ended_on_path_.reset();
    if (phase_ == Phase::segment && !strayed_) ended_on_path_ = last_;
    retraction_ = {};
    hold_attempt();
    phase_ = Phase::approach;
    place_ = {};
}

/// Takes the attempt's breaches out of the log for as long as another attempt may follow.
void PathRule::hold_attempt() {
    held_ = log_.result(1);
    held_before_ = at_start_.offences;
    is_holding_ = true;
    log_.restore(1, at_start_);
}

void PathRule::count_held_attempt() {
    if (!is_holding_) return;
    RuleResult all = log_.result(1);
    all.offences += held_.offences - held_before_;
    if (held_.first && (!all.first || held_.first->time_ns < all.first->time_ns)) all.first = held_.first;
    log_.restore(1, all);
}

/// Makes a point the next one to be visited.
void PathRule::aim(std::uint32_t layer, std::uint32_t step) {
    layer_ = layer;
    step_ = step;
    strayed_ = false;
    near_ = {};
    from_ = to_;
    to_ = geometry_.target(layer, step);
    const std::uint32_t point = carved_point(geometry_.job().joining(), geometry_.point_count(), layer, step);
    place_ = {layer, point};
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        Heading& heading = headings_[h];
        heading.closest.reset();
        if (step > 0) heading.line = PathLine::between(geometry_, h, from_, to_);
    }
    if (step <= 1 || geometry_.is_spiral()) aim_surface(layer, point);
    if (step > 0) {
        psi_sign_ = to_[kPsi] >= from_[kPsi] ? 1 : -1;
        phase_ = Phase::segment;
        cells_at_psi_ = from_[kPsi] - psi_sign_;  // no cell known yet
    } else {
        phase_ = Phase::link;
    }
}

void PathRule::aim_surface(std::uint32_t layer, std::uint32_t point) {
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        Heading& heading = headings_[h];
        heading.from_layer = heading.surface_layer;
        heading.from_cell = geometry_.cell_of(geometry_.direction(h, from_[kPsi]));
        const auto row = geometry_.layer_of_point(h, layer, point);
        heading.has_surface = row.has_value();
        heading.surface_layer = row.value_or(0);
    }
}

void PathRule::advance() {
    if (step_ + 1 < geometry_.point_count()) {
        aim(layer_, step_ + 1);
    } else if (layer_ + 1 < geometry_.layer_count()) {
        aim(layer_ + 1, geometry_.is_spiral() ? 1 : 0);
    } else {
        phase_ = Phase::done;
        place_ = {};
    }
}

void PathRule::reach(std::int64_t time_ns) {
    ++visited_;
    // The next row of a spiral begins here.
    if (geometry_.is_spiral() && step_ + 1 == geometry_.point_count() && layer_ + 1 < geometry_.layer_count())
        ++visited_;
    arrived_ns_ = time_ns;
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const Heading& heading = headings_[h];
        if (!heading.has_surface) continue;
        const std::uint32_t cell = geometry_.cell_of(geometry_.direction(h, to_[kPsi]));
        const double mm = geometry_.head(h).real_mm(to_[index_of(kHeads[h])]);
        surface_.touch(heading.surface_layer, cell, static_cast<float>(mm));
        surface_.note_deviation(heading.surface_layer, cell, 0);
    }
    advance();
}

void PathRule::Nearest::note(const Positions& now, const Positions& wanted) noexcept {
    std::int64_t most = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) most = std::max(most, std::abs(now[k] - wanted[k]));
    if (most > most_off) return;
    unsigned off = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) off |= now[k] != wanted[k] ? 1U << k : 0U;
    if (most == most_off && std::popcount(off) >= std::popcount(axes_off)) return;
    *this = {now, most, off};
}

std::optional<Axis> PathRule::Nearest::only_axis_off() const noexcept {
    if (std::popcount(axes_off) != 1 || most_off > kNearPulses) return {};
    return static_cast<Axis>(std::countr_zero(axes_off));
}

void PathRule::note_closest(const Positions& at) {
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const std::size_t axis = index_of(kHeads[h]);
        auto& closest = headings_[h].closest;
        if (!closest || std::abs(at[axis] - to_[axis]) < std::abs(*closest - to_[axis])) closest = at[axis];
    }
}

/// Whether both heads are near enough to their straight lines; keeps the largest distances.
bool PathRule::is_on_lines(std::int64_t time_ns, const Positions& at) {
    bool is_on = true;
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const std::size_t axis = index_of(kHeads[h]);
        const PathLine& line = headings_[h].line;
        const auto distance = line.distance(at[kPsi] - from_[kPsi], at[axis] - from_[axis]);
        double& max_mm = is_outward_ ? retraction_.max_line_mm : max_line_mm_;
        double& max_pulses = is_outward_ ? retraction_.max_line_pulses : max_line_pulses_;
        if (distance.mm > max_mm) max_mm = distance.mm;
        if (distance.across_mm > max_pulses * line.pulse_across_mm())
            max_pulses = distance.across_mm / line.pulse_across_mm();
        if (distance.is_allowed) continue;
        is_on = false;
        stray(time_ns, h, distance);
    }
    return is_on;
}

/// The tips cut where they may: no more to judge.
void PathRule::carve(const Positions& at) {
    const bool turned = at[kPsi] != cells_at_psi_;
    cells_at_psi_ = at[kPsi];
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        Heading& heading = headings_[h];
        if (turned) heading.cell = geometry_.cell_of(geometry_.direction(h, at[kPsi]));
        if (!heading.has_surface) continue;
        const double mm = geometry_.head(h).real_mm(at[index_of(kHeads[h])]);
        const bool is_at_from = geometry_.is_spiral() && heading.cell == heading.from_cell;
        surface_.touch(is_at_from ? heading.from_layer : heading.surface_layer, heading.cell,
                       static_cast<float>(mm));
    }
}

PathRule::HeightLine PathRule::height_line(std::int64_t psi_pulses) const noexcept {
    const auto rise = static_cast<double>(to_[kY] - from_[kY]);
    const auto turn = static_cast<double>(to_[kPsi] - from_[kPsi]);
    if (rise == 0.0 || turn == 0.0) return {static_cast<double>(to_[kY]), kHeightSlackPulses};
    const double part = std::clamp(static_cast<double>(psi_pulses - from_[kPsi]) / turn, 0.0, 1.0);
    // Psi is known to a pulse.
    return {static_cast<double>(from_[kY]) + part * rise, kHeightSlackPulses + std::abs(rise / turn)};
}

void PathRule::follow_segment(std::int64_t time_ns, const Positions& at) {
    if (!has_left_) {
        has_left_ = true;
        left_ns_ = time_ns;
    }
    while (phase_ == Phase::segment && forward(at[kPsi]) > 0) miss(time_ns, at);
    if (phase_ == Phase::segment) {
        const HeightLine line = height_line(at[kPsi]);
        if (std::abs(static_cast<double>(at[kY]) - line.at) > line.allowed) {
            stray_in_height(time_ns, at);
            if (phase_ == Phase::segment) return touch(time_ns, at);
        }
    }
    if (phase_ == Phase::link) return follow_link(time_ns, at);
    if (phase_ == Phase::done) return touch(time_ns, at);
    if (is_on_lines(time_ns, at))
        carve(at);
    else
        touch(time_ns, at);
    if (at == to_) return reach(time_ns);
    near_.note(at, to_);
    if (at[kPsi] == to_[kPsi]) note_closest(at);
}

void PathRule::follow_link(std::int64_t time_ns, const Positions& at) {
    touch(time_ns, at);
    if (at == to_) return reach(time_ns);
    const std::int64_t direction = geometry_.direction(0, at[kPsi]);
    if (const auto layer = geometry_.layer_at(at[kY], direction);
        layer && *layer != layer_ && *layer + 1 != layer_)
        wrong_layer(time_ns, at, *layer);
    if (phase_ != Phase::link || at[kY] != to_[kY]) return;
    if (at[kPsi] == to_[kPsi]) note_closest(at);
    // Psi that turns at this height: the layer goes on without its first point.
    if (at[kPsi] + psi_offset_ == last_[kPsi]) return;
    const Positions second = geometry_.target(layer_, 1);
    const std::int64_t way = second[kPsi] - to_[kPsi];
    if ((at[kPsi] - second[kPsi]) * (way > 0 ? 1 : -1) < 0) return;
    miss(time_ns, at);
    if (phase_ == Phase::segment) follow_segment(time_ns, at);
}

void PathRule::finish(std::int64_t time_ns) {
    if (phase_ != Phase::approach) end_attempt(time_ns);
    count_held_attempt();
    if (!is_complete_) end_early(time_ns);
}

}  // namespace psicarve::verify
