// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/cycle.hpp"

namespace psicarve::cycle {

// One thread in place of two timers: what falls into one period of inputs and pulses, in the order of time.
//
//     io timer            |take, step |end        |           |           |           |take, step
//     interpolation timer |step       |step       |step       |step       |step       |step
//                         tick        +1          +2          +3          +4          +5
void Cycle::tick_by_two_timers() noexcept {
    const auto interpolation_ticks = static_cast<std::uint64_t>(config_.interpolation_ticks);
    const std::uint64_t begin = clock_.tick();
    take_inputs_and_step();
    for (std::uint64_t tick = begin; tick != clock_.tick(); ++tick) {
        const auto since_begin = static_cast<std::int64_t>(tick - begin);
        if (has_pulses_to_end_ && since_begin == config_.step_high_ticks) end_pulses();
        if (tick % interpolation_ticks == 0) interpolate();
    }
}

void Cycle::take_inputs_and_step() noexcept {
    take_in();
    const bool has_begun = executes() && pulses_.open_gate(clock_.tick());
    has_pulses_to_end_ = has_begun && config_.step_high_ticks > 0;
    put_out();
    clock_.advance(config_.io_ticks);
}

// The tick is already the next one of inputs and pulses.
void Cycle::end_pulses() noexcept {
    has_pulses_to_end_ = false;
    outlet_.end_pulses(clock_.before(config_.io_ticks - config_.step_high_ticks));
}

// What it decides shows on the pins at the next tick, that one of inputs and pulses.
void Cycle::interpolate() noexcept {
    go_on_with_motion();
}

void Cycle::advance_missed_interpolation(std::uint64_t steps) noexcept {
    clock_.count_missed(steps);
    check_gap((static_cast<std::int64_t>(steps) + 1) * config_.interpolation_ticks);
}

}  // namespace psicarve::cycle
