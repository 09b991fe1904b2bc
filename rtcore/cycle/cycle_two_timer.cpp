// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/cycle.hpp"

namespace psicarve::cycle {

// One thread in place of two timers: what falls into one period of inputs and pulses, in the order of time.
//
//     io timer            |take, step |end        |           |           |           |take, step
//     interpolation timer |step       |step       |step       |step       |step       |step
//                         tick_       +1          +2          +3          +4          +5
void Cycle::tick_by_two_timers() noexcept {
    const auto interpolation_ticks = static_cast<std::uint64_t>(config_.interpolation_ticks);
    const std::uint64_t begin = tick_;
    take_inputs_and_step();
    for (std::uint64_t tick = begin; tick != tick_; ++tick) {
        const auto since_begin = static_cast<std::int64_t>(tick - begin);
        if (has_pulses_to_end_ && since_begin == config_.step_high_ticks) end_pulses();
        if (tick % interpolation_ticks == 0) interpolate();
    }
}

void Cycle::take_inputs_and_step() noexcept {
    take_in();
    const bool has_begun = executes() && pulses_.open_gate(tick_);
    has_pulses_to_end_ = has_begun && config_.step_high_ticks > 0;
    put_out();
    tick_ += static_cast<std::uint64_t>(config_.io_ticks);
    time_ns_ += config_.io_ticks * config_.period_ns;
}

// The tick is already the next one of inputs and pulses. Other levels that changed meanwhile wait for it.
void Cycle::end_pulses() noexcept {
    has_pulses_to_end_ = false;
    const std::uint64_t next_tick = tick_;
    const std::int64_t next_time_ns = time_ns_;
    const std::int64_t back_ticks = config_.io_ticks - config_.step_high_ticks;
    tick_ -= static_cast<std::uint64_t>(back_ticks);
    time_ns_ -= back_ticks * config_.period_ns;
    pulses_.end_pulses(tick_);
    written_ &= ~kStepMask;
    port_->write_outputs(written_, time_ns_);
    if (is_tracing()) trace_pins(0);
    tick_ = next_tick;
    time_ns_ = next_time_ns;
}

// What it decides shows on the pins at tick_, the next one of inputs and pulses.
void Cycle::interpolate() noexcept {
    go_on_with_motion();
}

void Cycle::advance_missed_interpolation(std::uint64_t steps) noexcept {
    missed_ticks_ += steps;
    check_gap((static_cast<std::int64_t>(steps) + 1) * config_.interpolation_ticks);
}

}  // namespace psicarve::cycle
