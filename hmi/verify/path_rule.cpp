// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/path_rule.hpp"

#include <utility>

#include "hmi/verify/path_offences.hpp"
#include "shared/base/units.hpp"

namespace psicarve::verify {

PathRule::PathRule(const JobGeometry& geometry, CarvedSurface& surface, OffenceLog& log)
    : geometry_(geometry), log_(log), follower_(geometry, surface, log), begins_(geometry), ledger_(log) {
    log_.set_judged(1);
}

void PathRule::begin(const Positions& positions, bool spindle_on) {
    last_ = positions;
    spindle_on_ = spindle_on;
    before_homing_ = log_.result(1);
    follower_.wait_for(begins_.first());
}

std::vector<PassTime> PathRule::pass_times() const {
    if (!is_complete()) return {};
    return follower_.times().pass_times(geometry_.job());
}

Positions PathRule::in_jobs_count(Positions positions) const noexcept {
    positions[kPsi] -= attempt_.psi_offset;
    return positions;
}

bool PathRule::is_outward(const Positions& positions) const noexcept {
    return positions[kPsi] == last_[kPsi] && positions[kY] == last_[kY] && positions[0] >= last_[0] &&
           positions[1] >= last_[1];
}

void PathRule::settle(std::int64_t time_ns, const Positions& positions, bool spindle_on) {
    // Switched off together with the last pulse, the spindle still ran for it.
    const bool ran = spindle_on || spindle_on_;
    if (attempt_.is_guess && points_visited() == 0 && ran && begins_.is_first(positions)) {
        log_.restore(1, before_guess_);
        follower_.wait_for(begins_.first());
    }
    if (ran && begins_again(positions)) end_attempt(time_ns);
    if (has_only_passed(positions)) restore_before();
    const bool begins = ran && may_begin(positions) && begin_attempt(time_ns, positions);
    follower_.findings().set_outward(is_outward(positions));
    if (!begins) follow(time_ns, positions, ran);
    note_way(time_ns, positions);
    count_left_out(positions);
    end_behind_judged_layers();
    last_ = positions;
    if (spindle_on_ && !spindle_on) {
        is_elsewhere_ = false;
        if (follower_.phase() != Phase::approach) end_attempt(time_ns);
    }
    spindle_on_ = spindle_on;
}

void PathRule::follow(std::int64_t time_ns, const Positions& positions, bool spindle_on) {
    if (follower_.phase() == Phase::approach) return follow_approach(time_ns, positions, spindle_on);
    follower_.follow(time_ns, in_jobs_count(positions), positions[kPsi] != last_[kPsi]);
}

/// The retraction is no part of the way, and it alone only leads outward.
void PathRule::note_way(std::int64_t time_ns, const Positions& positions) {
    const bool is_on_its_way = follower_.phase() == Phase::segment || follower_.phase() == Phase::link;
    if (is_on_its_way && !is_outward(positions)) follower_.times().go(time_ns);
}

void PathRule::redefine(std::int64_t time_ns, const Positions& positions) {
    if (follower_.phase() != Phase::approach) end_attempt(time_ns);
    if (!end_.early_at && !is_complete()) {
        // The motion before the first homing does not count.
        follower_.make_blank();
        log_.restore(1, before_homing_);
    }
    last_ = positions;
}

/// No point was visited but the one with which the attempt began.
bool PathRule::has_only_gone_in() const noexcept {
    const CarvePoint next = follower_.way().point();
    return follower_.phase() == Phase::segment && next.layer == attempt_.begin.layer &&
           next.step == attempt_.begin.step + 1;
}

/// Between layers that are not judged the heads came by a judged one's first point on their way out.
bool PathRule::has_only_passed(const Positions& positions) const noexcept {
    return attempt_.was_elsewhere && has_only_gone_in() &&
           follower_.way().leads_not_out(in_jobs_count(positions));
}

/// Heads that go in together may pass where an earlier pass begins: nothing has begun until psi turns.
bool PathRule::may_begin(const Positions& positions) const noexcept {
    if (follower_.phase() == Phase::approach) return true;
    return has_only_gone_in() && in_jobs_count(positions)[kPsi] == follower_.way().from()[kPsi];
}

bool PathRule::goes_in(const Positions& positions) const noexcept {
    const bool rests = positions[kPsi] == last_[kPsi] && positions[kY] == last_[kY];
    return rests && positions != last_ && positions[0] <= last_[0] && positions[1] <= last_[1];
}

/// Where layers of two passes begin at one place, and one of them is not judged, that one may have been taken
/// for the other: the judged one begins when heads go in there again.
bool PathRule::begins_again(const Positions& positions) {
    if (follower_.phase() == Phase::approach) return false;
    const bool is_done = follower_.phase() == Phase::done;
    if (is_done && begins_.is_first(positions)) return true;
    if (!begins_.are_shared() || has_only_gone_in() || !goes_in(positions)) return false;
    return begins_.is_first(positions) || (is_done && begins_.layer_at(positions, due_layer()));
}

/// What was passed is behind, reached or not.
std::uint32_t PathRule::due_layer() const noexcept {
    return is_complete() ? geometry_.end_layer() : follower_.progress().due_layer();
}

/// The point with which carving begins or goes on where the axes stand.
std::optional<CarvePoint> PathRule::begin_at(const Positions& positions) {
    if (const auto layer = begins_.layer_at(positions, due_layer()))
        return CarvePoint{*layer, geometry_.first_step(*layer)};
    if (!goes_in(positions) || has_turned_ || is_elsewhere_) return std::nullopt;
    return begins_.point_at(positions, due_layer());
}

bool PathRule::is_judged(CarvePoint begin) const noexcept {
    return begin.layer >= geometry_.first_layer() && begin.layer < geometry_.end_layer() &&
           begin.step >= geometry_.first_step(begin.layer);
}

/// Whether carving begins here.
bool PathRule::begin_attempt(std::int64_t time_ns, const Positions& positions) {
    const bool has_begun = follower_.phase() != Phase::approach;
    const auto begin = begin_at(positions);
    if (!begin || (has_begun && *begin == attempt_.begin)) return false;
    // Carving passes a place where it must not begin.
    if (is_elsewhere_ && geometry_.job().is_joint(begin->layer, 0)) return false;
    if (has_begun) restore_before();
    const bool was_elsewhere = std::exchange(is_elsewhere_, !is_judged(*begin));
    if (is_elsewhere_) return true;
    start(*begin, time_ns, positions[kPsi]);
    attempt_.was_elsewhere = was_elsewhere;
    follower_.reach(time_ns);
    return true;
}

/// Nothing has begun where it seemed so.
void PathRule::restore_before() {
    follower_.restore(before_.follower);
    ledger_.restore(before_.ledger);
    end_ = before_.end;
    is_elsewhere_ = attempt_.was_elsewhere;
    follower_.wait_for(begins_.first());
}

/// Begins to carve with a point: with the first one anew, or goes on with a later one.
void PathRule::start(CarvePoint begin, std::int64_t time_ns, std::int64_t psi_pulses) {
    before_ = {follower_.kept(), ledger_.kept(), end_};
    CarveProgress& progress = follower_.progress();
    const std::int64_t rev = geometry_.rev_pulses();
    const std::int64_t begin_psi = geometry_.target(begin.layer, begin.step)[kPsi];
    const double turns = static_cast<double>(psi_pulses - begin_psi) / static_cast<double>(rev);
    attempt_ = {
        .begin = begin, .goes_on = begin != begins_.first(), .psi_offset = round_to_pulse(turns) * rev};
    const std::uint32_t carved = progress.points_of(begin.layer);
    const bool leaves_layers_out = begin.layer > progress.due_layer();
    if (attempt_.goes_on) {
        ledger_.go_on();
    } else {
        follower_.findings().set_line_extent({});
        ledger_.begin_anew();
    }
    progress.forget_from(begin);
    has_turned_ = false;
    end_ = {};
    follower_.begin(begin);
    if (leaves_layers_out) return leave_out(time_ns, layers_left_out(begin.layer, progress.due_layer()));
    // Where the last point carved is the one before it, the way between them is left out.
    if (attempt_.goes_on && begin.step > 0 && begin.step >= carved)
        leave_out(time_ns, points_left_out(begin, carved));
}

void PathRule::leave_out(std::int64_t time_ns, Offence offence) {
    offence.time_ns = time_ns;
    attempt_.left_out = LeftOut{std::move(offence), follower_.place()};
}

/// Heads that only go in leave nothing out.
void PathRule::count_left_out(const Positions& positions) {
    if (!attempt_.left_out || follower_.phase() == Phase::approach) return;
    if (has_only_gone_in() && in_jobs_count(positions)[kPsi] == follower_.way().from()[kPsi]) return;
    const auto left_out = std::exchange(attempt_.left_out, std::nullopt);
    if (log_.count(1, left_out->offence.time_ns)) log_.describe(left_out->offence, left_out->place);
}

void PathRule::follow_approach(std::int64_t time_ns, const Positions& positions, bool spindle_on) {
    const bool psi_turned = positions[kPsi] != last_[kPsi];
    has_turned_ = spindle_on && (has_turned_ || psi_turned);
    if (is_elsewhere_) return;
    if (spindle_on && psi_turned && begins_.is_near_first(last_, kNearPulses)) {
        leave_first_point(time_ns, positions);
    } else {
        follower_.touch(time_ns, positions);
    }
}

/// Psi turns away from the first point though it was never quite reached.
void PathRule::leave_first_point(std::int64_t time_ns, const Positions& positions) {
    before_guess_ = log_.result(1);
    start(begins_.first(), time_ns, last_[kPsi]);
    attempt_.is_guess = true;
    const Positions left = in_jobs_count(last_);
    follower_.way().note_radii(left);
    follower_.miss(time_ns, left);
    follower_.follow(time_ns, in_jobs_count(positions), true);
}

/// The layers that follow are not judged.
void PathRule::end_behind_judged_layers() {
    const bool has_more = !ends_there_ && geometry_.end_layer() < geometry_.layer_count();
    if (follower_.phase() != Phase::done || !has_more) return;
    is_elsewhere_ = true;
    end_attempt(follower_.times().arrived_ns());
}

void PathRule::end_attempt(std::int64_t time_ns) {
    // It went in and no further: nothing was carved anew, and what was carved before is so still.
    const bool is_none = has_only_gone_in() && attempt_.goes_on;
    if (is_none) follower_.progress().restore(before_.follower.progress);
    if (is_none && (before_.end.is_complete || follower_.times().seconds_so_far() == 0.0))
        follower_.times() = before_.follower.times;
    if (is_none && before_.end.is_complete) {
        end_ = before_.end;
    } else {
        end_.is_complete = follower_.phase() == Phase::done;
        if (!end_.is_complete) end_ = {follower_.place(), time_ns, follower_.way().nearest(), false};
    }
    follower_.end(attempt_.psi_offset);
    ledger_.end();
}

void PathRule::finish(std::int64_t time_ns) {
    if (follower_.phase() != Phase::approach) end_attempt(time_ns);
    ledger_.count_held();
    if (!is_complete()) report_missing_end(time_ns);
}

void PathRule::report_missing_end(std::int64_t time_ns) {
    const bool has_begun = end_.early_at.has_value();
    if (has_begun) time_ns = end_.time_ns;
    if (!log_.count(1, time_ns)) return;
    const std::uint64_t total = geometry_.total_points();
    follower_.set_place(end_.early_at.value_or(CarvePlace{}));
    follower_.report(time_ns,
                     has_begun ? ends_early(points_visited(), total, end_.nearest) : nothing_carved(total));
}

bool PathRule::objects_to(const std::function<void(PathRule&)>& tell) const {
    const RuleResult before = log_.result(1);
    PathRule trial = *this;
    trial.follower_.stop_carving();
    tell(trial);
    const bool objected = log_.result(1).offences != before.offences;
    log_.restore(1, before);
    return objected;
}

}  // namespace psicarve::verify
