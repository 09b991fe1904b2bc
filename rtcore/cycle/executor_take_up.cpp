// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/executor.hpp"
#include "rtcore/cycle/straight_way.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::cycle {

// Planners let a run or a group end where an axis with backlash turns round, so that all this happens at
// rest.
void Executor::turn_axes(std::uint64_t tick) noexcept {
    if (pulses_->has_backlash() && begin_take_up(tick)) return;
    pulses_->want_directions(block_.delta_pulses, tick);
}

// Before homing nobody knows where in its gap an axis stands, and a sensor may trip on the way: so what has
// to be taken up is part of the move.
void Executor::lengthen_by_take_up() noexcept {
    std::int64_t& delta = block_.delta_pulses[homing_axis_];
    if (delta == 0) return;
    const std::int64_t extra = pulses_->take_up_pulses(homing_axis_, delta > 0);
    delta += delta > 0 ? extra : -extra;
}

bool Executor::begin_take_up(std::uint64_t tick) noexcept {
    if (homing_axis_ != kNoAxis) return false;
    SpeedLimits4 most_per_tick{};
    take_up_way_.fill(0);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        most_per_tick[k] = config_->axes[k].speed_per_tick;
        const bool up = block_.delta_pulses[k] > 0 || (block_.up_axes >> k & 1U) != 0;
        const bool down = block_.delta_pulses[k] < 0 || (block_.down_axes >> k & 1U) != 0;
        if (up == down || (still_axes_ >> k & 1U) != 0) continue;
        const std::int64_t extra = pulses_->take_up_pulses(k, up);
        take_up_way_[k] = up ? extra : -extra;
    }
    if (!start_straight(fine_, *config_, take_up_way_, most_per_tick)) return false;
    pulses_->want_directions(take_up_way_, tick);
    is_taking_up_ = true;
    return true;
}

Executor::Progress Executor::advance_take_up(std::uint64_t tick) noexcept {
    if (slowing_ && fine_.is_slowest() && !pulses_->is_gate_shut()) {
        fine_.rest();
        if (block_.kind == BlockKind::path) law_.rest();
        return kAtRest;
    }
    step_fine(tick, slowing_);
    if (!fine_.is_finished()) return kNothing;
    is_taking_up_ = false;
    if (block_.kind == BlockKind::move) start_fine();
    pulses_->want_directions(block_.delta_pulses, tick);
    return kNothing;
}

}  // namespace psicarve::cycle
