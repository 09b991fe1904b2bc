// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/session/machine_sight.hpp"

namespace psicarve::session::test {

constexpr std::uint8_t kAllHomed = 0xF;

/// A simulated machine of the built-in profile in this state.
inline MachineSight machine_in(MachineState state, std::uint8_t homed_mask = kAllHomed) {
    MachineSight sight;
    sight.life = CoreLife::alive;
    sight.core_pid = 42;
    sight.profile = Profile{};
    CoreStatus status{};
    status.heartbeat = 7;
    status.period_ns = 50'000;
    status.state = state;
    status.homed_mask = homed_mask;
    status.is_simulator = 1;
    status.job_generation = 3;
    status.override_percent = 100;
    status.seconds_left = -1.0;
    sight.status = status;
    return sight;
}

inline MachineSight limit_alarm(Axis axis) {
    const auto unhomed = static_cast<std::uint8_t>(1U << index_of(axis));  // by the alarm itself
    MachineSight sight = machine_in(MachineState::alarm, kAllHomed & static_cast<std::uint8_t>(~unhomed));
    sight.status->alarm_cause = AlarmCause::limit;
    sight.status->alarm_axis = static_cast<std::uint8_t>(index_of(axis));
    sight.status->alarm_count = 1;
    sight.status->signals = bit_of(sensor_of(axis));
    sight.status->position_pulses[index_of(axis)] = 8484;
    sight.status->layer = 314;
    sight.status->points_done = 1000;
    sight.status->points_total = 2000;
    return sight;
}

}  // namespace psicarve::session::test
