// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shared/profile/profile.hpp"

namespace psicarve::two_process {

/// A coarse, slow and small machine: a gap in ticks that a busy computer makes, up to half a second, loses no
/// step of it, and it homes in seconds.
/// Its first approach is no faster than it can stop within a few pulses, for it goes back over them at
/// start-stop speed.
inline Profile slow_machine() {
    Profile profile;
    profile.name = "slow";
    profile.tick.period_us = 1000.0;
    profile.tick.missed_alarm_per_s = 0;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->pulses_per_mm = 10.0;
        axis->speed_mm_s = 50.0;
        axis->accel_mm_s2 = 2000.0;
        axis->start_stop_mm_s = 0.2;
        axis->home_speed_mm_s = 20.0;
        axis->overtravel_mm = 3.0;
        axis->travel_mm = {0.0, 20.0};
    }
    profile.r1.home_position_mm = 20.0;
    profile.r2.home_position_mm = 20.0;
    profile.psi.pulses_per_rev = 200;
    profile.psi.speed_deg_s = 360.0;
    profile.psi.accel_deg_s2 = 7200.0;
    profile.psi.start_stop_deg_s = 3.6;
    profile.psi.home_speed_deg_s = 180.0;
    profile.job.feed_mm_s = 200.0;
    profile.job.plunge_mm_s = 50.0;
    profile.job.spindle_spinup_s = 0.1;
    return profile;
}

/// The machine is homed where it stands. This is for tests of a homed machine that do not test homing, which
/// takes ten seconds on the real clock.
inline void take_sensors_away(Profile& profile) {
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) axis->home = HomeSensor::none;
    profile.psi.home = HomeSensor::none;
}

/// As well, but for R1, which looks for its limit.
inline void leave_one_sensor(Profile& profile) {
    const HomeSensor of_r1 = profile.r1.home;
    take_sensors_away(profile);
    profile.r1.home = of_r1;
}

}  // namespace psicarve::two_process
