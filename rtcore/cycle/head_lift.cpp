// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/head_lift.hpp"

#include <algorithm>

#include "rtcore/cycle/straight_way.hpp"

namespace psicarve::cycle {

void HeadLift::lift() noexcept {
    if (!is_active()) {
        for (std::size_t k = 0; k < kHeads; ++k) {
            path_pulses_[k] = pulses_->positions()[k];
            path_slack_[k] = pulses_->take_up_pulses(k, true);
            out_pulses_[k] = std::max(path_pulses_[k], std::min(path_pulses_[k] + config_->lift_pulses[k],
                                                                config_->axes[k].travel_max_pulses));
        }
        is_moving_ = false;
    }
    turn_to(Aim::out);
}

void HeadLift::lower() noexcept {
    turn_to(Aim::path);
}

// The last pulse may have been one the other way.
void HeadLift::turn_to(Aim aim) noexcept {
    aim_ = aim;
    must_rest_ = is_moving_;
    rest_left_ = config_->rest_ticks;
}

HeadLift::Progress HeadLift::step(std::uint64_t tick) noexcept {
    if (is_moving_) {
        move(tick);
        return Progress::going_on;
    }
    if (rest_left_ > 0) {
        --rest_left_;
        return Progress::going_on;
    }
    // Only then is it known where the tips are.
    if (pulses_->is_gate_shut()) return Progress::going_on;
    return next_leg(tick);
}

void HeadLift::move(std::uint64_t tick) noexcept {
    if (must_rest_ && fine_.is_slowest()) {
        // What was left of this way is worked out anew from where the tips are.
        is_moving_ = false;
        must_rest_ = false;
        return;
    }
    step_along(fine_, *pulses_, tick, must_rest_);
    if (!fine_.is_finished()) return;
    is_moving_ = false;
    must_rest_ = false;
    rest_left_ = config_->rest_ticks;
}

HeadLift::Progress HeadLift::next_leg(std::uint64_t tick) noexcept {
    if (aim_ == Aim::halt) return Progress::halted;
    const auto& goal = aim_ == Aim::out ? out_pulses_ : path_pulses_;
    std::array<std::int64_t, kAxisCount> way{};
    for (std::size_t k = 0; k < kHeads; ++k) {
        const std::int64_t tip = goal[k] - pulses_->positions()[k];
        if (tip > 0) way[k] = tip + pulses_->take_up_pulses(k, true);
        if (tip < 0) way[k] = tip - pulses_->take_up_pulses(k, false);
    }
    if (begin_leg(way, tick)) return Progress::going_on;
    if (aim_ == Aim::out) return Progress::lifted;
    // The tips are there; now each screw's gap, as wide open on either side as it was.
    for (std::size_t k = 0; k < kHeads; ++k) way[k] = pulses_->take_up_pulses(k, true) - path_slack_[k];
    if (begin_leg(way, tick)) return Progress::going_on;
    forget();
    return Progress::back;
}

bool HeadLift::begin_leg(const std::array<std::int64_t, kAxisCount>& way_pulses,
                         std::uint64_t tick) noexcept {
    SpeedLimits4 most_per_tick{};
    for (std::size_t k = 0; k < kHeads; ++k) {
        most_per_tick[k] = config_->axes[k].speed_per_tick;
        if (way_pulses[k] < 0)
            most_per_tick[k] = std::min(most_per_tick[k], config_->lower_speed_per_tick[k]);
    }
    if (!start_straight(fine_, *config_, way_pulses, most_per_tick)) return false;
    pulses_->want_directions(way_pulses, tick);
    is_moving_ = true;
    return true;
}

}  // namespace psicarve::cycle
