// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hmi/verify/motor/motion_witness.hpp"
#include "hmi/verify/motor/motor_reach.hpp"
#include "hmi/verify/motor/train_event.hpp"

namespace psicarve::verify {

/// Follows the pulses of one axis: after each, keeps all states that a motor within the limits may be in, its
/// position never more than 1.5 pulses from the count.
///
/// Usually a motion suffices that is never slower, or never faster, than start-stop, and it is cheap to
/// follow (MotionWitness). Where it has to slow down to start-stop, or to leave it, another one continues
/// from where both may be (`turn`). Only when there is none are all motions calculated, from as many events
/// back as are kept (`late_`).
class TrainFollower {
public:
    TrainFollower(const MotorLimits& limits, std::int64_t begin_ns);

    /// False when no motion is left: then it starts anew, with any motion, at this event.
    bool take(const TrainEvent& event);
    /// No event comes up to this time.
    bool wait(std::int64_t time_ns);
    /// Starts with any motion, from here on.
    void start_anew(std::int64_t time_ns);

private:
    static constexpr std::size_t kMostLate = 1024;
    static constexpr std::size_t kFewLate = 64;

    /// An event that `reach_` does not know yet.
    struct Late {
        TrainEvent event{};
        // After it:
        Range slow = Range::none();  ///< positions where a motion is no faster than start-stop
        std::int64_t count = 0;
        bool is_anywhere = false;  ///< `slow` is all the room there is
    };

    void step(const TrainEvent& event);
    void choose_witness();
    void open_window();
    void keep_late(const TrainEvent& event);
    bool turn(const TrainEvent& event);
    MotionWitness slow_witness(std::size_t index) const;
    MotionWitness running_witness(std::size_t index, const TrainEvent& event) const;
    bool go_on(MotionWitness witness, std::size_t index, const TrainEvent& event);
    Late late(const TrainEvent& event, const MotionWitness& witness) const;
    void choose_earlier();
    void choose_anywhere();
    void forget_earlier();
    std::size_t last_settled() const;
    void catch_up();

    MotorReach reach_;  ///< as of `reached_ns_`; what is late is not in it
    std::int64_t reached_ns_;
    std::int64_t count_ = 0;

    // The pulses since a witness was last tried.
    int window_pulses_ = 0;
    std::int64_t window_ns_ = 0;
    std::int64_t window_count_ = 0;
    int patience_ = 0;  ///< how many of them must pass before the next try

    bool has_witness_ = false;
    bool has_turned_ = false;  ///< since it came from the set of all states
    MotionWitness witness_;
    MotionWitness earlier_;  ///< the witness as it was after the first `earlier_count_` of the late events
    std::size_t earlier_count_ = 0;
    std::size_t late_count_ = 0;
    std::array<Late, kMostLate> late_;
};

}  // namespace psicarve::verify
