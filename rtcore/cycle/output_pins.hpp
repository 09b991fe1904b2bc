// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/port/port.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// What stands on the output pins: the levels that the cycle wants, and the charge pump beside them. The port
/// outlives it. RT: yes.
class OutputPins {
public:
    /// Writes the safe state at time 0.
    explicit OutputPins(port::Port& port) noexcept : port_(&port) { port_->write_outputs(0, 0); }

    /// Without the charge pump.
    SignalWord levels() const noexcept { return written_ & kOutputMask; }
    /// Whether a write would change a pin.
    bool differ_from(SignalWord levels) const noexcept { return (levels | charge_pump_) != written_; }
    void write(SignalWord levels, std::int64_t time_ns) noexcept {
        written_ = levels | charge_pump_;
        port_->write_outputs(written_, time_ns);
    }
    /// Steps go low, and all else stays as it stands.
    void end_pulses(std::int64_t time_ns) noexcept {
        written_ &= ~kStepMask;
        port_->write_outputs(written_, time_ns);
    }

    // What hangs on the charge pump cuts the power while it rests. The next write shows it.
    void toggle_charge_pump() noexcept { charge_pump_ ^= kChargePumpBit; }
    void rest_charge_pump() noexcept { charge_pump_ = 0; }

    /// Of a port that is not healthy, every tick: tries once to write the safe state. True when it says anew
    /// whether the hardware takes it.
    bool try_safe_state() noexcept {
        port_->try_safe_state();
        const bool has_changed = port_->is_silent() != is_silent_;
        is_silent_ = port_->is_silent();
        return has_changed;
    }

private:
    port::Port* port_;
    SignalWord written_ = 0;
    SignalWord charge_pump_ = 0;  ///< its level: kChargePumpBit or 0
    bool is_silent_ = false;      ///< as it was told last
};

}  // namespace psicarve::cycle
