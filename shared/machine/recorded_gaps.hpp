// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "shared/machine/signal.hpp"

namespace psicarve {

/// Of each axis, how many pulses of its screw's gap the motor has still to cross the way its direction pin
/// shows before the tip follows. All 0 unless a stop came in the midst of a gap.
using GapsLeft = std::array<std::int64_t, kAxisCount>;

inline constexpr unsigned kRecordedGapBits = 16;
inline constexpr std::int64_t kMostRecordedGap = 0xffff;  ///< pulses; a longer rest counts as this

/// As the value of the record that the machine came to rest (flight recorder).
constexpr std::int64_t recorded_gaps(const GapsLeft& left_pulses) noexcept {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const std::int64_t left = std::clamp<std::int64_t>(left_pulses[k], 0, kMostRecordedGap);
        value |= static_cast<std::uint64_t>(left) << (kRecordedGapBits * k);
    }
    return static_cast<std::int64_t>(value);
}

constexpr GapsLeft gaps_left(std::int64_t recorded_value) noexcept {
    const auto value = static_cast<std::uint64_t>(recorded_value);
    GapsLeft left{};
    for (std::size_t k = 0; k < kAxisCount; ++k)
        left[k] = static_cast<std::int64_t>(value >> (kRecordedGapBits * k)) & kMostRecordedGap;
    return left;
}

}  // namespace psicarve
