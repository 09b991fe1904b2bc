// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve::cycle {

/// The layers that a start is for. In a request, and in the flight recorder, it is one number; that of a
/// whole run from layer n on is n. RT: yes.
struct LayerRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;  ///< 0: all that follow
};

constexpr std::uint64_t packed(LayerRange range) noexcept {
    return std::uint64_t{range.count} << 32U | range.first;
}

constexpr LayerRange layer_range(std::uint64_t packed_range) noexcept {
    return {static_cast<std::uint32_t>(packed_range), static_cast<std::uint32_t>(packed_range >> 32U)};
}

}  // namespace psicarve::cycle
