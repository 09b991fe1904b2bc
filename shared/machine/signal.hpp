// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace psicarve {

/// The four axes, in the order of every array that is indexed by axis.
enum class Axis : std::uint8_t { r1, r2, psi, y };
inline constexpr std::size_t kAxisCount = 4;
inline constexpr std::array<Axis, kAxisCount> kAllAxes{Axis::r1, Axis::r2, Axis::psi, Axis::y};
constexpr std::size_t index_of(Axis axis) noexcept {
    return static_cast<std::size_t>(axis);
}
inline constexpr std::size_t kHeads = 2;  // the first of the axes
inline constexpr std::size_t kPsi = index_of(Axis::psi);
inline constexpr std::size_t kY = index_of(Axis::y);

/// Names as in files and on the command line: r1, r2, psi, y.
std::string_view name_of(Axis axis) noexcept;
std::optional<Axis> axis_from_name(std::string_view name) noexcept;

/// Every signal between the core and the machine. The number is the signal's bit in a SignalWord.
enum class Signal : std::uint8_t {
    r1_step,
    r2_step,
    psi_step,
    y_step,  // bits 0..3: by axis
    r1_dir,
    r2_dir,
    psi_dir,
    y_dir,  // bits 4..7: by axis, 1 = positive direction
    r1_enable,
    r2_enable,
    psi_enable,
    y_enable,  // bits 8..11: by axis
    spindle,   // bit 12
    r1_limit,
    r2_limit,
    psi_index,
    y_limit,  // bits 13..16: the axis' own sensor, by axis, 1 = tripped
    estop,    // bit 17
    mist,
    flood,
    output_0,
    output_1,
    output_2,
    output_3,  // bits 18..23: outputs that programs switch
    /// Bit 24, an output apart from the others: it toggles while the core ticks. No trace or record has it.
    charge_pump,
};
inline constexpr std::size_t kSignalCount = 24;          ///< in traces, records and commands
inline constexpr std::size_t kFirstInput = 13;           ///< signals 0..12 leave the core
inline constexpr std::size_t kFirstSwitchedOutput = 18;  ///< from here on they do, too; the others enter it
inline constexpr std::size_t kSwitchedOutputCount = 6;

/// Logical levels of all signals: bit n is signal n; 1 = active (step high, direction positive, drive
/// enabled, spindle on, input tripped), whatever the wiring's polarity.
using SignalWord = std::uint32_t;

constexpr std::size_t index_of(Signal signal) noexcept {
    return static_cast<std::size_t>(signal);
}
constexpr SignalWord bit_of(Signal signal) noexcept {
    return SignalWord{1} << index_of(signal);
}
constexpr bool is_output(Signal signal) noexcept {
    return index_of(signal) < kFirstInput || index_of(signal) >= kFirstSwitchedOutput;
}
/// One that programs switch: coolant and the digital outputs.
constexpr bool is_switched_output(Signal signal) noexcept {
    return is_output(signal) && index_of(signal) >= kFirstSwitchedOutput && signal != Signal::charge_pump;
}

constexpr Signal step_of(Axis axis) noexcept {
    return static_cast<Signal>(index_of(axis));
}
constexpr Signal dir_of(Axis axis) noexcept {
    return static_cast<Signal>(4 + index_of(axis));
}
constexpr Signal enable_of(Axis axis) noexcept {
    return static_cast<Signal>(8 + index_of(axis));
}
/// The axis' own sensor: its limit, or for psi the index.
constexpr Signal sensor_of(Axis axis) noexcept {
    return static_cast<Signal>(13 + index_of(axis));
}

/// Switched outputs among themselves: bit 0 is mist, bit 1 flood, bits 2..5 the digital outputs 0..3.
using SwitchedOutputs = std::uint8_t;
inline constexpr SwitchedOutputs kAllSwitchedOutputs = (1U << kSwitchedOutputCount) - 1;
constexpr SwitchedOutputs switched_bit(Signal output) noexcept {
    return static_cast<SwitchedOutputs>(1U << (index_of(output) - kFirstSwitchedOutput));
}
constexpr SignalWord levels_of(SwitchedOutputs outputs) noexcept {
    return SignalWord{outputs} << kFirstSwitchedOutput;
}

inline constexpr SignalWord kSwitchedMask = levels_of(kAllSwitchedOutputs);
inline constexpr SignalWord kMachineOutputMask = (SignalWord{1} << kFirstInput) - 1;  ///< signals 0..12
inline constexpr SignalWord kOutputMask = kMachineOutputMask | kSwitchedMask;
inline constexpr SignalWord kChargePumpBit = bit_of(Signal::charge_pump);
inline constexpr SignalWord kStepMask = 0xF;
inline constexpr SignalWord kDirMask = 0xF0;
inline constexpr SignalWord kEnableMask = 0xF00;
inline constexpr SignalWord kInputMask = ((SignalWord{1} << kSignalCount) - 1) & ~kOutputMask;

/// Names as in the profile's [port.pins] and in pin traces: r1_step, psi_index, estop ...
std::string_view name_of(Signal signal) noexcept;
/// Does not know the charge pump: no command sets it.
std::optional<Signal> signal_from_name(std::string_view name) noexcept;

}  // namespace psicarve
