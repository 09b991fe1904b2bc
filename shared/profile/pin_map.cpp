// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/profile/pin_map.hpp"

#include <cstdlib>

#include "shared/profile/profile_table.hpp"

namespace psicarve {
namespace {

constexpr int kLastSignalPin = 17;  // 18..25 are ground

// Pins 1..17 of the connector. Source: IEEE 1284, SPP registers.
constexpr std::array<PinPlace, kLastSignalPin + 1> kPlaces{{
    {},
    {PortRegister::control, 0, true},
    {PortRegister::data, 0, false},
    {PortRegister::data, 1, false},
    {PortRegister::data, 2, false},
    {PortRegister::data, 3, false},
    {PortRegister::data, 4, false},
    {PortRegister::data, 5, false},
    {PortRegister::data, 6, false},
    {PortRegister::data, 7, false},
    {PortRegister::status, 6, false},
    {PortRegister::status, 7, true},
    {PortRegister::status, 5, false},
    {PortRegister::status, 4, false},
    {PortRegister::control, 1, true},
    {PortRegister::status, 3, false},
    {PortRegister::control, 2, false},
    {PortRegister::control, 3, true},
}};

constexpr std::uint32_t pin_bit(int pin) noexcept {
    return std::uint32_t{1} << pin;
}

/// Register byte that shows these pin levels.
std::uint8_t register_byte(PortRegister reg, std::uint32_t pins) noexcept {
    std::uint32_t byte = 0;
    for (int pin = 1; pin <= kLastSignalPin; ++pin) {
        const PinPlace& place = kPlaces[static_cast<std::size_t>(pin)];
        if (place.reg != reg) continue;
        const bool level = (pins & pin_bit(pin)) != 0;
        if (level != place.hardware_inverted) byte |= std::uint32_t{1} << place.bit;
    }
    return static_cast<std::uint8_t>(byte);
}

/// The register bit of an output's pin, alone.
OutputRegisters bit_of_pin(int pin) noexcept {
    const PinPlace& place = kPlaces[static_cast<std::size_t>(pin)];
    const auto bit = static_cast<std::uint8_t>(std::uint32_t{1} << place.bit);
    if (pin == 0) return {};
    return place.reg == PortRegister::data ? OutputRegisters{bit, 0} : OutputRegisters{0, bit};
}

std::uint32_t pins_of_byte(PortRegister reg, std::uint8_t byte) noexcept {
    std::uint32_t pins = 0;
    for (int pin = 1; pin <= kLastSignalPin; ++pin) {
        const PinPlace& place = kPlaces[static_cast<std::size_t>(pin)];
        if (place.reg != reg) continue;
        const bool bit = ((byte >> place.bit) & 1) != 0;
        if (bit != place.hardware_inverted) pins |= pin_bit(pin);
    }
    return pins;
}

}  // namespace

std::optional<PinPlace> place_of_pin(int pin) noexcept {
    if (pin < 1 || pin > kLastSignalPin) return std::nullopt;
    return kPlaces[static_cast<std::size_t>(pin)];
}

bool is_input_pin(int pin) noexcept {
    const auto place = place_of_pin(pin);
    return place && place->reg == PortRegister::status;
}

Result<PinMap> PinMap::from_profile(const Profile& profile) {
    if (const auto problem = profile_detail::check_pins(profile)) {
        return bad_input(problem->key + ": " + problem->text);
    }
    PinMap map;
    map.pins_ = profile.port.pins;
    map.charge_pump_pin_ = profile.port.charge_pump_pin;
    map.charge_pump_ = bit_of_pin(std::abs(map.charge_pump_pin_));
    for (const Axis axis : kAllAxes) {
        map.active_low_[index_of(dir_of(axis))] = !axis_motion(profile, axis).positive_is_high;
    }
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        if (map.pins_[i] < 0) map.active_low_[i] = !map.active_low_[i];
    }
    for (std::size_t on = 0; on < map.switched_.size(); ++on) {
        for (std::size_t i = 0; i < kSwitchedOutputCount; ++i) {
            if ((on >> i & 1) == 0) continue;
            const OutputRegisters bit = bit_of_pin(std::abs(map.pins_[kFirstSwitchedOutput + i]));
            map.switched_[on].data |= bit.data;
            map.switched_[on].control |= bit.control;
        }
    }
    auto encode = std::make_shared<std::array<OutputRegisters, std::size_t{1} << kFirstInput>>();
    for (std::size_t levels = 0; levels < encode->size(); ++levels) {
        const std::uint32_t pins = map.pins_from_levels(static_cast<SignalWord>(levels), kOutputMask);
        (*encode)[levels] = {register_byte(PortRegister::data, pins),
                             register_byte(PortRegister::control, pins)};
    }
    auto decode = std::make_shared<std::array<SignalWord, 256>>();
    for (std::size_t status = 0; status < decode->size(); ++status) {
        const std::uint32_t pins = pins_of_byte(PortRegister::status, static_cast<std::uint8_t>(status));
        (*decode)[status] = map.levels_from_pins(pins, kInputMask);
    }
    map.encode_ = std::move(encode);
    map.decode_status_ = std::move(decode);
    return map;
}

std::uint32_t PinMap::pins_from_levels(SignalWord levels, SignalWord signals) const noexcept {
    std::uint32_t active = 0;  // pins that any of their signals activates
    std::uint32_t inverted = 0;
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        if (pins_[i] == 0 || ((signals >> i) & 1) == 0) continue;
        const std::uint32_t bit = pin_bit(std::abs(pins_[i]));
        if (((levels >> i) & 1) != 0) active |= bit;
        if (active_low_[i]) inverted |= bit;
    }
    if (charge_pump_pin_ < 0) inverted |= pin_bit(-charge_pump_pin_);
    return active ^ inverted;
}

SignalWord PinMap::levels_from_pins(std::uint32_t pins, SignalWord signals) const noexcept {
    SignalWord levels = 0;
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        if (pins_[i] == 0 || ((signals >> i) & 1) == 0) continue;
        const bool high = (pins & pin_bit(std::abs(pins_[i]))) != 0;
        if (high != active_low_[i]) levels |= SignalWord{1} << i;
    }
    return levels;
}

std::uint32_t PinMap::pins_from_registers(OutputRegisters registers) const noexcept {
    return pins_of_byte(PortRegister::data, registers.data) |
           pins_of_byte(PortRegister::control, registers.control);
}

SignalWord PinMap::outputs_from_registers(OutputRegisters registers) const noexcept {
    SignalWord levels = levels_from_pins(pins_from_registers(registers), kOutputMask);
    for (const Axis axis : kAllAxes) {
        // A drive whose enable input is not connected is on.
        if (!is_wired(enable_of(axis))) levels |= bit_of(enable_of(axis));
    }
    if (charge_pump_pin_ != 0) {
        const bool high = (pins_from_registers(registers) & pin_bit(std::abs(charge_pump_pin_))) != 0;
        if (high != (charge_pump_pin_ < 0)) levels |= kChargePumpBit;
    }
    return levels;
}

std::uint8_t PinMap::status_from_inputs(SignalWord inputs) const noexcept {
    return register_byte(PortRegister::status, pins_from_levels(inputs, kInputMask));
}

int PinMap::pin_of(Signal signal) const noexcept {
    return std::abs(signal == Signal::charge_pump ? charge_pump_pin_ : pins_[index_of(signal)]);
}

}  // namespace psicarve
