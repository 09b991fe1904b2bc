// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/cycle.hpp"
#include "rtcore/cycle/order_target.hpp"

namespace psicarve::cycle {

Verdict Cycle::start_move(const Request& request) noexcept {
    if (state_ == MachineState::off) return {Refusal::not_homed};
    if (!next_state(state_, MachineEvent::move).has_value()) return {Refusal::not_in_this_state};
    if (!homed_.has_all()) return {Refusal::not_homed};
    const OrderTarget target = target_of(request, pulses_.positions(), config_.soft_limits);
    if (target.verdict.refusal != Refusal::none) return target.verdict;
    reporter_.report_order(request.order);
    move_.begin(request, io_->urgent.jog_lease.load(), clock_.tick());
    apply(MachineEvent::move);
    MotionOrder order = request.order;
    order.target_pulses = target.pulses;
    request_plan(PlanKind::move, kNoAxis, &order);
    return {Refusal::none};
}

void Cycle::check_lease() noexcept {
    const MoveEnd end = move_.due_end(io_->urgent.jog_lease.load(std::memory_order_acquire), clock_.tick());
    if (end != MoveEnd::none) end_jog(end);
}

void Cycle::end_jog(MoveEnd end) noexcept {
    if (state_ == MachineState::testing) return end_trial(end);
    if (state_ != MachineState::moving) return;
    move_.end(end);
    reporter_.report(RecordKind::jog_end, static_cast<std::uint16_t>(end));
    motion_.slow_down();
}

Refusal Cycle::switch_spindle(bool on) noexcept {
    if (state_ == MachineState::off) return Refusal::not_homed;
    if (state_ != MachineState::ready && state_ != MachineState::moving) return Refusal::not_in_this_state;
    pulses_.set_spindle(on);
    publisher_.ask(clock_.tick());
    return Refusal::none;
}

}  // namespace psicarve::cycle
