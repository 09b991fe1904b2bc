// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace psicarve::gcode {

/// Whether M2 or M30 stands in the text, however it is written.
bool names_end(std::string_view line) noexcept;

}  // namespace psicarve::gcode
