// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "shared/base/result.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve {

/// Where a pin of the 25-way connector lives in the port's registers. Source: IEEE 1284 SPP register set.
enum class PortRegister : std::uint8_t { data, control, status };
struct PinPlace {
    PortRegister reg;
    std::uint8_t bit;
    bool hardware_inverted;  ///< the register bit is the opposite of the pin's level
};
/// Pins 1..17; nothing for others.
std::optional<PinPlace> place_of_pin(int pin) noexcept;
/// Pin 10..13 and 15 can be read; the other twelve of 1..17 can be driven.
bool is_input_pin(int pin) noexcept;

/// What a port may leave on when it is not told otherwise: "drives and spindle", "drives, spindle, mist and
/// output_2".
std::string names_of_powered(const Profile& profile);

/// The two registers that a port writes, as the bytes that go to the hardware.
struct OutputRegisters {
    std::uint8_t data = 0;
    std::uint8_t control = 0;
    friend bool operator==(const OutputRegisters&, const OutputRegisters&) = default;
};

/// Translates between logical levels and register bytes: the one place that knows pins, active-low wiring,
/// the meaning of the direction levels (`positive`) and the port's own inversions. Tables made once; look-ups
/// RT: yes. A pin that two enables share is active while either is.
class PinMap {
public:
    /// Refuses pins that cannot carry their signal and two different signals on one output pin (enables may
    /// share).
    static Result<PinMap> from_profile(const Profile& profile);

    OutputRegisters encode(SignalWord levels) const noexcept {
        OutputRegisters registers = (*encode_)[levels & kMachineOutputMask];
        const OutputRegisters& switched = switched_[(levels & kSwitchedMask) >> kFirstSwitchedOutput];
        registers.data ^= switched.data;
        registers.control ^= switched.control;
        if ((levels & kChargePumpBit) != 0) {
            registers.data ^= charge_pump_.data;
            registers.control ^= charge_pump_.control;
        }
        return registers;
    }
    SignalWord decode_status(std::uint8_t status) const noexcept { return (*decode_status_)[status]; }

    /// The machine's side of the connector: bit n of a pin word is the electric level of pin n. What the
    /// register bytes put on the pins; and which logical levels a machine wired like this sees: a drive whose
    /// enable is not wired is always on.
    std::uint32_t pins_from_registers(OutputRegisters registers) const noexcept;
    SignalWord outputs_from_registers(OutputRegisters registers) const noexcept;
    /// The status byte that the port's hardware would show for these logical input levels; unwired inputs
    /// read 0 as a pin.
    std::uint8_t status_from_inputs(SignalWord inputs) const noexcept;

    bool is_wired(Signal signal) const noexcept { return pin_of(signal) != 0; }
    int pin_of(Signal signal) const noexcept;  ///< 0: not wired

private:
    PinMap() = default;
    /// Electric levels of the pins of these signals, and back.
    std::uint32_t pins_from_levels(SignalWord levels, SignalWord signals) const noexcept;
    SignalWord levels_from_pins(std::uint32_t pins, SignalWord signals) const noexcept;

    std::array<int, kSignalCount> pins_{};         ///< as in the profile, sign = active low
    std::array<bool, kSignalCount> active_low_{};  ///< as the pin shows it; a direction's sign included
    int charge_pump_pin_ = 0;                      ///< as in the profile
    OutputRegisters charge_pump_;                  ///< its bit, which the table does not hold
    /// By switched outputs: the bits of those that are on, which the table has as off.
    std::array<OutputRegisters, std::size_t{1} << kSwitchedOutputCount> switched_{};
    std::shared_ptr<const std::array<OutputRegisters, std::size_t{1} << kFirstInput>> encode_;
    std::shared_ptr<const std::array<SignalWord, 256>> decode_status_;
};

}  // namespace psicarve
