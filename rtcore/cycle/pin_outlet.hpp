// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/cycle/cycle_config.hpp"
#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/cycle/inputs.hpp"
#include "rtcore/cycle/output_pins.hpp"
#include "rtcore/cycle/pin_tracer.hpp"
#include "rtcore/cycle/pulse_stage.hpp"
#include "rtcore/cycle/tick_clock.hpp"
#include "rtcore/port/port.hpp"

namespace psicarve::cycle {

/// Brings the pulse stage's levels to the port's pins, and tells the trace what stands there. What is traced
/// are all pins but the charge pump: outputs as they were written, inputs as they were read. All that it is
/// made from outlives it. RT: yes.
class PinOutlet {
public:
    /// Writes the safe state at time 0.
    PinOutlet(const CycleConfig& config, port::Port& port, CycleIo& io, PulseStage& pulses,
              const Inputs& inputs, const TickClock& clock) noexcept
        : port_(&port),
          pulses_(&pulses),
          inputs_(&inputs),
          clock_(&clock),
          pulse_ns_(config.pulse_ns),
          pins_(port),
          tracer_(io) {}

    /// A write would change a pin.
    bool has_change() const noexcept { return pins_.differ_from(pulses_->levels()); }
    /// The levels of this tick go out. Pulses that are to end within the tick do so, pulse_ns later.
    void write() noexcept;
    /// Schedule two-timer: pulses over whole ticks end, at an instant between two ticks of inputs and pulses.
    /// Other levels that changed meanwhile wait for the next.
    void end_pulses(TickClock::Instant at) noexcept;

    // What hangs on the charge pump cuts the power while it rests. The next write shows it.
    void toggle_charge_pump() noexcept { pins_.toggle_charge_pump(); }
    void rest_charge_pump() noexcept { pins_.rest_charge_pump(); }
    /// As OutputPins has it.
    bool try_safe_state() noexcept { return pins_.try_safe_state(); }

    /// Every tick: what changed on the pins, and then a position that was defined anew in it.
    void trace() noexcept;
    void note_new_position() noexcept { tracer_.note_new_position(); }
    void trace_job(std::uint64_t generation) noexcept {
        tracer_.trace_job(levels(), clock_->tick(), pulses_->positions(), generation);
    }

    /// A recording of the pins begins or ends: see PinTracer.
    bool can_record() const noexcept { return tracer_.can_record(); }
    void begin_recording(RecordingForm form, std::uint32_t token) noexcept {
        tracer_.begin_recording(form, token, levels(), clock_->tick(),
                                {pulses_->positions(), pulses_->crossed_pulses()});
    }
    bool end_recording(std::uint32_t token) noexcept {
        return tracer_.end_recording(token, levels(), clock_->tick(), pulses_->positions());
    }
    std::uint64_t trace_lost() const noexcept { return tracer_.lost(); }

private:
    SignalWord levels() const noexcept { return pins_.levels() | inputs_->raw(); }

    port::Port* port_;
    PulseStage* pulses_;
    const Inputs* inputs_;
    const TickClock* clock_;
    std::int64_t pulse_ns_;
    OutputPins pins_;
    PinTracer tracer_;
};

}  // namespace psicarve::cycle
