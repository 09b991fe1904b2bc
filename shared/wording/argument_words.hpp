// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/message/message.hpp"

namespace psicarve {

/// Whether an argument is something of its kind: an axis that there is, a number that is one.
bool is_sound(const Argument& argument) noexcept;

/// "r1", "60.000 mm", "ready or off". Requires a sound argument; `mm_digits`: of a length.
std::string words_of(const Argument& argument, const Message& message, int mm_digits);

}  // namespace psicarve
