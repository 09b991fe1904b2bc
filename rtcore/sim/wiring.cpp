// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/wiring.hpp"

#include <cstddef>
#include <cstdlib>

namespace psicarve::sim {
namespace {

enum class Register : std::uint8_t { none, data, control, status };
struct Place {
    Register reg = Register::none;
    std::uint8_t bit = 0;
    bool is_inverted = false;  ///< by the port's hardware
};

/// IEEE 1284-1994, the compatible (SPP) registers, by pin of the 25-way connector.
constexpr std::array<Place, 18> kPlaces{{
    {},
    {Register::control, 0, true},   // 1 nStrobe
    {Register::data, 0, false},     // 2
    {Register::data, 1, false},     // 3
    {Register::data, 2, false},     // 4
    {Register::data, 3, false},     // 5
    {Register::data, 4, false},     // 6
    {Register::data, 5, false},     // 7
    {Register::data, 6, false},     // 8
    {Register::data, 7, false},     // 9
    {Register::status, 6, false},   // 10 nAck
    {Register::status, 7, true},    // 11 Busy
    {Register::status, 5, false},   // 12 PError
    {Register::status, 4, false},   // 13 Select
    {Register::control, 1, true},   // 14 nAutoFd
    {Register::status, 3, false},   // 15 nFault
    {Register::control, 2, false},  // 16 nInit
    {Register::control, 3, true},   // 17 nSelectIn
}};

Place place_of(int pin) noexcept {
    const auto number = static_cast<std::size_t>(std::abs(pin));
    return number < kPlaces.size() ? kPlaces[number] : Place{};
}

/// Whether the machine takes a low pin for the signal's active level.
bool is_active_low(const WiringConfig& config, Signal signal) noexcept {
    const bool minus_sign = config.pins[index_of(signal)] < 0;
    const std::size_t dir = index_of(signal) - index_of(Signal::r1_dir);
    const bool is_direction = index_of(signal) >= index_of(Signal::r1_dir) && dir < kAxisCount;
    return minus_sign != (is_direction && !config.positive_is_high[dir]);
}

template <std::size_t kSize>
void wire_output(std::array<SignalWord, kSize>& table, const Place& place, Signal signal,
                 bool active_low) noexcept {
    for (std::size_t byte = 0; byte < kSize; ++byte) {
        const bool register_bit = (byte >> place.bit & 1) != 0;
        const bool pin_is_high = register_bit != place.is_inverted;
        if (pin_is_high != active_low) table[byte] |= bit_of(signal);
    }
}

}  // namespace

Wiring::Wiring(const WiringConfig& config) noexcept {
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        const auto signal = static_cast<Signal>(i);
        const Place place = place_of(config.pins[i]);
        const bool active_low = is_active_low(config, signal);
        if (!is_output(signal)) {
            if (place.reg != Register::status) continue;
            inputs_[i] = {.mask = static_cast<std::uint8_t>(1U << place.bit),
                          .register_is_inverted = place.is_inverted != active_low};
        } else if (config.pins[i] == 0) {
            always_on_ |= bit_of(signal) & kEnableMask;
        } else if (place.reg == Register::data) {
            wire_output(from_data_, place, signal, active_low);
        } else if (place.reg == Register::control) {
            wire_output(from_control_, place, signal, active_low);
        }
    }
}

std::uint8_t Wiring::status(SignalWord inputs) const noexcept {
    std::uint8_t status = kNothingWired;
    for (std::size_t i = kFirstInput; i < kFirstSwitchedOutput; ++i) {
        const bool register_bit = ((inputs >> i & 1) != 0) != inputs_[i].register_is_inverted;
        status =
            static_cast<std::uint8_t>((status & ~inputs_[i].mask) | (register_bit ? inputs_[i].mask : 0));
    }
    return status;
}

}  // namespace psicarve::sim
