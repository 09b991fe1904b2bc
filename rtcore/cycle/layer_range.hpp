// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve::cycle {

/// The layers that a start is for, and how. In a request, and in the flight recorder, it is one number; that
/// of a whole run from layer n on is n. RT: yes.
struct LayerRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< 0: all that follow; below 2^31
    bool is_dry = false;      ///< heads outside, spindle off; table and y go as they would
};

inline constexpr std::uint32_t kDryBit = std::uint32_t{1} << 31U;

constexpr std::uint64_t packed(LayerRange range) noexcept {
    return std::uint64_t{range.count | (range.is_dry ? kDryBit : 0)} << 32U | range.first;
}

constexpr LayerRange layer_range(std::uint64_t packed_range) noexcept {
    const auto high = static_cast<std::uint32_t>(packed_range >> 32U);
    return {static_cast<std::uint32_t>(packed_range), high & ~kDryBit, (high & kDryBit) != 0};
}

}  // namespace psicarve::cycle
