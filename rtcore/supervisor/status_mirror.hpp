// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/realtime/realtime_setup.hpp"
#include "shared/machine/status.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::sim {
class Machine;
}

namespace psicarve::supervisor {

/// What the supervisor knows of the running core besides the tick's own sample.
struct CoreFacts {
    std::int64_t period_ns = 0;
    bool is_simulator = false;
    bool is_virtual_clock = false;
    std::uint8_t missing_sensors_mask = 0;
};

/// Lateness as the base thread counted it; zero on the virtual clock.
struct LatenessFacts {
    std::int64_t max_ns = 0;
    std::array<std::uint64_t, kLatenessBins> histogram{};
};

/// What a simulated machine counted.
struct SimFacts {
    std::array<std::int64_t, kAxisCount> true_position_pulses{};
    std::array<std::uint64_t, kAxisCount> ignored_pulses{};
    std::array<std::uint64_t, kAxisCount> timing_lost{};
    std::array<std::uint64_t, kAxisCount> stalls{};
};
SimFacts sim_facts(const sim::Machine& machine);

/// As planned, at 100 % feed; negative: unknown.
struct PlannedTimes {
    double left_s = -1.0;
    bool is_left_forecast = false;  ///< not all of it is planned yet
    double reference_s = -1.0;      ///< T_ref of the whole job
};

/// How much longer the planned time takes with this override. Beyond 100 % it depends on the motors' limits
/// along the path: as planned.
double stretch_of(std::uint64_t override_percent) noexcept;

/// Composes CoreStatus from its sources and keeps what lasts longer than a sample: heartbeat and alarm
/// history.
class StatusMirror {
public:
    explicit StatusMirror(const CoreFacts& facts) noexcept : facts_(facts) {}

    /// Of an alarm.
    void note_alarm(const cycle::Report& report) noexcept;
    void set_lateness(const LatenessFacts& lateness) noexcept { lateness_ = lateness; }
    void set_realtime(const RealtimeFacts& realtime) noexcept { realtime_ = realtime; }
    void set_sim(const SimFacts& sim) noexcept { sim_ = sim; }

    /// The whole status of this moment; the heartbeat grows by one each time.
    CoreStatus compose(const cycle::Sample& sample, const PlannedTimes& times) noexcept;

private:
    CoreFacts facts_;
    LatenessFacts lateness_;
    RealtimeFacts realtime_;
    SimFacts sim_;
    std::uint64_t heartbeat_ = 0;
    std::uint64_t alarm_count_ = 0;
    std::array<AlarmRecord, kAlarmHistory> alarms_{};
};

}  // namespace psicarve::supervisor
