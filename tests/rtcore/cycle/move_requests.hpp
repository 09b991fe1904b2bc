// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <utility>

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/machine/jog_lease.hpp"

namespace psicarve::cycle {

inline constexpr std::uint32_t kToken = 77;

inline Request move_request(std::initializer_list<std::pair<Axis, std::int64_t>> targets) {
    Request request{};
    request.kind = RequestKind::move;
    request.order.drops_turns = 1;
    for (const auto& [axis, target] : targets) {
        request.order.axes = static_cast<std::uint8_t>(request.order.axes | 1U << index_of(axis));
        request.order.target_pulses[index_of(axis)] = target;
    }
    return request;
}

inline Request jog_request(Axis axis, std::int64_t way_pulses, double speed_pps = 0.0) {
    Request request = move_request({{axis, way_pulses}});
    request.kind = RequestKind::jog;
    request.order.drops_turns = 0;
    request.order.speed_pps = speed_pps;
    return request;
}

/// Held by kToken for so many ticks.
inline Request jog_on_request(Axis axis, bool up, double speed_pps, std::uint32_t lease_ticks) {
    Request request = jog_request(axis, up ? 1 : -1, speed_pps);
    request.kind = RequestKind::jog_on;
    request.lease_token = kToken;
    request.lease_ticks = lease_ticks;
    return request;
}

}  // namespace psicarve::cycle
