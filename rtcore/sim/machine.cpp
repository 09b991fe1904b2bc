// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/machine.hpp"

#include <algorithm>

namespace psicarve::sim {

Machine::Machine(const SimConfig& config)
    : wiring_(config.wiring),
      axes_{AxisUnit(config.axes[0], config.timing), AxisUnit(config.axes[1], config.timing),
            AxisUnit(config.axes[2], config.timing), AxisUnit(config.axes[3], config.timing)},
      slip_faults_(config.slip_faults) {
    for (const InputFault& fault : config.input_faults) {
        RunningFault running{.fault = fault, .start_ns = fault.start_ns, .approach = 0};
        if (fault.trigger_axis) {
            running.start_ns = kForeverNs;
            running.approach = fault.trigger_pulses >= position_pulses(*fault.trigger_axis) ? 1 : -1;
        }
        input_faults_.push_back(running);
    }
    outputs_ = wiring_.always_on();
    for (const Axis axis : kAllAxes) {
        if ((outputs_ & bit_of(enable_of(axis))) != 0) axes_[index_of(axis)].set_enabled(true);
    }
    has_triggers_ = !slip_faults_.empty() || !input_faults_.empty();
    run_events(0);
}

void Machine::write_registers(std::uint8_t data, std::uint8_t control, std::int64_t time_ns) noexcept {
    if (time_ns >= next_event_ns_) run_events(time_ns);
    now_ns_ = time_ns;
    const SignalWord outputs = wiring_.outputs(data, control);
    const SignalWord changed = outputs ^ outputs_;
    outputs_ = outputs;
    if ((changed & ~kStepMask) != 0) {
        for (std::size_t i = 0; i < kAxisCount; ++i) {
            const auto axis = static_cast<Axis>(i);
            if ((changed & bit_of(dir_of(axis))) != 0) {
                axes_[i].set_direction((outputs & bit_of(dir_of(axis))) != 0, time_ns);
                after_motion(i, time_ns);
            }
            if ((changed & bit_of(enable_of(axis))) != 0) {
                axes_[i].set_enabled((outputs & bit_of(enable_of(axis))) != 0);
                after_motion(i, time_ns);
            }
        }
        if ((changed & bit_of(Signal::spindle)) != 0) {
            if ((outputs & bit_of(Signal::spindle)) != 0) {
                spindle_starts_.add(1);
                spindle_since_ns_ = time_ns;
            } else {
                spindle_on_ns_.add(time_ns - spindle_since_ns_);
            }
        }
    }
    if ((changed & kStepMask) != 0) step_edges(changed & kStepMask, time_ns);
}

void Machine::step_edges(SignalWord changed, std::int64_t time_ns) noexcept {
    for (std::size_t i = 0; changed != 0; ++i, changed >>= 1) {
        if ((changed & 1) == 0) continue;
        if ((outputs_ >> i & 1) != 0) {
            axes_[i].step_rises(time_ns);
        } else {
            axes_[i].step_falls(time_ns);
        }
        after_motion(i, time_ns);
    }
}

void Machine::after_motion(std::size_t axis, std::int64_t time_ns) noexcept {
    AxisUnit& unit = axes_[axis];
    note_event(unit.settle_due_ns());
    if (workpiece_ != nullptr) carve(axis);
    bool inputs_may_change = unit.sensor().move_to(unit.position_pulses(), time_ns);
    if (has_triggers_) {
        for (SlipFault& slip_fault : slip_faults_) {
            if (index_of(slip_fault.axis) != axis || slip_fault.slip_pulses == 0 ||
                unit.pulses_taken() < slip_fault.after_pulses) {
                continue;
            }
            unit.slip(slip_fault.slip_pulses);
            slip_fault.slip_pulses = 0;
            inputs_may_change = unit.sensor().move_to(unit.position_pulses(), time_ns) || inputs_may_change;
        }
        for (RunningFault& running : input_faults_) {
            if (running.start_ns != kForeverNs || !running.fault.trigger_axis ||
                index_of(*running.fault.trigger_axis) != axis) {
                continue;
            }
            const std::int64_t past = unit.position_pulses() - running.fault.trigger_pulses;
            if (past * running.approach < 0) continue;
            running.start_ns = time_ns + running.fault.start_ns;
            inputs_may_change = true;
        }
    }
    if (inputs_may_change) update_inputs(time_ns);
}

// Psi and y move the blank past both tips.
void Machine::carve(std::size_t axis) noexcept {
    std::array<std::int64_t, kAxisCount> positions{};
    for (std::size_t i = 0; i < kAxisCount; ++i) positions[i] = axes_[i].position_pulses();
    if (axis != index_of(Axis::r2)) workpiece_->cut(Axis::r1, positions);
    if (axis != index_of(Axis::r1)) workpiece_->cut(Axis::r2, positions);
}

void Machine::run_events(std::int64_t time_ns) noexcept {
    now_ns_ = std::max(now_ns_, time_ns);
    next_event_ns_ = kForeverNs;
    for (AxisUnit& unit : axes_) {
        if (unit.settle_due_ns() <= time_ns) {
            unit.settle();
            unit.sensor().move_to(unit.position_pulses(), time_ns);
        }
        note_event(unit.settle_due_ns());
    }
    update_inputs(time_ns);
}

void Machine::update_inputs(std::int64_t time_ns) noexcept {
    SignalWord inputs = 0;
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        Sensor& sensor = axes_[i].sensor();
        if (sensor.shows(time_ns)) inputs |= bit_of(sensor_of(static_cast<Axis>(i)));
        note_event(sensor.next_change_ns(time_ns));
    }
    for (const RunningFault& running : input_faults_) {
        const SignalWord bit = bit_of(running.fault.signal);
        if (faulty_level(running, (inputs & bit) != 0, time_ns)) {
            inputs |= bit;
        } else {
            inputs &= ~bit;
        }
    }
    inputs_ = (inputs & ~held_mask_) | held_levels_;
    status_ = wiring_.status(inputs_);
}

