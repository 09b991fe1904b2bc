// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "hmi/verify/motor/reach_boundary.hpp"

namespace psicarve::verify {

/// One entry of what an axis was told to do.
struct TrainEvent {
    enum class Kind : std::uint8_t { forward, backward, joint, pause };
    std::int64_t time_ns = 0;
    Kind kind = Kind::forward;

    bool is_pulse() const noexcept { return kind == Kind::forward || kind == Kind::backward; }
    std::int64_t count_after(std::int64_t count) const noexcept {
        return is_pulse() ? count + (kind == Kind::forward ? 1 : -1) : count;
    }
};

/// How far position and count may be apart: the rule's 1.5 pulses, and a margin for what the sets of states
/// leave out.
inline constexpr double kHalfRoom_pulses = 1.5 + 0.005;

/// Where the motor may be at a count.
inline Range room_at(std::int64_t count) noexcept {
    const auto middle = static_cast<double>(count);
    return {middle - kHalfRoom_pulses, middle + kHalfRoom_pulses};
}

/// At the edge of a pulse the motor is near both counts.
inline Range room_between(std::int64_t before, std::int64_t after) noexcept {
    return {std::max(room_at(before).low, room_at(after).low),
            std::min(room_at(before).high, room_at(after).high)};
}

}  // namespace psicarve::verify
