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
    const Positions first = geometry_.target(layer, 0);
    return at[kY] == first[kY] && at[0] == first[0] && at[1] == first[1] &&
           (at[kPsi] - first[kPsi]) % geometry_.rev_pulses() == 0;
}

bool PathRule::was_near_first_point() const noexcept {
    const Positions first = geometry_.target(geometry_.first_layer(), 0);
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
            if (geometry_.target(layer, 0)[kY] == at[kY]) beginning_.push_back(layer);
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
    return phase_ == Phase::segment && layer_ == begun_layer_ && step_ == 1 &&
           at[kPsi] - psi_offset_ == from_[kPsi];
}

/// Whether carving begins here.
bool PathRule::begin_layer(std::int64_t time_ns, const Positions& at) {
    const auto layer = layer_that_begins(at);
    if (!layer || (phase_ != Phase::approach && *layer == begun_layer_)) return false;
    // Carving passes a place where it must not begin.
    if (is_elsewhere_ && geometry_.job().is_joint(*layer, 0)) return false;
    if (phase_ != Phase::approach) log_.restore(1, at_start_);
    phase_ = Phase::approach;
    is_elsewhere_ = *layer < geometry_.first_layer() || *layer >= geometry_.end_layer();
    if (is_elsewhere_) return true;
    start(*layer, time_ns, at[kPsi]);
    reach(time_ns);
    return true;
}

void PathRule::follow_approach(std::int64_t time_ns, const Positions& at, bool spindle_on) {
    if (is_elsewhere_) return;
    if (!spindle_on || at[kPsi] == last_[kPsi] || !was_near_first_point()) {
        touch(time_ns, at);
        return;
    }
    // Psi turns away from the first point though it was never quite reached.
    before_guess_ = log_.result(1);
    start(geometry_.first_layer(), time_ns, last_[kPsi]);
    is_guess_ = true;
    Positions left = last_;
    left[kPsi] -= psi_offset_;
    note_closest(left);
    miss(time_ns, left);
    Positions now = at;
    now[kPsi] -= psi_offset_;
    follow_segment(time_ns, now);
}

/// Begins to carve with a layer: with the first one anew, or goes on with a later one.
void PathRule::start(std::uint32_t layer, std::int64_t time_ns, std::int64_t psi_pulses) {
    const std::int64_t rev = geometry_.rev_pulses();
    const std::int64_t first = geometry_.target(layer, 0)[kPsi];
    const double turns = static_cast<double>(psi_pulses - first) / static_cast<double>(rev);
    psi_offset_ = round_to_pulse(turns) * rev;
    begun_layer_ = layer;
    const bool goes_on = layer > geometry_.first_layer();
    const bool leaves_out = layer > due_layer();
    if (goes_on) {
        count_held_attempt();
    } else {
        max_line_mm_ = 0.0;
        max_line_pulses_ = 0.0;
    }
    std::fill(visited_of_.begin() + layer, visited_of_.end(), 0U);
    visited_ = std::accumulate(visited_of_.begin() + geometry_.first_layer(), visited_of_.begin() + layer,
                               std::uint64_t{0});
    is_guess_ = false;
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
    aim(layer, 0);
    if (leaves_out) leave_out(time_ns, due);
}

void PathRule::end_attempt(std::int64_t time_ns) {
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
