// SPDX-License-Identifier: GPL-3.0-or-later
// Part of rule 1: where carving begins and ends.
#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "hmi/verify/path_rule.hpp"
#include "shared/base/units.hpp"

namespace psicarve::verify {

void PathRule::redefine(std::int64_t time_ns, const Positions& positions) {
    if (phase_ != Phase::approach) end_attempt(time_ns);
    if (!ended_at_ && !is_complete_) {
        // The motion before the first homing does not count.
        if (surface_ != nullptr) surface_->clear();
        log_.restore(1, before_attempt_);
    }
    last_ = positions;
}

bool PathRule::is_begin_of(std::uint32_t layer, const Positions& at) const noexcept {
    const Positions first = geometry_.target(layer, geometry_.first_step(layer));
    return at[kY] == first[kY] && at[0] == first[0] && at[1] == first[1] &&
           (at[kPsi] - first[kPsi]) % geometry_.rev_pulses() == 0;
}

bool PathRule::was_near_first_point() const noexcept {
    const std::uint32_t layer = geometry_.first_layer();
    const Positions first = geometry_.target(layer, geometry_.first_step(layer));
    const std::int64_t rest = std::abs((last_[kPsi] - first[kPsi]) % geometry_.rev_pulses());
    return std::abs(last_[0] - first[0]) <= kNearPulses && std::abs(last_[1] - first[1]) <= kNearPulses &&
           std::abs(last_[kY] - first[kY]) <= kNearPulses &&
           std::min(rest, geometry_.rev_pulses() - rest) <= kNearPulses;
}

/// The layer that begins here: the one that is due where there are several.
std::optional<std::uint32_t> PathRule::layer_that_begins(const Positions& at) {
    if (!begins_y_ || *begins_y_ != at[kY]) {
        begins_y_ = at[kY];
        beginning_.clear();
        for (std::uint32_t layer = 0; layer < geometry_.layer_count(); ++layer) {
            if (geometry_.target(layer, geometry_.first_step(layer))[kY] == at[kY])
                beginning_.push_back(layer);
        }
    }
    std::optional<std::uint32_t> found;
    for (const std::uint32_t layer : beginning_) {
        if (is_begin_of(layer, at) && (!found || layer == due_layer())) found = layer;
    }
    return found;
}

/// The first layer of which not all points were visited yet.
std::uint32_t PathRule::due_layer() const noexcept {
    std::uint32_t layer = geometry_.first_layer();
    while (layer < geometry_.end_layer() && visited_of_[layer] >= geometry_.point_count()) ++layer;
    return layer;
}

/// Heads that go in together may pass where an earlier pass begins: nothing has begun until psi turns.
bool PathRule::may_begin(const Positions& at) const noexcept {
    if (phase_ == Phase::approach) return true;
    return phase_ == Phase::segment && layer_ == begun_layer_ && step_ == begun_step_ + 1 &&
           at[kPsi] - psi_offset_ == from_[kPsi];
}

/// Whether carving begins here.
bool PathRule::begin_layer(std::int64_t time_ns, const Positions& at) {
    const bool begun = phase_ != Phase::approach;
    const auto layer = layer_that_begins(at);
    const auto begin =
        layer ? std::optional(Begin{*layer, geometry_.first_step(*layer)}) : point_that_begins(at);
    if (!begin || (begun && begin->layer == begun_layer_ && begin->step == begun_step_)) return false;
    // Carving passes a place where it must not begin.
    if (is_elsewhere_ && geometry_.job().is_joint(begin->layer, 0)) return false;
    if (begun) restore_before();
    phase_ = Phase::approach;
    is_elsewhere_ = !is_judged(*begin);
    if (is_elsewhere_) return true;
    start(*begin, time_ns, at[kPsi]);
    reach(time_ns);
    return true;
}

void PathRule::keep_before() {
    before_ = {visited_of_,  visited_,    log_.result(1), held_,
               held_before_, is_holding_, max_line_mm_,   max_line_pulses_};
}

/// Nothing has begun where it seemed so.
void PathRule::restore_before() {
    log_.restore(1, before_.result);
    visited_of_ = before_.visited_of;
    visited_ = before_.visited;
    held_ = before_.held;
    held_before_ = before_.held_before;
    is_holding_ = before_.is_holding;
    max_line_mm_ = before_.max_line_mm;
    max_line_pulses_ = before_.max_line_pulses;
}

/// The layer's point at this psi and y, whatever its radii.
std::optional<std::uint32_t> PathRule::step_at(std::uint32_t layer, const Positions& at) const noexcept {
    const std::uint32_t last = geometry_.point_count() - 1;
    const JobView& job = geometry_.job();
    if (job.y_pulses(layer, 0) > at[kY] || job.y_pulses(layer, last) < at[kY]) return std::nullopt;
    const std::int64_t rev = geometry_.rev_pulses();
    const std::int64_t first_psi = geometry_.target(layer, 0)[kPsi];
    const std::int64_t way = geometry_.target(layer, last)[kPsi] - first_psi;
    const std::int64_t sign = way < 0 ? -1 : 1;
    std::int64_t turned = (at[kPsi] - first_psi) * sign % rev;
    if (turned < 0) turned += rev;
    if (turned > way * sign) return std::nullopt;
    std::uint32_t step = 0;  // the first that lies as far from the layer's begin
    for (std::uint32_t end = last; step < end;) {
        const std::uint32_t middle = step + (end - step) / 2;
        if ((geometry_.target(layer, middle)[kPsi] - first_psi) * sign < turned) {
            step = middle + 1;
        } else {
            end = middle;
        }
    }
    const Positions point = geometry_.target(layer, step);
    const bool is_there = (point[kPsi] - first_psi) * sign == turned && point[kY] == at[kY];
    return is_there ? std::optional(step) : std::nullopt;
}

/// The point of a layer, not its last, that heads which go in, psi and Y still, have reached: one of the
/// layer that is due where there are several.
std::optional<PathRule::Begin> PathRule::point_that_begins(const Positions& at) {
    const bool rests = at[kPsi] == last_[kPsi] && at[kY] == last_[kY];
    const bool goes_in = rests && at != last_ && at[0] <= last_[0] && at[1] <= last_[1];
    if (!goes_in || has_turned_ || is_elsewhere_) return std::nullopt;
    look_for_points(at);
    std::optional<Begin> found;
    for (const Begin& point : plunge_points_) {
        const Positions target = geometry_.target(point.layer, point.step);
        if (target[0] != at[0] || target[1] != at[1]) continue;
        if (!found || point.layer == due_layer()) found = point;
    }
    return found;
}

/// Of all layers: once for a plunge of many pulses.
void PathRule::look_for_points(const Positions& at) {
    if (plunge_ == std::pair{at[kPsi], at[kY]}) return;
    plunge_ = {at[kPsi], at[kY]};
    plunge_points_.clear();
    for (std::uint32_t layer = 0; layer < geometry_.layer_count(); ++layer) {
        const auto step = step_at(layer, at);
        if (step && *step + 1 < geometry_.point_count()) plunge_points_.push_back({layer, *step});
    }
}

bool PathRule::is_judged(Begin begin) const noexcept {
    return begin.layer >= geometry_.first_layer() && begin.layer < geometry_.end_layer() &&
           begin.step >= geometry_.first_step(begin.layer);
}

void PathRule::follow_approach(std::int64_t time_ns, const Positions& at, bool spindle_on) {
    has_turned_ = spindle_on && (has_turned_ || at[kPsi] != last_[kPsi]);
    if (is_elsewhere_) return;
    if (!spindle_on || at[kPsi] == last_[kPsi] || !was_near_first_point()) {
        touch(time_ns, at);
        return;
    }
    // Psi turns away from the first point though it was never quite reached.
    before_guess_ = log_.result(1);
    start({geometry_.first_layer(), geometry_.first_step(geometry_.first_layer())}, time_ns, last_[kPsi]);
    is_guess_ = true;
    Positions left = last_;
    left[kPsi] -= psi_offset_;
    note_closest(left);
    miss(time_ns, left);
    Positions now = at;
    now[kPsi] -= psi_offset_;
    follow_segment(time_ns, now);
}

/// Of that layer what lies before is carved still, as far as it was; all behind it is carved anew.
void PathRule::forget_from(Begin begin) {
    const std::uint32_t first = geometry_.first_layer();
    visited_of_[begin.layer] = std::min(visited_of_[begin.layer], begin.step);
    std::fill(visited_of_.begin() + begin.layer + 1, visited_of_.end(), 0U);
    visited_ = std::accumulate(visited_of_.begin() + first, visited_of_.begin() + begin.layer + 1,
                               std::uint64_t{0}) -
               geometry_.first_step(first);
}

/// Begins to carve with a point: with the first one anew, or goes on with a later one.
void PathRule::start(Begin begin, std::int64_t time_ns, std::int64_t psi_pulses) {
    keep_before();
    const std::uint32_t layer = begin.layer;
    const std::int64_t rev = geometry_.rev_pulses();
    const std::int64_t first = geometry_.target(layer, begin.step)[kPsi];
    const double turns = static_cast<double>(psi_pulses - first) / static_cast<double>(rev);
    psi_offset_ = round_to_pulse(turns) * rev;
    begun_layer_ = layer;
    begun_step_ = begin.step;
    goes_on_ = layer > geometry_.first_layer() || begin.step > geometry_.first_step(layer);
    const bool leaves_out = layer > due_layer();
    const std::uint32_t due_step = visited_of_[layer];
    if (goes_on_) {
        count_held_attempt();
    } else {
        max_line_mm_ = 0.0;
        max_line_pulses_ = 0.0;
    }
    forget_from(begin);
    is_guess_ = false;
    has_turned_ = false;
    has_left_ = false;
    is_complete_ = false;
    ended_at_.reset();
    on_path_.reset();
    pass_ended_ns_.clear();
    retraction_ = {};
    too_deep_in_link_.clear();
    at_start_ = log_.result(1);
    is_holding_ = false;
    const std::uint32_t due = due_layer();
    aim(layer, begin.step);
    if (begin.step > 1)
        aim_surface(layer,
                    carved_point(geometry_.job().joining(), geometry_.point_count(), layer, begin.step));
    if (leaves_out) return leave_out(time_ns, due);
    // Where the last point carved is the one before it, the way between them is left out.
    if (goes_on_ && begin.step > 0 && begin.step >= due_step) leave_out_points(time_ns, begin, due_step);
}

void PathRule::end_attempt(std::int64_t time_ns) {
    // It went in and no further: nothing was carved anew, and what was carved before is so still.
    const bool has_only_gone_in =
        phase_ == Phase::segment && layer_ == begun_layer_ && step_ == begun_step_ + 1;
    if (has_only_gone_in && goes_on_) {
        visited_of_ = before_.visited_of;
        visited_ = before_.visited;
    }
    keep_link();
    is_complete_ = phase_ == Phase::done;
    if (!is_complete_) {
        ended_at_ = place_;
        ended_near_ = near_;
        ended_ns_ = time_ns;
    }
    if (on_path_) (*on_path_)[kPsi] += psi_offset_;
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

void PathRule::finish(std::int64_t time_ns) {
    if (phase_ != Phase::approach) end_attempt(time_ns);
    count_held_attempt();
    if (!is_complete_) end_early(time_ns);
}

}  // namespace psicarve::verify
