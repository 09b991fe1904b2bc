// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/path_law.hpp"

#include <algorithm>
#include <cmath>

namespace psicarve::cycle {
namespace {

// So close to the target's speed squared it is met; the step is far below what any axis notices.
constexpr double kMetRatio = 1e-12;
}  // namespace

void PathLaw::start(const PathTiming& timing) noexcept {
    clock_ = 0.0;
    is_following_ = true;
    is_resting_ = false;
    const double speed2 = target_.of(timing.start_speed2[0], timing.start_speed2[1]);
    end_speed_ = std::sqrt(speed2) * limits_.period_s();
    enter(timing);
}

void PathLaw::start_again(const PathTiming& timing) noexcept {
    clock_ = 0.0;
    is_following_ = false;
    is_resting_ = false;
    limits_.enter(timing);
    bound_target();
    const SegmentLimits::Profiles profiles = limits_.profiles_at(0.0);
    const double target2 = is_bitten_ ? capped2_ : target_.of(profiles.low, profiles.high);
    end_speed_ = std::min(limits_.start_stop_speed(), std::sqrt(target2));
    enter(timing);
}

void PathLaw::next(const PathTiming& timing) noexcept {
    end_speed_ = base_speed_;
    enter(timing);
}

void PathLaw::enter(const PathTiming& timing) noexcept {
    limits_.enter(timing);
    bound_target();
    is_at_end_ = false;
    base_ = 0.0;
    way_ = 0.0;
    base_speed_ = end_speed_;
    begin_piece();
    if (clock_ < piece_end_) {
        way_ = clock_ * (base_speed_ + half_accel_ * clock_);
    } else {
        finish_pieces();
    }
}

void PathLaw::aim(double feed_ratio, double part) noexcept {
    if (!target_.aim(feed_ratio, part)) return;
    bound_target();
    restart();
}

// From where it is and as fast as it is, towards another target.
void PathLaw::restart() noexcept {
    is_following_ = false;
    const double speed_now = speed();
    base_speed_ = speed_now;
    if (is_resting_ && !target_.is_rest()) {
        const SegmentLimits::Profiles profiles = limits_.profiles_at(way_);
        const double target2 =
            is_bitten_ ? capped2_ + capped_slope_ * way_ : target_.of(profiles.low, profiles.high);
        base_speed_ = std::min(limits_.start_stop_speed(), std::sqrt(target2));
        is_resting_ = false;
    }
    if (is_at_end_) return;
    base_ = way_;
    clock_ = 0.0;
    begin_piece();
}

void PathLaw::cap(bool is_capped) noexcept {
    is_capped_ = is_capped;
    if (!is_capped) loosen();
}

// What was too fast is not any more.
void PathLaw::loosen() noexcept {
    if (!is_bitten_) return;
    bound_target();
    if (is_resting_) {
        is_following_ = false;
    } else {
        restart();
    }
}

void PathLaw::bound(double begin2, double end2) noexcept {
    is_bound_ = true;
    bounds2_ = {begin2, end2};
}

bool PathLaw::bound_now(double begin2, double end2) noexcept {
    const double share = way_ / limits_.timing().length;
    const double speed_now = speed() / limits_.period_s();
    if (is_bound_) begin2 = std::min(begin2, bounds2_[0]);
    if (is_bound_) end2 = std::min(end2, bounds2_[1]);
    if (speed_now * speed_now > begin2 + share * (end2 - begin2)) return false;
    bound(begin2, end2);
    bound_target();
    if (!is_resting_) restart();
    return true;
}

void PathLaw::loosen_bounds(double begin2, double end2) noexcept {
    bound(begin2, end2);
    loosen();
}

void PathLaw::unbound() noexcept {
    if (!is_bound_) return;
    is_bound_ = false;
    loosen();
}

// The lowest of some timings asks of no axis more than one of them does: at both ends the lowest counts.
void PathLaw::bound_target() noexcept {
    is_bitten_ = false;
    if (!is_capped_ && !is_bound_) return;
    const PathTiming& timing = limits_.timing();
    const double begin2 = target_.of(timing.start_speed2[0], timing.start_speed2[1]);
    const double end2 = target_.of(timing.end_speed2[0], timing.end_speed2[1]);
    const std::array<double, 2> most2 = most_speed2();
    if (begin2 <= most2[0] && end2 <= most2[1]) return;
    is_bitten_ = true;
    const double per_tick2 = limits_.period_s() * limits_.period_s();
    capped2_ = std::min(begin2, most2[0]) * per_tick2;
    capped_slope_ = (std::min(end2, most2[1]) * per_tick2 - capped2_) / timing.length;
}

// Of cap and bounds, at the segment's begin and end.
std::array<double, 2> PathLaw::most_speed2() const noexcept {
    std::array<double, 2> most2;
    most2.fill(std::numeric_limits<double>::infinity());
    if (is_capped_) most2 = limits_.timing().rest_speed2;
    if (is_bound_) most2 = {std::min(most2[0], bounds2_[0]), std::min(most2[1], bounds2_[1])};
    return most2;
}

double PathLaw::target2_at_end() const noexcept {
    const PathTiming& timing = limits_.timing();
    const double planned2 = target_.of(timing.end_speed2[0], timing.end_speed2[1]);
    return is_bitten_ ? std::min(planned2, most_speed2()[1]) : planned2;
}

void PathLaw::rest() noexcept {
    is_resting_ = true;
    is_following_ = false;
    clock_ = 0.0;
    base_ = way_;
    stand();
}

void PathLaw::stand() noexcept {
    base_speed_ = 0.0;
    half_accel_ = 0.0;
    piece_end_ = is_at_end_ ? -1.0 : std::numeric_limits<double>::infinity();
}

void PathLaw::finish_pieces() noexcept {
    if (is_at_end_) {
        if (clock_ > kMostSpareTicks) clock_ -= 1.0;
        return;
    }
    while (clock_ >= piece_end_) {
        clock_ -= piece_ticks_;
        base_ = end_way_;
        base_speed_ = end_speed_;
        if (ends_segment_) {
            way_ = base_;
            is_at_end_ = true;
            piece_end_ = -1.0;
            half_accel_ = 0.0;
            return;
        }
        begin_piece();
    }
    way_ = base_ + clock_ * (base_speed_ + half_accel_ * clock_);
}

void PathLaw::begin_piece() noexcept {
    if (is_following_) {
        follow();
    } else {
        steer();
    }
    piece_end_ = piece_ticks_ - kEarlyTicks;
}

// To the segment's end in one piece: speed2 is linear in u, so the mean speed in time is the ends' mean.
void PathLaw::follow() noexcept {
    end_way_ = limits_.timing().length;
    end_speed_ = std::sqrt(target2_at_end()) * limits_.period_s();
    ends_segment_ = true;
    piece_ticks_ = 2.0 * (end_way_ - base_) / (base_speed_ + end_speed_);
    half_accel_ = 0.5 * (end_speed_ - base_speed_) / piece_ticks_;
}

// A tick at most towards the target.
void PathLaw::steer() noexcept {
    const SegmentLimits::Profiles profiles = limits_.profiles_at(base_);
    const double target2 = is_bitten_ ? std::max(0.0, capped2_ + capped_slope_ * base_)
                                      : target_.of(profiles.low, profiles.high);
    const double speed2 = base_speed_ * base_speed_;
    const double gap = target2 - speed2;
    if (std::fabs(gap) <= kMetRatio * target2) {
        if (target_.is_rest()) {
            stand();
            piece_ticks_ = piece_end_;
            ends_segment_ = false;
            return;
        }
        is_following_ = true;
        base_speed_ = std::sqrt(target2);
        follow();
        return;
    }
    double accel = gap > 0.0 ? limits_.rising_accel(profiles, base_speed_)
                             : limits_.falling_accel(profiles, base_speed_);
    // Below the profile that rests in time it stays: along a part of it.
    if (gap < 0.0 && is_capped_)
        accel = std::min(accel, limits_.accel_along(limits_.timing().rest_speed2, base_, base_speed_));
    if (gap < 0.0 && is_bound_) accel = std::min(accel, limits_.accel_along(bounds2_, base_, base_speed_));
    cut_short(profiles, gap, accel);
}

// A piece of this acceleration ends after a tick, or sooner: on the target, at speed 0, at the segment's end.
void PathLaw::cut_short(const SegmentLimits::Profiles& profiles, double gap, double accel) noexcept {
    const double left = limits_.timing().length - base_;
    half_accel_ = 0.5 * accel;
    piece_ticks_ = 1.0;
    double way = base_speed_ + half_accel_;
    end_speed_ = base_speed_ + accel;
    if (end_speed_ < 0.0) {
        piece_ticks_ = -base_speed_ / accel;
        way = 0.5 * base_speed_ * piece_ticks_;
        end_speed_ = 0.0;
    }
    const double target_slope =
        is_bitten_ ? capped_slope_ : target_.of(profiles.low_slope, profiles.high_slope);
    const double closing = 2.0 * accel - target_slope;
    bool is_cut = false;
    if (gap * closing > 0.0 && gap / closing < way) {
        way = gap / closing;
        is_cut = true;
    }
    ends_segment_ = left <= way;
    if (ends_segment_) way = left;
    if (is_cut || ends_segment_) {
        end_speed_ = std::sqrt(std::max(0.0, base_speed_ * base_speed_ + 2.0 * accel * way));
        piece_ticks_ = way > 0.0 ? 2.0 * way / (base_speed_ + end_speed_) : 0.0;
    }
    end_way_ = ends_segment_ ? limits_.timing().length : base_ + way;
}

}  // namespace psicarve::cycle
