// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve::cycle {

/// The layers that a start is for, and how. In a request, and in the flight recorder, it is one number; that
/// of a whole run from layer n on is n. RT: yes.
struct LayerRange {
    std::uint32_t first = 0;  ///< this and all other counts: at most kMostOfRange
    std::uint32_t count = 0;  ///< 0: all that follow
    bool is_dry = false;      ///< heads outside, spindle off; table and y go as they would
    /// 0: from the first layer's begin; else one more than the point of its table that is begun with.
    std::uint32_t point_number = 0;
};

inline constexpr unsigned kRangeBits = 20;
inline constexpr std::uint32_t kMostOfRange = (std::uint32_t{1} << kRangeBits) - 1;
inline constexpr std::uint32_t kDryBit = std::uint32_t{1} << 31U;
/// The point's number has the bits that the two other counts leave of their words.
inline constexpr unsigned kPointLowBits = 32 - kRangeBits;

constexpr std::uint64_t packed(LayerRange range) noexcept {
    const std::uint32_t point = range.point_number & kMostOfRange;
    const std::uint32_t low = (range.first & kMostOfRange) | point << kRangeBits;
    const std::uint32_t high = (range.count & kMostOfRange) | point >> kPointLowBits << kRangeBits;
    return std::uint64_t{high | (range.is_dry ? kDryBit : 0)} << 32U | low;
}

constexpr LayerRange layer_range(std::uint64_t packed_range) noexcept {
    const auto low = static_cast<std::uint32_t>(packed_range);
    const auto high = static_cast<std::uint32_t>(packed_range >> 32U);
    const std::uint32_t point = low >> kRangeBits | (high & ~kDryBit) >> kRangeBits << kPointLowBits;
    return {low & kMostOfRange, high & kMostOfRange, (high & kDryBit) != 0, point & kMostOfRange};
}

}  // namespace psicarve::cycle
