// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "rtcore/cycle/executor.hpp"
#include "shared/status.hpp"

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
    std::array<std::int64_t, kAxisCount> way{};
    std::int64_t longest = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const bool up = block_.delta_pulses[k] > 0 || (block_.up_axes >> k & 1U) != 0;
        const bool down = block_.delta_pulses[k] < 0 || (block_.down_axes >> k & 1U) != 0;
        if (up == down) continue;
        const std::int64_t extra = pulses_->take_up_pulses(k, up);
        way[k] = up ? extra : -extra;
        longest = std::max(longest, extra);
    }
    if (longest == 0) return false;
    double start = 1.0;
    double speed = 1.0;
    double accel = 1.0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (way[k] == 0) continue;
        const AxisConfig& axis = config_->axes[k];
        const double ratio =
            static_cast<double>(longest) / static_cast<double>(way[k] > 0 ? way[k] : -way[k]);
        start = std::min(start, axis.start_stop_per_tick * ratio);
        speed = std::min(speed, axis.speed_per_tick * ratio);
        accel = std::min(accel, axis.accel_per_tick2 * ratio);
    }
    fine_.start(way, std::min(start, speed), speed, accel);
    pulses_->want_directions(way, tick);
    is_taking_up_ = true;
    return true;
}

Executor::Progress Executor::advance_take_up(std::uint64_t tick) noexcept {
    if (slowing_ && fine_.is_slowest()) {
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
