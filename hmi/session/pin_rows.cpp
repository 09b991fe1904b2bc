// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/pin_rows.hpp"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "shared/pin_map.hpp"

namespace psicarve::session {
namespace {

std::string register_bit_of(int pin) {
    const auto place = place_of_pin(pin);
    if (!place) return {};
    const char* reg = place->reg == PortRegister::data      ? "data "
                      : place->reg == PortRegister::control ? "control "
                                                            : "status ";
    return reg + std::to_string(place->bit) + (place->hardware_inverted ? " inv" : "");
}

}  // namespace

Phrase name_of_signal(Signal signal) {
    switch (signal) {
        case Signal::r1_step:
            return phrase("R1 step");
        case Signal::r2_step:
            return phrase("R2 step");
        case Signal::psi_step:
            return phrase("Ψ step");
        case Signal::y_step:
            return phrase("Y step");
        case Signal::r1_dir:
            return phrase("R1 direction");
        case Signal::r2_dir:
            return phrase("R2 direction");
        case Signal::psi_dir:
            return phrase("Ψ direction");
        case Signal::y_dir:
            return phrase("Y direction");
        case Signal::r1_enable:
            return phrase("R1 enable");
        case Signal::r2_enable:
            return phrase("R2 enable");
        case Signal::psi_enable:
            return phrase("Ψ enable");
        case Signal::y_enable:
            return phrase("Y enable");
        case Signal::spindle:
            return phrase("Spindle");
        case Signal::r1_limit:
            return phrase("R1 limit");
        case Signal::r2_limit:
            return phrase("R2 limit");
        case Signal::psi_index:
            return phrase("Ψ index");
        case Signal::y_limit:
            return phrase("Y limit");
        case Signal::estop:
            return phrase("Emergency stop");
    }
    return phrase("?");
}

std::vector<PinRow> pin_rows(const Profile& profile) {
    std::vector<PinRow> rows;
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        const auto signal = static_cast<Signal>(i);
        const int pin = profile.port.pins[i];
        rows.push_back(
            {signal, name_of_signal(signal), std::abs(pin), pin < 0, register_bit_of(std::abs(pin))});
    }
    const auto order = [](const PinRow& row) {
        return std::tuple(row.pin == 0, !is_output(row.signal), row.pin, index_of(row.signal));
    };
    std::sort(rows.begin(), rows.end(),
              [&](const PinRow& a, const PinRow& b) { return order(a) < order(b); });
    return rows;
}

}  // namespace psicarve::session
