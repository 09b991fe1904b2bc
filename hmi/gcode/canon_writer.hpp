// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/gcode/canon.hpp"

namespace psicarve::gcode {

/// Appends a record as one JSON object and a line feed: lengths in mm and angles in degrees of the machine's
/// axes, to a millionth (docs/gcode.md).
void append_canon_line(const CanonRecord& record, std::string& text);

}  // namespace psicarve::gcode
