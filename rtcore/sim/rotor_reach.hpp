// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "rtcore/sim/sim_config.hpp"

namespace psicarve::sim {

/// The set of all states (position, speed) that a rotor can be in if it stays in a room around its field,
/// carried from one moment to the next. Empty: no motion within the motor's limits stays there, so a real
/// rotor has lost its field.
///
/// Speeds within +-start_stop_pps change at will: a range of positions describes these states. Faster states,
/// upward and downward, are a convex polygon each; states that start from the slow ones join the polygon's
/// hull. RT: yes.
class RotorReach {
public:
    struct Room {
        double low;
        double high;
    };
    struct State {
        double pulses;
        double pps;
    };

    explicit RotorReach(const MotorConfig& config) noexcept;

    void start_at_rest(Room room) noexcept;
    void start_anywhere(Room room) noexcept;
    /// Lets time pass; the rotor is in the room at its end. Exact to accel * time^2 / 16 pulses.
    void advance(double time_s, Room room) noexcept;

    bool is_empty() const noexcept { return !can_rest() && up_.size == 0 && down_.size == 0; }
    /// Whether a state is left with a speed of at most start-stop.
    bool can_rest() const noexcept { return slow_.low <= slow_.high; }
    /// One of the states, well inside.
    State middle() const noexcept;

private:
    static constexpr std::size_t kCorners = 20;  ///< that are kept
    /// A convex polygon, counter-clockwise.
    struct Corners {
        std::array<State, 4 * (kCorners + 4)> at;
        std::size_t size = 0;

        void add(State state) noexcept { at[size++] = state; }
        void take_hull() noexcept;
        void reduce() noexcept;
        /// Keeps the part where `pulses * state.pulses + pps * state.pps <= limit`.
        void clip(double pulses, double pps, double limit) noexcept;
    };
    Room advance_branch(Corners& branch, double sign, double time_s, Room room) const noexcept;

    MotorConfig config_;
    double slow_pps_;
    Room slow_{1.0, 0.0};
    Corners up_;
    Corners down_;
};

}  // namespace psicarve::sim
