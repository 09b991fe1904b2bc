// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>

#include "rtcore/cycle/arc_order.hpp"
#include "rtcore/cycle/cycle.hpp"

namespace psicarve::cycle {
namespace {

Refusal refusal_of(SoftLimit limit) noexcept {
    switch (limit) {
        case SoftLimit::none:
            break;
        case SoftLimit::travel:
            return Refusal::outside_travel;
        case SoftLimit::core_radius:
            return Refusal::inside_core_radius;
        case SoftLimit::head_clearance:
            return Refusal::heads_too_close;
    }
    return Refusal::none;
}

}  // namespace

Verdict Cycle::start_move(const Request& request) noexcept {
    if (state_ == MachineState::off) return {Refusal::not_homed};
    if (!next_state(state_, MachineEvent::move).has_value()) return {Refusal::not_in_this_state};
    if (!homed_.has_all()) return {Refusal::not_homed};
    const auto& from = pulses_.positions();
    auto to = from;
    const bool goes_on_with_heads = request.kind == RequestKind::jog_on && request.order.axes == 0b11;
    if (goes_on_with_heads) {
        to = furthest_of_heads(config_.soft_limits, from, request.order.target_pulses[0] > 0);
        if (to == from) return {Refusal::at_the_end, 0};
    }
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if (goes_on_with_heads || (request.order.axes >> k & 1U) == 0) continue;
        const std::int64_t target = request.order.target_pulses[k];
        if (request.kind == RequestKind::jog_on) {
            to[k] = furthest_pulses(config_.soft_limits, from, k, target > 0);
            if (to[k] == from[k]) return {Refusal::at_the_end, static_cast<std::uint8_t>(k)};
        } else {
            to[k] = request.kind == RequestKind::jog ? from[k] + target : target;
        }
    }
    SoftBreach breach = first_breach(config_.soft_limits, from, to);
    if (is_arc(request.order) && breach.limit == SoftLimit::none) {
        const ArcInPlane arc = arc_of(request.order, from, to);
        if (!arc.is_arc) return {Refusal::not_an_arc};
        breach = breach_on_arc(config_.soft_limits, arc, from);
    }
    if (breach.limit != SoftLimit::none)
        return {refusal_of(breach.limit), static_cast<std::uint8_t>(breach.axis)};
    record_order(request);
    move_.begin(request, io_->urgent.jog_lease.load(), clock_.tick());
    apply(MachineEvent::move);
    MotionOrder order = request.order;
    order.target_pulses = to;
    request_plan(PlanKind::move, kNoAxis, &order);
    return {Refusal::none};
}

// What a replay needs to ask for the same again.
void Cycle::record_order(const Request& request) noexcept {
    const MotionOrder& order = request.order;
    const auto note = [&](OrderPart part, std::uint8_t axis, std::int64_t value) noexcept {
        reporter_.report(RecordKind::order, static_cast<std::uint16_t>(part), axis, value);
    };
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if ((order.axes >> k & 1U) == 0) continue;
        note(OrderPart::target, static_cast<std::uint8_t>(k), order.target_pulses[k]);
    }
    if (order.shape != OrderShape::straight) {
        note(OrderPart::shape, kNoAxis, static_cast<std::int64_t>(order.shape));
        for (std::size_t i = 0; i < order.centre_pulses.size(); ++i) {
            note(OrderPart::centre, static_cast<std::uint8_t>(i), order.centre_pulses[i]);
        }
    }
    if (order.speed_pps > 0.0) {
        note(OrderPart::speed, kNoAxis, std::bit_cast<std::int64_t>(order.speed_pps));
    }
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
    executor_.slow_down();
}

Refusal Cycle::switch_spindle(bool on) noexcept {
    if (state_ == MachineState::off) return Refusal::not_homed;
    if (state_ != MachineState::ready && state_ != MachineState::moving) return Refusal::not_in_this_state;
    pulses_.set_spindle(on);
    publisher_.ask(clock_.tick());
    return Refusal::none;
}

}  // namespace psicarve::cycle
