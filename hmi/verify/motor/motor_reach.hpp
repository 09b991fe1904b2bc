// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "hmi/verify/motor/state_set.hpp"

namespace psicarve::verify {

/// What a motor can do: |speed| <= speed, |acceleration| <= accel, except that any speed up to `jump` may
/// change into any other such speed at once.
struct MotorLimits {
    double accel_pps2 = 1.0;
    double speed_pps = 1.0;
    double jump_pps = 0.0;

    /// The longest step of time in which sets of states are exact enough.
    double step_s() const noexcept { return std::sqrt(16.0 * kStepError_pulses / accel_pps2); }
    static constexpr double kStepError_pulses = 2e-3;
};

/// The set of all states that a motor may be in, given the rooms that it had to stay in so far.
///
///     speed                        Up to +-jump speeds change at will: a position there holds all of them,
///       |   ______                 so a range of positions describes them (`slow`).
///       |  / up   |                Above, acceleration is bounded. A set stays convex while the motor keeps
///     j |_/_______|___             moving; states that start from `slow` while older ones still run make a
///       |  |   slow   |            set of their own, until the two are convex together.
///    -j |__|__________|            Below -jump everything is the mirror image.
///       |    \ down /
///       +--------------- position
class MotorReach {
public:
    explicit MotorReach(const MotorLimits& limits);

    /// Any state in the room.
    void start_anywhere(Range room);
    /// A position somewhere in a range, no faster than `jump`.
    void start_slow(Range positions);
    /// It is in one of these states, faster than `jump`; `states` are mirrored when it goes down.
    void start_running(const StateSet& states, bool is_upward);
    /// Lets time pass; the motor stays in the room.
    void run(double time_s, Range room);
    /// The motor is in the room now.
    void cut(Range room);
    /// Every speed may change by up to `jump` at once (a joint).
    void jump();
    /// After this long in a room, begun with slow states in `slow` and any others, the states before make no
    /// difference any more, not even by rounding. Infinite where that is not known.
    double surely_settled_after_s(Range slow, Range room) const noexcept;

    bool is_empty() const noexcept { return slow_.is_empty() && up_.count == 0 && down_.count == 0; }
    /// Positions where it may be no faster than `jump`.
    Range slow() const noexcept { return slow_; }
    /// Faster states one way, one convex set of them; empty when there are none.
    const StateSet& running(bool is_upward) const noexcept;
    /// Whether one such set holds all states.
    bool is_running_only() const noexcept { return slow_.is_empty() && up_.count + down_.count == 1; }
    const MotorLimits& limits() const noexcept { return limits_; }
    /// Largest distance that joining two sets added to their positions so far [pulses].
    double widest_joint() const noexcept { return widest_joint_; }

private:
    static constexpr std::size_t kMostSets = 4;
    struct Branch {
        std::array<StateSet, kMostSets> sets;
        std::size_t count = 0;
    };
    double slowed_after_s() const noexcept;
    void step(double time_s, Range room);
    Range run_branch(Branch& branch, double time_s, double far_wall);
    struct Launch {
        Range from;    ///< positions at slow speeds before the step
        Range now;     ///< and after it
        bool is_held;  ///< a set of the branch had the row `from`
    };
    bool holds_row(const Branch& branch, Range row) const noexcept;
    void launch(Branch& branch, const Launch& row, double time_s, double far_wall);
    void add(Branch& branch, const StateSet& set);
    void cut_branch(Branch& branch, Range room);
    void drop_empty(Branch& branch) noexcept;
    double most_in_room_pps(Range room) const noexcept;
    void settle(Range room);

    MotorLimits limits_;
    double step_s_;      ///< longest step that is exact enough
    double full_s_ = 0;  ///< for how long `slow_` has filled the room
    bool is_settled_ = false;
    double widest_joint_ = 0.0;
    Range slow_ = Range::none();
    Branch up_;
    Branch down_;  ///< mirrored: positions and speeds negated
};

}  // namespace psicarve::verify
