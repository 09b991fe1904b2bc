// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "shared/machine/signal.hpp"

namespace psicarve::session {

/// "R1", "R2", "Ψ", "Y".
constexpr const char* axis_letter(Axis axis) noexcept {
    constexpr std::array<const char*, kAxisCount> kLetters{"R1", "R2", "Ψ", "Y"};
    return kLetters[index_of(axis)];
}

}  // namespace psicarve::session
