// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/pin_rows.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <tuple>
#include <utility>

#include "shared/profile/pin_map.hpp"

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

Phrase short_name_of(Signal signal) {
    switch (signal) {
        case Signal::r1_step:
            return phrase("%1 step", "R1");
        case Signal::r2_step:
            return phrase("%1 step", "R2");
        case Signal::psi_step:
            return phrase("%1 step", "Ψ");
        case Signal::y_step:
            return phrase("%1 step", "Y");
        case Signal::r1_dir:
            return phrase("%1 dir", "R1");
        case Signal::r2_dir:
            return phrase("%1 dir", "R2");
        case Signal::psi_dir:
            return phrase("%1 dir", "Ψ");
        case Signal::y_dir:
            return phrase("%1 dir", "Y");
        case Signal::r1_enable:
            return phrase("%1 en", "R1");
        case Signal::r2_enable:
            return phrase("%1 en", "R2");
        case Signal::psi_enable:
            return phrase("%1 en", "Ψ");
        case Signal::y_enable:
            return phrase("%1 en", "Y");
        case Signal::r1_limit:
            return phrase("%1 limit", "R1");
        case Signal::r2_limit:
            return phrase("%1 limit", "R2");
        case Signal::y_limit:
            return phrase("%1 limit", "Y");
        case Signal::estop:
            return phrase("E-stop");
        case Signal::charge_pump:
            return phrase("Pump");
        case Signal::spindle:
        case Signal::psi_index:
        case Signal::mist:
        case Signal::flood:
        case Signal::output_0:
        case Signal::output_1:
        case Signal::output_2:
        case Signal::output_3:
            break;
    }
    return name_of_signal(signal);
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
        case Signal::mist:
            return phrase("Mist");
        case Signal::flood:
            return phrase("Flood");
        case Signal::output_0:
            return phrase("Output %1", "0");
        case Signal::output_1:
            return phrase("Output %1", "1");
        case Signal::output_2:
            return phrase("Output %1", "2");
        case Signal::output_3:
            return phrase("Output %1", "3");
        case Signal::charge_pump:
            return phrase("Charge pump");
    }
    return phrase("?");
}

Phrase pin_label(const std::vector<Signal>& signals) {
    std::vector<Phrase> labels;
    for (const Signal signal : signals) {
        Phrase label = short_name_of(signal);
        const bool is_alike = !labels.empty() && !label.arguments.empty() &&
                              std::string_view{labels.back().english} == label.english;
        if (is_alike)
            labels.back().arguments[0] += " " + label.arguments[0];
        else
            labels.push_back(std::move(label));
    }
    return listed(std::move(labels));
}

std::vector<PinRow> pin_rows(const Profile& profile) {
    std::vector<PinRow> rows;
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        const auto signal = static_cast<Signal>(i);
        const int pin = profile.port.pins[i];
        if (is_switched_output(signal) && pin == 0) continue;
        rows.push_back(
            {signal, name_of_signal(signal), std::abs(pin), pin < 0, register_bit_of(std::abs(pin))});
    }
    if (const int pin = profile.port.charge_pump_pin; pin != 0) {
        rows.push_back({Signal::charge_pump, name_of_signal(Signal::charge_pump), std::abs(pin), pin < 0,
                        register_bit_of(std::abs(pin))});
    }
    const auto order = [](const PinRow& row) {
        return std::tuple(row.pin == 0, !is_output(row.signal), row.pin, index_of(row.signal));
    };
    std::sort(rows.begin(), rows.end(),
              [&](const PinRow& a, const PinRow& b) { return order(a) < order(b); });
    return rows;
}

}  // namespace psicarve::session
