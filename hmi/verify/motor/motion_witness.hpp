// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/verify/motor/motor_reach.hpp"
#include "hmi/verify/motor/state_set.hpp"
#include "hmi/verify/motor/train_event.hpp"

namespace psicarve::verify {

/// Some of the motions that a motor may be making: those that stay within the start-stop speeds, or those one
/// way that never come down to them. As long as one of them exists the others need not be calculated.
class MotionWitness {
public:
    MotionWitness() = default;
    /// No motion yet.
    explicit MotionWitness(const MotorLimits& limits) : limits_(limits) {}

    void start_slow(Range positions, std::int64_t time_ns, std::int64_t count);
    /// `is_whole`: there are no other motions.
    void start_running(const StateSet& states, bool is_whole, bool is_upward, std::int64_t time_ns,
                       std::int64_t count);

    /// False: no such motion is left.
    bool take(const TrainEvent& event);

    bool is_slow() const noexcept { return is_slow_; }
    /// Positions where it may be no faster than start-stop now.
    Range slow_positions() const noexcept;
    /// True: slow, and no slow motion is left out: the motor may be anywhere in the room.
    bool is_anywhere() const noexcept { return is_slow_ && is_anywhere_; }
    /// No motion was left out so far.
    bool is_whole() const noexcept { return is_whole_; }
    /// Gives all its motions to a set of states that was empty.
    void hand_to(MotorReach& reach) const;
    std::int64_t time_ns() const noexcept { return time_ns_; }
    std::int64_t count() const noexcept { return count_; }

private:
    bool take_slow(const TrainEvent& event, double time_s);
    bool take_running(const TrainEvent& event, double time_s);

    MotorLimits limits_;
    bool is_slow_ = true;
    bool is_anywhere_ = false;
    bool is_whole_ = false;
    bool is_upward_ = true;
    Range slow_ = Range::none();
    StateSet running_;  ///< mirrored when it goes down
    std::int64_t time_ns_ = 0;
    std::int64_t count_ = 0;
};

}  // namespace psicarve::verify
