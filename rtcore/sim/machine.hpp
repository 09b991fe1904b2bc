// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "rtcore/sim/axis_unit.hpp"
#include "rtcore/sim/sim_config.hpp"
#include "rtcore/sim/sim_report.hpp"
#include "rtcore/sim/wiring.hpp"
#include "rtcore/sim/workpiece.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::sim {

/// The machine behind the connector of a simulated port. It sees register bytes in time and nothing else of
/// the core. The same bytes at the same times give bit for bit the same machine. Only one thread, the tick's,
/// calls its methods, except report() and position_pulses(), which any may call (each number is whole, the
/// set of them need not be of one instant). RT: yes, after construction. Its members: parts, the registers,
/// and times of what comes next.
class Machine {
public:
    explicit Machine(const SimConfig& config);

    /// The port's output registers as they stand from `time_ns` on; time never goes back.
    void write_registers(std::uint8_t data, std::uint8_t control, std::int64_t time_ns) noexcept;
    /// The port's status register at `time_ns`.
    std::uint8_t read_status(std::int64_t time_ns) noexcept {
        if (time_ns >= next_event_ns_) run_events(time_ns);
        return status_;
    }

    SimReport report() const noexcept;
    /// The axis' true position.
    std::int64_t position_pulses(Axis axis) const noexcept { return axes_[index_of(axis)].position_pulses(); }

    /// Puts a blank on the table, from which the tips cut from here on.
    void set_workpiece(std::unique_ptr<Workpiece> workpiece) noexcept { workpiece_ = std::move(workpiece); }
    const Workpiece* workpiece() const noexcept { return workpiece_.get(); }

    // Faults set while it runs, besides those in its configuration. They act at once.
    /// The axis' mechanics move without a pulse.
    void slip(Axis axis, std::int64_t pulses) noexcept;
    void set_sensor_fault(Axis axis, SensorFault fault) noexcept;
    /// An input shows this level, whatever the truth, until it is released.
    void hold_input(Signal input, bool level) noexcept;
    void release_input(Signal input) noexcept;

private:
    struct RunningFault {
        InputFault fault;
        std::int64_t start_ns;  ///< kForeverNs until its trigger comes
        int approach;           ///< the trigger lies in this direction: +1, -1
    };

    void run_events(std::int64_t time_ns) noexcept;
    void step_edges(SignalWord changed, std::int64_t time_ns) noexcept;
    void after_motion(std::size_t axis, std::int64_t time_ns) noexcept;
    void carve(std::size_t axis) noexcept;
    void update_inputs(std::int64_t time_ns) noexcept;
    bool faulty_level(const RunningFault& running, bool truth, std::int64_t time_ns) noexcept;
    void note_event(std::int64_t time_ns) noexcept {
        if (time_ns < next_event_ns_) next_event_ns_ = time_ns;
    }

    Wiring wiring_;
    std::array<AxisUnit, kAxisCount> axes_;
    std::vector<RunningFault> input_faults_;
    std::vector<SlipFault> slip_faults_;
    std::unique_ptr<Workpiece> workpiece_;  ///< null: nothing on the table
    SignalWord outputs_ = 0;
    SignalWord inputs_ = 0;
    SignalWord held_mask_ = 0;
    SignalWord held_levels_ = 0;
    std::uint8_t status_ = 0;
    bool has_triggers_ = false;
    std::int64_t now_ns_ = 0;
    std::int64_t next_event_ns_ = 0;
    std::int64_t spindle_since_ns_ = 0;
    Counter spindle_on_ns_;
    Counter spindle_starts_;
};

}  // namespace psicarve::sim
