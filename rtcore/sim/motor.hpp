// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rtcore/sim/rotor_reach.hpp"
#include "rtcore/sim/sim_config.hpp"

namespace psicarve::sim {

/// A stepper motor that loses steps when it is asked for more than it can.
///
/// The pulses move the *field*; the *rotor* follows it with bounded speed and acceleration. Within +-
/// start_stop_pps it may take any speed at once (what a stepper can jump to from rest or from rest's other
/// side). Towards the field it is driven like a saturated spring and damper: with T = sqrt(2*slip/accel)/4
/// the wanted acceleration is lag/T^2 + 2*(field speed - rotor speed)/T, cut to +-accel, the field's speed
/// being the pulses filtered over T/2. So the spring saturates at an eighth of the slip, far above the pulse
/// or so that quantised ticks put into the count. When the lag exceeds slip_pulses the rotor falls out of
/// step and stands still; pulses are lost until the field is no faster than start_stop_pps, or has rested:
/// then it pulls in where it is.
///
/// A rotor that learns of an acceleration from the pulses alone sets out late, and a motor with nothing to
/// spare never makes up for it. That is a weakness of this spring model, not of the motor. So before the
/// rotor falls out of step, RotorReach says, from what is remembered of the field, whether any motion within
/// the limits stays within an eighth of the slip. If one does the rotor takes it up. So a demand within the
/// limits never stalls, however little there is to spare, and one beyond them does as soon as no motion is
/// left.
///
/// Work is done at step edges alone; between them nothing is simulated. RT: yes. Its members: numbers of its
/// configuration, and the state of field and rotor.
class Motor {
public:
    Motor(const MotorConfig& config, std::int64_t start_pulses) noexcept;

    enum class Outcome : std::uint8_t { followed, fell_out_of_step, lost };
    /// One pulse towards `sign` (+1 or -1) at `time_ns`, which never goes back.
    Outcome pulse(int sign, std::int64_t time_ns) noexcept;
    /// Takes back the pulse just followed: its timing turned out to be wrong.
    void take_back(int sign) noexcept { field_pulses_ -= sign; }

    /// No pulse has come for settle_ns(): the rotor comes to rest. True when it could not stop with the
    /// field and ran past it by more than the slip (counts as falling out of step).
    bool settle() noexcept { return comes_to_rest(true); }
    std::int64_t settle_ns() const noexcept { return settle_ns_; }

    /// The drive was switched off: a rotor faster than start-stop coasts to rest. True when it ran past.
    bool release() noexcept { return comes_to_rest(false); }
    /// Places the rotor here, at rest: a mechanical stop, or a slip.
    void put(std::int64_t pulses) noexcept;

    /// Where the motor is, in whole pulses.
    std::int64_t position_pulses() const noexcept { return field_pulses_; }
    /// How far count and rotor were apart when it last fell out of step.
    std::uint64_t slipped_pulses() const noexcept { return slipped_pulses_; }

private:
    void follow(int sign, std::int64_t time_ns) noexcept;
    void fall_out_of_step(double rotor_pulses) noexcept;
    void remember(std::int64_t time_ns) noexcept;
    RotorReach reach_at(std::int64_t time_ns) const noexcept;
    RotorReach::Room room_at(std::int64_t field_pulses) const noexcept;
    bool take_up_another_motion() noexcept;
    bool comes_to_rest(bool is_held) noexcept;

    /// A past position of the field.
    struct Moment {
        std::int64_t time_ns;
        std::int64_t field_pulses;
    };
    static constexpr std::size_t kMoments = 128;

    MotorConfig config_;
    double spring_s_;  ///< T
    double room_pulses_;
    std::int64_t moment_ns_;  ///< least time between two moments
    std::int64_t lead_ns_;    ///< how long before the first pulse a rotor may set out, within the room
    std::int64_t settle_ns_;
    std::int64_t field_pulses_;
    double rotor_pulses_;
    double rotor_pps_ = 0.0;
    double field_pps_ = 0.0;  ///< filtered
    std::int64_t last_ns_ = 0;
    std::uint64_t slipped_pulses_ = 0;
    bool at_rest_ = true;       ///< no pulse since it settled
    bool speed_known_ = false;  ///< two pulses since it settled
    bool out_of_step_ = false;
    std::array<Moment, kMoments> moments_;  ///< ring
    std::size_t moment_count_ = 0;          ///< since it rested
};

}  // namespace psicarve::sim
