// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/pulse_stage.hpp"

#include <algorithm>

namespace psicarve::cycle {

void PulseStage::want_directions(const std::array<std::int64_t, kAxisCount>& delta_pulses,
                                 std::uint64_t tick) noexcept {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const std::uint32_t bit = std::uint32_t{1} << k;
        const bool must_turn = delta_pulses[k] != 0 && (delta_pulses[k] > 0) != is_positive(k);
        dir_waiting_ = must_turn ? dir_waiting_ | bit : dir_waiting_ & ~bit;
    }
    if (dir_waiting_ != 0 && !has_gate_) turn_directions(tick);
}

void PulseStage::turn_directions(std::uint64_t tick) noexcept {
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const std::uint32_t bit = std::uint32_t{1} << k;
        const bool is_held = (at_gate_ & bit) != 0 || (emitted_ever(k) && tick < last_step_[k] + hold_ticks_);
        if ((dir_waiting_ & bit) == 0 || is_held) continue;
        levels_ ^= SignalWord{bit} << kDirShift;
        step_from_[k] = std::max(step_from_[k], tick + setup_ticks_);
        dir_waiting_ &= ~bit;
    }
}

void PulseStage::set_enables(std::uint32_t axes, std::uint64_t tick) noexcept {
    levels_ = (levels_ & ~kEnableMask) | (SignalWord{axes} << kEnableShift & kEnableMask);
    // A drive that was just switched on gets its first pulse a tick later, as after a turn of direction.
    for (std::uint64_t& from : step_from_) from = std::max(from, tick + setup_ticks_);
}

}  // namespace psicarve::cycle
