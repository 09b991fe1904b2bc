// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/cycle.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cycle {

// Steps that turn the axes meanwhile are not counted: their positions are lost.
Refusal Cycle::try_pin(const Request& request) noexcept {
    const PinOrder order = pin_order(request.value);
    const bool is_testing = state_ == MachineState::testing;
    if (!next_state(state_, MachineEvent::begin_test).has_value()) return Refusal::not_in_this_state;
    if (is_testing && !move_.is_of(request.lease_token)) return Refusal::not_in_this_state;
    if (!order.is_on) {
        if (is_testing) end_trial(MoveEnd::released);
        return Refusal::none;
    }
    if ((inputs_.raw() & kEstopBit) != 0) return Refusal::still_tripped;
    homed_.lose_all();
    move_.begin(request, io_->urgent.jog_lease.load(), clock_.tick());
    const std::int64_t half_ticks = order.half_ms * kNsPerMs / config_.period_ns;
    trial_.begin(bit_of(static_cast<Signal>(order.signal)) & kOutputMask, order.pulses,
                 half_ticks > 0 ? static_cast<std::uint64_t>(half_ticks) : 1, clock_.tick());
    apply(MachineEvent::begin_test);
    publisher_.ask(clock_.tick());
    return Refusal::none;
}

void Cycle::go_on_with_trial() noexcept {
    trial_.advance(clock_.tick());
    if (trial_.is_over()) return end_trial(MoveEnd::reached);
    pulses_.force(trial_.levels());
}

void Cycle::end_trial(MoveEnd end) noexcept {
    move_.end(end);
    apply(MachineEvent::end_test);
}

Refusal Cycle::drives_off() noexcept {
    // Off, a drive may hold an axis that was homed alone.
    const bool holds_axis = state_ == MachineState::off && (pulses_.levels() & kEnableMask) != 0;
    if (!holds_axis && !next_state(state_, MachineEvent::drives_off).has_value())
        return Refusal::not_in_this_state;
    homed_.lose_all();
    if (holds_axis) pulses_.make_safe();
    publisher_.ask(clock_.tick());
    apply(MachineEvent::drives_off);
    return Refusal::none;
}

}  // namespace psicarve::cycle
