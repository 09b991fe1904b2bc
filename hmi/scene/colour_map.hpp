// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve::session {

/// Viridis at 0 to 1, as 0xRRGGBB.
std::uint32_t viridis(double ratio) noexcept;
/// Vik at 0 to 1: blue, pale in the middle, brown.
std::uint32_t vik(double ratio) noexcept;

}  // namespace psicarve::session
