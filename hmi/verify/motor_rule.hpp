// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "hmi/verify/motor/train_follower.hpp"
#include "hmi/verify/offence_log.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// Rule 3: the motor can follow. For each axis there is a motion p(t) with |p'| <= v_k and |p''| <= a_k,
/// except jumps of at most j_k at rest or reversal, and the count is within 1.5 pulses of p(t) at all times.
/// docs/motor_limits.md says how it is decided.
///
/// An event that stops pulses at once (emergency stop, limit, a drive switched off) is not judged: the rule
/// forgets the motion then.
class MotorRule {
public:
    MotorRule(const Profile& profile, OffenceLog& log);

    void begin(std::int64_t period_ns);
    void pulse(Axis axis, bool positive, std::int64_t time_ns, const CarvePlace& place);
    /// A point of the job was reached: with planner "angle" speeds may jump here.
    void point_reached(std::int64_t time_ns, const CarvePlace& place);
    void levels_changed(SignalWord before, SignalWord now, std::int64_t time_ns);
    void finish(std::int64_t time_ns);

private:
    struct Entry {
        TrainEvent event;
        CarvePlace place;
    };
    struct Train {
        MotorLimits limits;
        double pulses_per_unit = 1.0;
        TrainFollower follower{{}, 0};
        std::int64_t silent_until_ns = 0;  ///< not judged before
        std::vector<Entry> history;        ///< ring
        std::uint64_t entries = 0;         ///< since it was last forgotten
        bool is_broken = false;            ///< at `broken_at`; the events after it are being gathered
        Entry broken_at;
        std::uint64_t gathered = 0;
    };
    void take(Axis axis, const Entry& entry);
    void found(Train& train, const Entry& entry);
    void forget(Axis axis, std::int64_t until_ns);
    void describe(Axis axis);

    OffenceLog& log_;
    std::array<Train, kAxisCount> trains_;
    bool has_joints_ = false;
    std::int64_t filter_ns_ = 0;
    std::int64_t reaction_ns_ = 0;
};

}  // namespace psicarve::verify
