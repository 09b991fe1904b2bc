// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shared/machine/signal.hpp"

namespace psicarve::port {

/// The interface through which signals leave and enter the computer. It speaks logical levels; the port
/// translates polarity and pins (pin_map.hpp). One read and at most a few writes a tick. RT: yes, every
/// method, after construction.
class Port {
public:
    virtual ~Port() = default;

    /// Inputs as they are now, in the input bits of the word (others 0); all of them when the hardware
    /// failed. `time_ns` is the tick's time since the core started; only a simulated machine needs it.
    virtual SignalWord read_inputs(std::int64_t time_ns) noexcept = 0;

    /// Sets all outputs (input bits of `levels` are ignored). Called only when something changed, with
    /// the time of the change: the tick's, plus the offset inside the tick.
    virtual void write_outputs(SignalWord levels, std::int64_t time_ns) noexcept = 0;

    /// The hardware may have lost what was written: the next write_outputs() writes all of it.
    virtual void forget_written() noexcept {}

    /// Lets `width_ns` pass since the last write_outputs() was done, before the write that ends a pulse.
    /// Simulated time stands still meanwhile.
    virtual void wait(std::int64_t width_ns) noexcept = 0;

    /// False once the hardware answered with an error, until take_up_again(): meanwhile only the safe state
    /// is written, and every input shows tripped.
    virtual bool is_healthy() const noexcept = 0;
    /// For a port that is not healthy: tries once to write the safe state, unless it stands there already.
    /// The tick calls it every time until it succeeds.
    virtual void try_safe_state() noexcept {}
    /// Outputs that may still be active because the hardware has not taken the safe state. 0: none.
    virtual SignalWord stuck_outputs() const noexcept { return 0; }
    /// True while the hardware has not taken the safe state.
    virtual bool is_silent() const noexcept { return false; }
    /// Makes the port healthy again, with the safe state on the pins: false when the hardware does not
    /// answer.
    virtual bool take_up_again() noexcept { return is_healthy(); }
};

}  // namespace psicarve::port
