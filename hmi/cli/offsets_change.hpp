// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "hmi/gcode/axis_letters.hpp"
#include "hmi/gcode/kept_offsets.hpp"
#include "shared/base/result.hpp"

namespace psicarve::cli {

/// "set G54 X=10 Z=0 R=5", "clear G54", "clear all", by words, made in `kept`. X and so on are the letters
/// that move an axis, in mm and degrees; R turns the system. bad_usage, and nothing is changed, where it is
/// no such change.
Result<void> change_offsets(const std::vector<std::string>& words, const gcode::AxisLetters& letters,
                            gcode::KeptOffsets& kept);

/// Whether it is "clear all", which needs nothing that was there.
bool clears_all(const std::vector<std::string>& words);

}  // namespace psicarve::cli
