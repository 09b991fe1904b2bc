// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

namespace psicarve::cycle {

/// The speed of one acceleration group: the original's linear acceleration. The unit of length is one DDA
/// iteration, the unit of time one tick.
///
///     V max     ________                 speeding up    s += V0 + a/2,  V = V0 + a
///              /        \                steady         s += V
///             /          \               slowing down   s += V0 - a/2,  V = max(V0 - a, V start)
///     V start/            \              s >= 1:        s -= 1, one iteration is due
///            |--|        |--|
///          climbed  =   what is left when slowing down starts
///
/// A tick in which V meets Vmax or V start, or in which slowing down starts, is cut there, so that s is the
/// exact area below the line and the group ends at V start. A way too short for Vmax gets a triangle. The
/// last iteration always comes, because V never falls below V start. A ratio below 1 lowers Vmax, and V start
/// where it is above that. RT: yes.
class LinearProfile {
public:
    /// Requires 0 < start <= max <= 1 and accel > 0, per tick.
    void start(double start_speed, double max_speed, double accel, std::uint64_t iterations) noexcept {
        start_speed_ = start_speed;
        max_speed_ = max_speed;
        accel_ = accel;
        left_ = iterations;
        distance_ = 0.0;
        set_bounds();
        rest();
    }

    /// The planned top speed times this, 0 < ratio <= 1, from the next tick on; also for what is started
    /// later.
    void set_ratio(double ratio) noexcept {
        if (ratio == ratio_) return;
        ratio_ = ratio;
        if (accel_ <= 0.0) return;
        set_bounds();
        speed_ = std::max(speed_, least_speed_);
        climbed_ = climb_to(speed_);
    }

    /// One tick passes; `must_slow` slows down whatever is left. Requires that no iteration is due.
    void advance(bool must_slow) noexcept {
        const double spare = static_cast<double>(left_) - distance_ - climbed_;
        if (must_slow || spare <= 0.0) {
            slow_down(1.0, least_speed_);
        } else if (speed_ > top_speed_) {
            // With less than a tick's way to spare, the rest of this tick must not run on at the new top
            // speed.
            slow_down(1.0, spare < speed_ ? least_speed_ : top_speed_);
        } else if (speed_ < top_speed_ && spare >= 2.0 * (speed_ + accel_)) {
            speed_up();
        } else if (spare >= speed_) {
            distance_ += speed_;
        } else {
            distance_ += spare;
            slow_down(1.0 - spare / speed_, least_speed_);
        }
    }

    bool is_due() const noexcept { return distance_ >= 1.0; }
    /// The due iteration goes out; time finer than a tick stays in s.
    void take() noexcept {
        distance_ -= 1.0;
        --left_;
    }

    /// Travelled since the last iteration went out.
    double distance() const noexcept { return distance_; }
    std::uint64_t iterations_left() const noexcept { return left_; }
    double speed() const noexcept { return speed_; }
    bool is_slowest() const noexcept { return speed_ <= start_speed_; }
    /// It stands: what comes next climbs from V start.
    void rest() noexcept {
        speed_ = least_speed_;
        climbed_ = 0.0;
    }

private:
    void set_bounds() noexcept {
        top_speed_ = max_speed_ * ratio_;
        least_speed_ = std::min(start_speed_, top_speed_);
    }
    /// Way from the least speed up to this one.
    double climb_to(double speed) const noexcept {
        return (speed * speed - least_speed_ * least_speed_) / (2.0 * accel_);
    }
    void speed_up() noexcept {
        const double rise = top_speed_ - speed_;
        if (rise >= accel_) {
            climb(speed_ + 0.5 * accel_);
            speed_ += accel_;
            return;
        }
        const double rise_ticks = rise / accel_;
        climb(rise_ticks * 0.5 * (speed_ + top_speed_));
        distance_ += (1.0 - rise_ticks) * top_speed_;
        speed_ = top_speed_;
    }
    void climb(double way) noexcept {
        distance_ += way;
        climbed_ += way;
    }
    void slow_down(double ticks, double to_speed) noexcept {
        const double fall = speed_ - to_speed;
        if (fall >= accel_ * ticks) {
            const double way = ticks * (speed_ - 0.5 * accel_ * ticks);
            distance_ += way;
            climbed_ = std::max(0.0, climbed_ - way);
            speed_ -= accel_ * ticks;
            return;
        }
        const double fall_ticks = fall / accel_;
        distance_ += fall_ticks * 0.5 * (speed_ + to_speed) + (ticks - fall_ticks) * to_speed;
        speed_ = to_speed;
        climbed_ = to_speed > least_speed_ ? climb_to(to_speed) : 0.0;
    }

    double start_speed_ = 0.0;
    double max_speed_ = 0.0;
    double accel_ = 0.0;
    double ratio_ = 1.0;
    double top_speed_ = 0.0;    ///< max_speed_ * ratio_
    double least_speed_ = 0.0;  ///< V start, or less where the ratio asks for less
    double speed_ = 0.0;
    double distance_ = 0.0;  ///< s: travelled and not yet emitted
    double climbed_ = 0.0;   ///< way between the least speed and the present one
    std::uint64_t left_ = 0;
};

}  // namespace psicarve::cycle
