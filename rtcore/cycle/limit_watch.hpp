// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "rtcore/cycle/inputs.hpp"
#include "shared/machine/signal.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::cycle {

/// Which tripped limit raises an alarm: each, but those that were tripped when homing or backing off began,
/// until they clear, and that of the axis that is being homed. RT: yes.
class LimitWatch {
public:
    /// Homing or backing off begins: limits among these levels are exempt, and no others.
    void exempt(SignalWord levels) noexcept { exempt_ = levels & kLimitMask; }
    /// An axis was stopped on its sensor while being homed: that is no new limit.
    void exempt_axis(std::size_t axis, SignalWord levels) noexcept { exempt_ |= levels & limit_of(axis); }
    /// Whenever inputs changed: those that stand in none of these levels have cleared.
    void note(SignalWord levels) noexcept { exempt_ &= levels; }

    /// The first axis whose limit among these levels raises an alarm, or kNoAxis. `homing_axis` may be
    /// kNoAxis.
    std::uint8_t alarming_axis(SignalWord levels, std::uint8_t homing_axis) const noexcept {
        SignalWord tripped = levels & kLimitMask & ~exempt_;
        if (homing_axis != kNoAxis) tripped &= ~limit_of(homing_axis);
        for (std::size_t k = 0; tripped != 0 && k < kAxisCount; ++k) {
            if ((tripped & limit_of(k)) != 0) return static_cast<std::uint8_t>(k);
        }
        return kNoAxis;
    }

private:
    static constexpr SignalWord limit_of(std::size_t axis) noexcept {
        return bit_of(Signal::r1_limit) << axis;
    }

    SignalWord exempt_ = 0;
};

}  // namespace psicarve::cycle
