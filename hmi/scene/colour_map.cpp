// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/scene/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace psicarve::session {
namespace {

constexpr std::array<std::uint32_t, 11> kViridis{0x440154, 0x482475, 0x414487, 0x355F8D, 0x2A788E, 0x21918C,
                                                 0x22A884, 0x44BF70, 0x7AD151, 0xBDDF26, 0xFDE725};
constexpr std::array<std::uint32_t, 10> kVik{0x001261, 0x033E7D, 0x1E6F9D, 0x71A8C4, 0xC9DDE7,
                                             0xEACEBD, 0xD39774, 0xBE6533, 0x8B2706, 0x590008};

std::uint32_t mixed(std::span<const std::uint32_t> stops, double ratio) noexcept {
    const double place = std::clamp(ratio, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
    const auto index = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const double part = place - static_cast<double>(index);
    std::uint32_t rgb = 0;
    for (const unsigned shift : {16U, 8U, 0U}) {
        const auto from = static_cast<double>((stops[index] >> shift) & 0xFFU);
        const auto to = static_cast<double>((stops[index + 1] >> shift) & 0xFFU);
        rgb |= static_cast<std::uint32_t>(std::lround(from + part * (to - from))) << shift;
    }
    return rgb;
}

}  // namespace

std::uint32_t viridis(double ratio) noexcept {
    return mixed(kViridis, ratio);
}

std::uint32_t vik(double ratio) noexcept {
    return mixed(kVik, ratio);
}

}  // namespace psicarve::session
