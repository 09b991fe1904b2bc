// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/cycle/path_target.hpp"
#include "rtcore/cycle/segment_limits.hpp"

namespace psicarve::cycle {

/// The motion along a timed curve, tick by tick: how far u has come within the segment at hand. Time is cut
/// into pieces of constant d2u/dt2, and finer than a tick it goes on from piece to piece and from segment to
/// segment, so that nothing adds up.
///
///     (du/dt)^2                 ___________ profile [1], 200 %
///          |        ___________/           \_
///          |    ___/   _______________       \       the target is a scaled or mixed profile. On it a
///          |   /  ____/ profile [0]   \___    |      segment is one piece. Away from it (after hold,
///          |  / _/    ..........>.....    \   |      resume or override, dotted) a piece is a tick, and
///          | |_/     / target           .. |  |      its acceleration the largest that is known to be
///          +--------------------------------------- u     allowed at this place and speed.
///
/// What an axis may do is linear in speed2 and its slope: so between any two allowed motions lies an allowed
/// one, and a profile scaled down is allowed. Docs: interpolation.md. RT: yes. Its members: the piece at
/// hand, the bounds on it and where on it the clock is. They stay together, since every tick reads most of
/// them.
class PathLaw {
public:
    explicit PathLaw(double period_s) noexcept : limits_(period_s) {}

    /// A run begins from rest, as fast as its target does.
    void start(const PathTiming& timing) noexcept;
    /// It goes on from a rest at an open end: with a jump to the start-stop speed at most.
    void start_again(const PathTiming& timing) noexcept;
    /// The next segment, with the time that was left over. Requires is_at_end().
    void next(const PathTiming& timing) noexcept;

    /// From the next tick on: so much of the planned feed, 0 to 2, and such a part of that; 0 slows down
    /// until rest() is called. From rest it starts again, with a jump to the start-stop speed at most.
    void aim(double feed_ratio, double part = 1.0) noexcept;

    /// Called before a segment is entered, with true at a group's begin alone: in this one and those after it
    /// it stays below their profile that rests where what is queued ends. Lifted at any time.
    void cap(bool is_capped) noexcept;
    bool is_capped() const noexcept { return is_capped_; }

    /// Called before a segment is entered: there (du/dt)^2 stays below what lies between these. The one
    /// before it allows no less at its end than this at its begin.
    void bound(double begin2, double end2) noexcept;
    /// The same in the segment at hand, from now on, besides bounds that it has. False, and nothing is done:
    /// it is too fast already.
    bool bound_now(double begin2, double end2) noexcept;
    /// In the segment at hand, from now on: requires that they allow no less than those that it has.
    void loosen_bounds(double begin2, double end2) noexcept;
    /// From now on, or from the next segment on, there are no such bounds.
    void unbound() noexcept;

    /// One tick passes. Requires that it does not rest.
    void tick() noexcept {
        clock_ += 1.0;
        if (clock_ < piece_end_) {
            way_ = base_ + clock_ * (base_speed_ + half_accel_ * clock_);
        } else {
            finish_pieces();
        }
    }

    /// u since the segment's begin.
    double way() const noexcept { return way_; }
    bool is_at_end() const noexcept { return is_at_end_; }

    /// It may come to rest with a jump from here.
    bool is_slowest() const noexcept { return speed() <= limits_.start_stop_speed(); }
    void rest() noexcept;

    /// du/dt and d2u/dt2 now, per tick.
    double speed() const noexcept {
        const double speed = is_at_end_ ? base_speed_ : base_speed_ + 2.0 * half_accel_ * clock_;
        return speed > 0.0 ? speed : 0.0;
    }
    double accel() const noexcept { return 2.0 * half_accel_; }

private:
    /// What is due within this part of a tick is due now: an instant on the tick must not fall behind it by
    /// rounding.
    static constexpr double kEarlyTicks = 1e-9;
    /// Time that passes at a segment's end, while its last iteration waits, for the next segment to make up.
    static constexpr double kMostSpareTicks = 2.0;

    void enter(const PathTiming& timing) noexcept;
    void restart() noexcept;
    void loosen() noexcept;
    void bound_target() noexcept;
    std::array<double, 2> most_speed2() const noexcept;
    double target2_at_end() const noexcept;
    void finish_pieces() noexcept;
    void begin_piece() noexcept;
    void follow() noexcept;
    void steer() noexcept;
    void cut_short(const SegmentLimits::Profiles& profiles, double gap, double accel) noexcept;
    void stand() noexcept;

    double clock_ = 0.0;  ///< ticks since the piece began; at the segment's end, since then
    double piece_end_ = std::numeric_limits<double>::infinity();
    double base_ = 0.0;  ///< where the piece began
    double base_speed_ = 0.0;
    double half_accel_ = 0.0;
    double way_ = 0.0;

    double piece_ticks_ = 0.0;
    double end_way_ = 0.0;  ///< where the piece ends, and how fast
    double end_speed_ = 0.0;
    bool ends_segment_ = false;  ///< the piece does
    bool is_at_end_ = true;
    bool is_following_ = true;  ///< on the target
    bool is_resting_ = false;

    bool is_capped_ = false;
    bool is_bound_ = false;
    std::array<double, 2> bounds2_{};
    bool is_bitten_ = false;  ///< cap or bounds are lower than the target in the segment at hand
    double capped2_ = 0.0;    ///< then: the lowest of them at its begin, per tick, and its slope
    double capped_slope_ = 0.0;

    PathTarget target_;
    SegmentLimits limits_;
};

}  // namespace psicarve::cycle
