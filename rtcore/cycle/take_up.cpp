// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/take_up.hpp"

#include "rtcore/cycle/straight_way.hpp"

namespace psicarve::cycle {

bool TakeUp::begin(const MotionBlock& block, std::uint32_t still_axes, std::uint64_t tick) noexcept {
    if (!pulses_->has_backlash()) return false;
    SpeedLimits4 most_per_tick{};
    way_pulses_.fill(0);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        most_per_tick[k] = config_->axes[k].speed_per_tick;
        const bool up = block.delta_pulses[k] > 0 || (block.up_axes >> k & 1U) != 0;
        const bool down = block.delta_pulses[k] < 0 || (block.down_axes >> k & 1U) != 0;
        if (up == down || (still_axes >> k & 1U) != 0) continue;
        way_pulses_[k] = extra_pulses(k, up ? 1 : -1);
    }
    if (!start_straight(move_, *config_, way_pulses_, most_per_tick)) return false;
    want_directions(tick);
    is_on_ = true;
    return true;
}

bool TakeUp::step(std::uint64_t tick, bool must_slow) noexcept {
    step_along(move_, *pulses_, tick, must_slow);
    is_on_ = !move_.is_finished();
    return !is_on_;
}

}  // namespace psicarve::cycle
