// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>

#include "rtcore/port/open_port.hpp"
#include "rtcore/port/port.hpp"
#include "rtcore/port/port_access.hpp"
#include "rtcore/port/pulse_times.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/pin_map.hpp"

namespace psicarve::port {

/// A real parallel port. Writes only registers that change, no edge sooner than the drivers' times allow,
/// and, as its last write, the safe state:
///
///     healthy ──an access fails──> silent ──the safe state is taken──> safe ──take_up_again()──> healthy
///                                    ^ └── try_safe_state() each tick     │
///                                    └────────an access fails─────────────┘
///
/// RT: yes, all but construction and destruction.
class ParallelPort final : public Port {
public:
    /// The port holds the safe state already, as open_port() leaves it. `patience`: how long the destructor
    /// keeps trying when the hardware does not take the safe state; after it only a guard can.
    ParallelPort(OpenPort open, const PinMap& pin_map, const PulseTimes& pulse_times,
                 std::chrono::milliseconds patience);
    ~ParallelPort() override;
    ParallelPort(const ParallelPort&) = delete;
    ParallelPort& operator=(const ParallelPort&) = delete;

    SignalWord read_inputs(std::int64_t time_ns) noexcept override;
    /// Waits first where a step or a direction would change too soon.
    void write_outputs(SignalWord levels, std::int64_t time_ns) noexcept override;
    void forget_written() noexcept override { is_in_doubt_ = true; }
    /// Spins: a sleep would take longer than a pulse.
    void wait(std::int64_t width_ns) noexcept override;
    bool is_healthy() const noexcept override { return is_healthy_; }
    void try_safe_state() noexcept override;
    SignalWord stuck_outputs() const noexcept override { return is_silent_ ? stuck_ : 0; }
    bool is_silent() const noexcept override { return is_silent_; }
    bool take_up_again() noexcept override;

private:
    void note_error(SignalWord wanted) noexcept;
    void wait_until(std::int64_t instant_ns) const noexcept;
    static void spin_until(std::int64_t instant_ns) noexcept;
    bool write_levels(SignalWord levels) noexcept;
    bool write(PortRegister reg, std::uint8_t byte, std::uint8_t& written) noexcept;

    OpenPort open_;
    std::chrono::milliseconds patience_;
    PinMap pin_map_;
    SafeState safe_;
    PulseTimes pulse_times_;
    OutputRegisters written_;
    bool is_in_doubt_ = false;  ///< whether the registers still hold `written_`
    bool is_healthy_ = true;
    bool is_silent_ = false;
    SignalWord levels_ = 0;  ///< that the registers hold, while healthy
    SignalWord stuck_ = 0;   ///< that may be active while silent
};

}  // namespace psicarve::port
