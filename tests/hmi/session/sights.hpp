// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/session/machine_view.hpp"

namespace psicarve::session::test {

constexpr std::uint8_t kAllHomed = 0xF;

/// A simulated machine of the built-in profile in this state.
inline MachineView machine_in(MachineState state, std::uint8_t homed_mask = kAllHomed) {
    MachineView view;
    view.life = CoreLife::alive;
    view.core_pid = 42;
    view.profile = Profile{};
    CoreStatus status{};
    status.heartbeat = 7;
    status.period_ns = 50'000;
    status.state = state;
    status.homed_mask = homed_mask;
    status.is_simulator = 1;
    status.job_generation = 3;
    status.override_percent = 100;
    status.seconds_left = -1.0;
    view.status = status;
    return view;
}

inline MachineView limit_alarm(Axis axis) {
    const auto unhomed = static_cast<std::uint8_t>(1U << index_of(axis));  // by the alarm itself
    MachineView view = machine_in(MachineState::alarm, kAllHomed & static_cast<std::uint8_t>(~unhomed));
    view.status->alarm_cause = AlarmCause::limit;
    view.status->alarm_axis = static_cast<std::uint8_t>(index_of(axis));
    view.status->alarm_count = 1;
    view.status->signals = bit_of(sensor_of(axis));
    view.status->position_pulses[index_of(axis)] = 8484;
    view.status->layer = 314;
    view.status->points_done = 1000;
    view.status->points_total = 2000;
    return view;
}

}  // namespace psicarve::session::test
