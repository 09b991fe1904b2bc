// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "rtcore/sim/sim_config.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::sim {

/// The cable and the computer's port as the machine meets them: register bytes become signals of the machine
/// and sensors become the status byte. It has its own table of the connector (IEEE 1284, SPP registers) and
/// shares nothing with the core's pin map, so that a mistake in either shows. RT: yes.
class Wiring {
public:
    explicit Wiring(const WiringConfig& config) noexcept;

    SignalWord outputs(std::uint8_t data, std::uint8_t control) const noexcept {
        return from_data_[data] | from_control_[control & 0xF] | always_on_;
    }
    /// Signals that are on whatever the registers say: drives whose enable is not wired.
    SignalWord always_on() const noexcept { return always_on_; }
    /// Pins that no input is wired to are low.
    std::uint8_t status(SignalWord inputs) const noexcept;

private:
    /// All inputs low: only the status bit that the hardware inverts is set.
    static constexpr std::uint8_t kNothingWired = 0x80;
    struct InputPlace {
        std::uint8_t mask = 0;  ///< in the status register; 0: not wired
        bool register_is_inverted = false;
    };
    std::array<SignalWord, 256> from_data_{};
    std::array<SignalWord, 16> from_control_{};
    SignalWord always_on_ = 0;  ///< a drive whose enable input is not connected is on
    std::array<InputPlace, kSignalCount> inputs_{};
};

}  // namespace psicarve::sim
