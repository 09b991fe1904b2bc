// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "hmi/surface/job_geometry.hpp"
#include "hmi/trace/backlash.hpp"
#include "hmi/trace/trace_reader.hpp"
#include "hmi/verify/motor_rule.hpp"
#include "hmi/verify/offence_log.hpp"
#include "hmi/verify/permission_rule.hpp"
#include "hmi/verify/timing_rule.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// Judges where the axes are, after each instant.
class PositionJudge {
public:
    virtual ~PositionJudge() = default;
    /// After each instant in which an axis moved, or the spindle or a switched output was switched.
    virtual void settle(std::int64_t time_ns, const Positions& positions, SignalWord levels) = 0;
    /// Homing defined the positions anew.
    virtual void redefine(std::int64_t time_ns, const Positions& positions) = 0;
};

/// Makes pulses and positions of pins. Judges single pulses by rules 2 to 4, and gives positions to whoever
/// judges these. All pulses of one instant belong together: positions are judged after it.
class PinRules {
public:
    /// `place` is where offences are said to be. All but the profile outlive this.
    PinRules(const Profile& profile, OffenceLog& log, const CarvePlace& place, PositionJudge& judge);

    /// Refused where the trace cannot be of this profile's machine: nothing is to be judged then.
    Result<void> begin(const TraceStart& start);
    void feed(std::span<const TraceEvent> events);
    /// The last instant's positions.
    void settle();
    /// Behind settle(): ends rules 3 and 4.
    void finish();
    /// With planner "angle" speeds may jump here.
    void point_reached();

    /// All wires, as they are now; a spindle that is not in the trace is on.
    SignalWord levels() const noexcept {
        return spindle_bit_ == 0 ? levels_ | bit_of(Signal::spindle) : levels_;
    }
    bool spindle_on() const noexcept { return (levels() & bit_of(Signal::spindle)) != 0; }
    const Positions& positions() const noexcept { return positions_; }
    const std::array<std::uint64_t, kAxisCount>& pulses() const noexcept { return pulses_; }
    std::int64_t instant_ns() const noexcept { return instant_ns_; }
    std::uint64_t events() const noexcept { return events_; }

private:
    void pins(const TraceEvent& event);
    void pulse(Axis axis);
    void redefine(const TraceEvent& event);

    const CarvePlace& place_;
    PositionJudge& judge_;
    TimingRule timing_;
    MotorRule motors_;
    PermissionRule permission_;
    Backlash backlash_;
    SignalWord levels_ = 0;
    SignalWord spindle_bit_ = 0;  ///< 0: not in the trace
    std::int64_t instant_ns_ = 0;
    bool unsettled_ = false;  ///< the instant moved an axis or switched the spindle or an output
    Positions positions_{};
    std::array<std::uint64_t, kAxisCount> pulses_{};
    std::uint64_t events_ = 0;
};

}  // namespace psicarve::verify
