// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "rtcore/cycle/cycle_config.hpp"
#include "rtcore/cycle/pulse_stage.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::cycle {

/// Rotors that may still turn: those that stepped within their coast_ticks. One that coasts for longer
/// without a pulse has lost its steps. Config and pulses outlive it. RT: yes.
class Coasting {
public:
    Coasting(const CycleConfig& config, const PulseStage& pulses) noexcept
        : config_(&config), pulses_(&pulses) {}

    /// Bit by axis.
    std::uint32_t axes(std::uint64_t tick) const noexcept {
        std::uint32_t axes = 0;
        for (std::size_t k = 0; k < kAxisCount; ++k) axes |= std::uint32_t{coasts(k, tick)} << k;
        return axes;
    }

    /// The first axis whose rotor loses its steps in a gap of so many ticks from `tick` on, or kNoAxis.
    std::uint8_t axis_lost_in(std::int64_t gap_ticks, std::uint64_t tick) const noexcept {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if (gap_ticks > config_->axes[k].coast_ticks && coasts(k, tick))
                return static_cast<std::uint8_t>(k);
        }
        return kNoAxis;
    }

    /// Missed ticks (two-timer: of inputs and pulses) after which no rotor that turns now has lost its steps;
    /// kAnyGap when none turns.
    std::uint32_t longest_harmless_gap(std::uint64_t tick) const noexcept {
        constexpr std::int64_t kNoRotorTurns = std::numeric_limits<std::int64_t>::max();
        std::int64_t least_ticks = kNoRotorTurns;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            if (coasts(k, tick)) least_ticks = std::min(least_ticks, config_->axes[k].coast_ticks);
        }
        if (least_ticks == kNoRotorTurns) return kAnyGap;
        return static_cast<std::uint32_t>(
            std::clamp<std::int64_t>(least_ticks / config_->step_ticks() - 1, 0, std::int64_t{kAnyGap} - 1));
    }

private:
    bool coasts(std::size_t axis, std::uint64_t tick) const noexcept {
        return pulses_->stepped_within(axis, config_->axes[axis].coast_ticks, tick);
    }

    const CycleConfig* config_;
    const PulseStage* pulses_;
};

}  // namespace psicarve::cycle