bool Machine::faulty_level(const RunningFault& running, bool truth, std::int64_t time_ns) noexcept {
    const InputFault& fault = running.fault;
    if (time_ns < running.start_ns) {
        note_event(running.start_ns);
        return truth;
    }
    const std::int64_t since_ns = time_ns - running.start_ns;
    if (since_ns >= fault.duration_ns) return truth;
    note_event(running.start_ns + std::min(fault.duration_ns, kForeverNs - running.start_ns));
    if (fault.half_period_ns <= 0) return fault.level;
    const std::int64_t turns = since_ns / fault.half_period_ns;
    note_event(running.start_ns + (turns + 1) * fault.half_period_ns);
    return turns % 2 == 0 ? fault.level : truth;
}

void Machine::slip(Axis axis, std::int64_t pulses) noexcept {
    axes_[index_of(axis)].slip(pulses);
    after_motion(index_of(axis), now_ns_);
}

void Machine::set_sensor_fault(Axis axis, SensorFault fault) noexcept {
    axes_[index_of(axis)].sensor().set_fault(fault);
    update_inputs(now_ns_);
}

void Machine::hold_input(Signal input, bool level) noexcept {
    held_mask_ |= bit_of(input);
    held_levels_ = (held_levels_ & ~bit_of(input)) | (level ? bit_of(input) : 0);
    update_inputs(now_ns_);
}

void Machine::release_input(Signal input) noexcept {
    held_mask_ &= ~bit_of(input);
    held_levels_ &= ~bit_of(input);
    update_inputs(now_ns_);
}

SimReport Machine::report() const noexcept {
    SimReport report{.axes = {axes_[0].report(), axes_[1].report(), axes_[2].report(), axes_[3].report()},
                     .spindle_on_ns = spindle_on_ns_.get(),
                     .spindle_starts = spindle_starts_.count()};
    return report;
}

}  // namespace psicarve::sim
