// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// A signal and its pin.
struct PinRow {
    Signal signal;
    Phrase name;               ///< "R1 step"
    int pin;                   ///< 0: not wired
    bool is_active_low;        ///< the profile's minus sign
    std::string register_bit;  ///< "data 3", "control 1 inv", of the port's own registers
};

Phrase name_of_signal(Signal signal);

/// A short label for a pin of the connector: "R1 Ψ en" for a pin that enables both.
Phrase pin_label(const std::vector<Signal>& signals);

/// Outputs by pin, then inputs by pin; signals that are not wired come last. Of the charge pump and the
/// outputs that programs switch only those that are wired.
std::vector<PinRow> pin_rows(const Profile& profile);

/// The sensors that stop a machine and are tripped now: limit switches and the emergency stop.
constexpr SignalWord tripped_stops(SignalWord levels) noexcept {
    return levels & (bit_of(Signal::r1_limit) | bit_of(Signal::r2_limit) | bit_of(Signal::y_limit) |
                     bit_of(Signal::estop));
}

}  // namespace psicarve::session
