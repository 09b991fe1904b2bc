// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "hmi/verify/offence_log.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// Rule 4: no pulse while the axis is disabled, in alarm, or past a limit in the limit's direction; except
/// the axis being homed, for so long as braking from home speed takes.
///
/// A trace shows pins, not states. Homing is told from a crash like this: with the spindle on a tripped limit
/// is a crash at once. With the spindle off, pulses past the sensor wait for judgement: homing ends with a
/// new definition of the positions or with the axis backing off until its sensor clears (a definition that
/// changes nothing is not written to every trace); a crash ends with the drive switched off, the spindle
/// switched on or the end of the trace. More pulses than homing may take are an offence either way. The core
/// has one tick to act (schedule two-timer: one io period), for limits after the input filter.
class PermissionRule {
public:
    PermissionRule(const Profile& profile, OffenceLog& log);

    /// `period_ns` 0: the profile's. Wires that the trace does not have are not judged.
    void begin(SignalWord initial_levels, SignalWord present, std::int64_t period_ns);
    /// Call it for any change of levels, before the pulses of the same event are judged.
    void levels_changed(SignalWord before, SignalWord now, std::int64_t time_ns);
    void rising(Axis axis, bool positive, std::int64_t time_ns, const CarvePlace& place);
    void positions_redefined();
    void finish();

private:
    static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::min() / 2;
    struct Guard {
        int limit_sign = 0;              ///< direction of the limit; 0: the axis has none
        std::int64_t homing_pulses = 0;  ///< that homing may take past the sensor
        bool tripped = false;
        bool tripped_while_carving = false;  ///< with the spindle on
        std::int64_t tripped_ns = kNever;
        std::int64_t crash_ns = kNever;     ///< last trip with the spindle on, chatter excluded
        std::int64_t disabled_ns = kNever;  ///< when the drive was last switched off
        std::int64_t beyond_pulses = 0;     ///< net way past the sensor since it tripped
        bool is_leaving = false;            ///< the last pulse since then led away from the sensor
        std::uint64_t waiting = 0;          ///< pulses whose judgement depends on later events
        std::int64_t first_waiting_ns = 0;
        CarvePlace first_waiting_place;
    };
    bool has(Signal signal) const noexcept { return (present_ & bit_of(signal)) != 0; }
    void limit_changed(Guard& guard, bool tripped, std::int64_t time_ns);
    void judge_waiting(Axis axis);
    void judge_alarm(Axis axis, std::int64_t time_ns, const CarvePlace& place);
    void judge_limit(Axis axis, bool positive, std::int64_t time_ns, const CarvePlace& place);
    struct Finding {
        const char* fault;
        std::string text;  ///< after the axis' name
        double measured;
        double allowed;
        const char* unit;
    };
    void report(Axis axis, std::int64_t time_ns, const Finding& finding, const CarvePlace& place);

    OffenceLog& log_;
    std::array<Guard, kAxisCount> guards_;
    SignalWord levels_ = 0;
    SignalWord present_ = 0;
    bool two_timer_ = false;
    std::int64_t period_ns_ = 0;    ///< the profile's
    std::int64_t reaction_ns_ = 0;  ///< the core's time to act on an input
    std::int64_t filter_ns_ = 0;
    std::int64_t estop_ns_ = kNever;  ///< when it last tripped
    bool is_calm_ = true;             ///< no input has tripped yet: only the drive needs checking
};

}  // namespace psicarve::verify
