// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/order_target.hpp"

#include "rtcore/cycle/arc_order.hpp"

namespace psicarve::cycle {
namespace {

using Positions4 = std::array<std::int64_t, kAxisCount>;

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

OrderTarget furthest(const MotionOrder& order, const Positions4& from, const SoftLimits& limits) noexcept {
    OrderTarget target{{Refusal::none}, from};
    if (order.axes == 0b11) {
        target.pulses = furthest_of_heads(limits, from, order.target_pulses[0] > 0);
        if (target.pulses == from) target.verdict = {Refusal::at_the_end, 0};
        return target;
    }
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if ((order.axes >> k & 1U) == 0) continue;
        target.pulses[k] = furthest_pulses(limits, from, k, order.target_pulses[k] > 0);
        if (target.pulses[k] != from[k]) continue;
        target.verdict = {Refusal::at_the_end, static_cast<std::uint8_t>(k)};
        break;
    }
    return target;
}

OrderTarget ordered(const Request& request, const Positions4& from) noexcept {
    OrderTarget target{{Refusal::none}, from};
    const MotionOrder& order = request.order;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if ((order.axes >> k & 1U) == 0) continue;
        target.pulses[k] = order.target_pulses[k] + (request.kind == RequestKind::jog ? from[k] : 0);
    }
    return target;
}

Verdict judge_way(const MotionOrder& order, const Positions4& from, const Positions4& to,
                  const SoftLimits& limits) noexcept {
    SoftBreach breach = first_breach(limits, from, to);
    if (is_arc(order) && breach.limit == SoftLimit::none) {
        const ArcInPlane arc = arc_of(order, from, to);
        if (!arc.is_arc) return {Refusal::not_an_arc};
        breach = breach_on_arc(limits, arc, from);
    }
    if (breach.limit == SoftLimit::none) return {Refusal::none};
    return {refusal_of(breach.limit), static_cast<std::uint8_t>(breach.axis)};
}

}  // namespace

OrderTarget target_of(const Request& request, const Positions4& from_pulses,
                      const SoftLimits& limits) noexcept {
    const bool goes_on = request.kind == RequestKind::jog_on;
    OrderTarget target =
        goes_on ? furthest(request.order, from_pulses, limits) : ordered(request, from_pulses);
    if (target.verdict.refusal == Refusal::none) {
        target.verdict = judge_way(request.order, from_pulses, target.pulses, limits);
    }
    return target;
}

}  // namespace psicarve::cycle
