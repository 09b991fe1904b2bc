// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/path_law.hpp"

#include <algorithm>
#include <cmath>

namespace psicarve::cycle {
namespace {

// So close to the target's speed squared it is met; the step is far below what any axis notices.
constexpr double kMetRatio = 1e-12;
// Of the acceleration that is left, so much is used to get to the target. The rest pays for the pulses' being
// whole and on ticks, which a plan that goes to the limit has spent already.
constexpr double kSteeringShare = 0.97;

/// d2u/dt2 of motions that are known to be allowed here: along the profile of which the speed at hand is a
/// part or a mixture, and along the 200 % profile scaled down.
struct Known {
    double mixed;
    double scaled;
};

double part_of(double speed2, double profile, double slope) noexcept {
    return 0.5 * slope * (profile > 0.0 ? std::min(1.0, speed2 / profile) : 1.0);
}

Known known_accels(const PathLaw::Profiles& profiles, double speed2) noexcept {
    Known known{};
    known.scaled = part_of(speed2, profiles.high, profiles.high_slope);
    if (speed2 <= profiles.low || profiles.high <= profiles.low) {
        known.mixed = part_of(speed2, profiles.low, profiles.low_slope);
        return known;
    }
    const double share = std::min(1.0, (speed2 - profiles.low) / (profiles.high - profiles.low));
    known.mixed = 0.5 * (profiles.low_slope + share * (profiles.high_slope - profiles.low_slope));
    return known;
}

}  // namespace

void PathLaw::start(const PathTiming& timing) noexcept {
    clock_ = 0.0;
    is_following_ = true;
    is_resting_ = false;
    const double speed2 = target_of(timing.start_speed2[0], timing.start_speed2[1]);
    end_speed_ = std::sqrt(speed2) * period_s_;
    enter(timing);
}

void PathLaw::next(const PathTiming& timing) noexcept {
    end_speed_ = base_speed_;
    enter(timing);
}

void PathLaw::enter(const PathTiming& timing) noexcept {
    timing_ = timing;
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

void PathLaw::aim(double feed_ratio) noexcept {
    if (feed_ratio == feed_ratio_) return;
    feed_ratio_ = feed_ratio;
    const double square = feed_ratio * feed_ratio;
    high_share_ = std::max(0.0, (square - 1.0) / 3.0);
    low_share_ = square <= 1.0 ? square : 1.0 - high_share_;
    is_following_ = false;
    const double speed_now = speed();
    base_speed_ = speed_now;
    if (is_resting_ && feed_ratio > 0.0) {
        const Profiles profiles = profiles_at(way_);
        base_speed_ = std::min(start_stop_speed(), std::sqrt(target_of(profiles.low, profiles.high)));
        is_resting_ = false;
    }
    if (is_at_end_) return;
    base_ = way_;
    clock_ = 0.0;
    begin_piece();
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
    end_way_ = timing_.length;
    end_speed_ = std::sqrt(target_of(timing_.end_speed2[0], timing_.end_speed2[1])) * period_s_;
    ends_segment_ = true;
    piece_ticks_ = 2.0 * (end_way_ - base_) / (base_speed_ + end_speed_);
    half_accel_ = 0.5 * (end_speed_ - base_speed_) / piece_ticks_;
}

// A tick at most towards the target.
void PathLaw::steer() noexcept {
    const Profiles profiles = profiles_at(base_);
    const double target2 = target_of(profiles.low, profiles.high);
    const double speed2 = base_speed_ * base_speed_;
    const double gap = target2 - speed2;
    if (std::fabs(gap) <= kMetRatio * target2) {
        if (feed_ratio_ == 0.0) {
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
    cut_short(profiles, gap, gap > 0.0 ? rising_accel(profiles) : falling_accel(profiles));
}

// A piece of this acceleration ends after a tick, or sooner: on the target, at speed 0, at the segment's end.
void PathLaw::cut_short(const Profiles& profiles, double gap, double accel) noexcept {
    const double left = timing_.length - base_;
    half_accel_ = 0.5 * accel;
    piece_ticks_ = 1.0;
    double way = base_speed_ + half_accel_;
    end_speed_ = base_speed_ + accel;
    if (end_speed_ < 0.0) {
        piece_ticks_ = -base_speed_ / accel;
        way = 0.5 * base_speed_ * piece_ticks_;
        end_speed_ = 0.0;
    }
    const double closing = 2.0 * accel - target_of(profiles.low_slope, profiles.high_slope);
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
    end_way_ = ends_segment_ ? timing_.length : base_ + way;
}

PathLaw::Profiles PathLaw::profiles_at(double way) const noexcept {
    const double per_tick2 = period_s_ * period_s_;
    Profiles found{};
    found.low_slope = (timing_.end_speed2[0] - timing_.start_speed2[0]) / timing_.length * per_tick2;
    found.high_slope = (timing_.end_speed2[1] - timing_.start_speed2[1]) / timing_.length * per_tick2;
    found.low = std::max(0.0, timing_.start_speed2[0] * per_tick2 + found.low_slope * way);
    found.high = std::max(found.low, timing_.start_speed2[1] * per_tick2 + found.high_slope * way);
    return found;
}

/// The acceleration that every axis has left at this speed, either way; may be negative: then none is known.
double PathLaw::spare_accel(double speed2) const noexcept {
    const double per_tick2 = period_s_ * period_s_;
    double spare = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        spare = std::min(spare,
                         double{timing_.accel_free[k]} * per_tick2 - double{timing_.accel_bend[k]} * speed2);
    }
    return spare > 0.0 ? kSteeringShare * spare : spare;
}

double PathLaw::rising_accel(const Profiles& profiles) const noexcept {
    const double speed2 = base_speed_ * base_speed_;
    const Known known = known_accels(profiles, speed2);
    double accel = std::max(known.mixed, known.scaled);
    const double spare = spare_accel(speed2);
    if (spare <= 0.0) return accel;
    // Faster at the tick's end, less is left: what is left there is safe all the way.
    const double faster = base_speed_ + spare;
    return std::max({accel, 0.0, spare_accel(faster * faster)});
}

double PathLaw::falling_accel(const Profiles& profiles) const noexcept {
    const double speed2 = base_speed_ * base_speed_;
    const Known known = known_accels(profiles, speed2);
    const double accel = std::min(known.mixed, known.scaled);
    const double spare = spare_accel(speed2);
    return spare > 0.0 ? std::min(accel, -spare) : accel;
}

}  // namespace psicarve::cycle
