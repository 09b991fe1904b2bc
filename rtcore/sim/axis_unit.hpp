// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/sim/counter.hpp"
#include "rtcore/sim/motor.hpp"
#include "rtcore/sim/sensor.hpp"
#include "rtcore/sim/sim_config.hpp"
#include "rtcore/sim/sim_report.hpp"

namespace psicarve::sim {

/// One axis from its driver's inputs to its sensor: driver, motor, screw with backlash, mechanical stops.
/// Takes edges, not levels: the machine calls what changed, direction and enable before step. RT: yes. Its
/// members: parts, when each input changed last, and a counter for each way in which a pulse may be lost.
class AxisUnit {
public:
    AxisUnit(const AxisConfig& config, const DriverTiming& timing) noexcept;

    void set_direction(bool positive, std::int64_t time_ns) noexcept;
    void set_enabled(bool enabled) noexcept;
    void step_rises(std::int64_t time_ns) noexcept;
    void step_falls(std::int64_t time_ns) noexcept;

    /// When settle() is due; kForeverNs at rest.
    std::int64_t settle_due_ns() const noexcept { return settle_due_ns_; }
    void settle() noexcept { come_to_rest(motor_.settle()); }
    /// Moves the mechanics without a pulse.
    void slip(std::int64_t pulses) noexcept;

    std::int64_t position_pulses() const noexcept { return load_pulses_.get(); }
    std::uint64_t pulses_taken() const noexcept { return taken_.count(); }
    Sensor& sensor() noexcept { return sensor_; }
    AxisReport report() const noexcept;

private:
    void take_pulse(std::int64_t time_ns) noexcept;
    void come_to_rest(bool ran_past) noexcept;
    void lose_last_pulse(Counter& why) noexcept;
    void note_stall() noexcept;
    void move_load() noexcept;

    AxisConfig config_;
    DriverTiming timing_;
    Motor motor_;
    Sensor sensor_;
    int direction_ = -1;
    bool enabled_ = false;
    bool last_pulse_counts_ = false;  ///< the motor followed it, and its timing may still prove wrong
    bool at_stop_ = false;
    int last_direction_ = 0;  ///< of the last pulse
    std::int64_t direction_changed_ns_ = -kForeverNs;
    std::int64_t step_rose_ns_ = -kForeverNs;
    std::int64_t step_fell_ns_ = -kForeverNs;
    std::int64_t settle_due_ns_ = kForeverNs;
    Counter motor_pulses_;
    Counter load_pulses_;
    Counter taken_;
    Counter ignored_;
    Counter lost_dir_setup_;
    Counter lost_dir_hold_;
    Counter lost_step_high_;
    Counter lost_step_low_;
    Counter stalls_;
    Counter lost_stalled_;
    Counter slipped_;
    Counter crashes_;
    Counter lost_at_stop_;
};

}  // namespace psicarve::sim
