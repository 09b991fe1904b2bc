// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/cycle/path_law.hpp"

namespace psicarve::cycle {

/// Whether time passes in a segment at all. What does not end would hold the machine for good, without a
/// word. RT: yes.
constexpr bool can_end(const PathTiming& timing) noexcept {
    return timing.length > 0.0 && timing.start_speed2[0] >= 0.0 && timing.end_speed2[0] >= 0.0 &&
           timing.start_speed2[0] + timing.end_speed2[0] > 0.0;
}

/// When the iterations of a path's segments are due. They lie evenly on the way of u, from which the path law
/// makes time; the last is due with the segment's end, so that way and pulses end together:
///
///     u  0 ------ 1 ------ 2 ------ 3 ------ 4 = length     segment of 4 iterations
///
/// Time passes by tick(), and stands still once two iterations are due: so a short wait for the pins is made
/// up for, and a burst never comes. RT: yes.
class PathPace {
public:
    explicit PathPace(double period_s) noexcept : law_(period_s) {}

    /// A run begins, from rest. All three require that the segment can_end().
    void start(const PathTiming& timing, std::int64_t iterations) noexcept {
        law_.start(timing);
        spread(timing, iterations);
    }
    /// A run that has come to rest at an open end goes on.
    void start_again(const PathTiming& timing, std::int64_t iterations) noexcept {
        law_.start_again(timing);
        spread(timing, iterations);
    }
    /// The run's next segment. Requires is_at_end().
    void next(const PathTiming& timing, std::int64_t iterations) noexcept {
        law_.next(timing);
        spread(timing, iterations);
    }

    void tick() noexcept {
        if (law_.way() < due_way_ + iteration_way_) law_.tick();
    }
    /// Whether the next iteration is due, when so many of the segment are not made yet.
    bool is_due(std::int64_t left) const noexcept {
        return left > 0 && (law_.is_at_end() || (left > 1 && law_.way() >= due_way_));
    }
    /// The iteration that was due is out.
    void take() noexcept { expect(iteration_ + 1.0); }
    bool is_at_end() const noexcept { return law_.is_at_end(); }
    /// u since the segment's begin.
    double way() const noexcept { return law_.way(); }

    /// From the next tick on: so much of the planned feed, 0 to 2, and such a part of that; 0 slows down
    /// until rest().
    void aim(double feed_ratio, double part = 1.0) noexcept { law_.aim(feed_ratio, part); }
    bool is_slowest() const noexcept { return law_.is_slowest(); }
    /// From the next segment on, or, lifted, from now on: no faster than for a rest at the group's end.
    void cap(bool is_capped) noexcept { law_.cap(is_capped); }
    bool is_capped() const noexcept { return law_.is_capped(); }
    void rest() noexcept { law_.rest(); }
    /// Of the next segment, of that at hand, and none any more, as PathLaw has them.
    void bound(double begin2, double end2) noexcept { law_.bound(begin2, end2); }
    bool bound_now(double begin2, double end2) noexcept { return law_.bound_now(begin2, end2); }
    void loosen_bounds(double begin2, double end2) noexcept { law_.loosen_bounds(begin2, end2); }
    void unbound() noexcept { law_.unbound(); }

private:
    // An iteration that is due at the very instant of a tick must not fall behind it by rounding.
    static constexpr double kEarlyIterations = 1e-9;

    void spread(const PathTiming& timing, std::int64_t iterations) noexcept {
        iteration_way_ = iterations > 0 ? timing.length / static_cast<double>(iterations) : timing.length;
        expect(1.0);
    }
    void expect(double iteration) noexcept {
        iteration_ = iteration;
        due_way_ = (iteration - kEarlyIterations) * iteration_way_;
    }

    PathLaw law_;
    double iteration_ = 0.0;      ///< the number of the next one in its segment, from 1
    double iteration_way_ = 0.0;  ///< from one to the next
    double due_way_ = 0.0;        ///< where the next one is due
};

}  // namespace psicarve::cycle
