// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "hmi/gcode/kept_offsets.hpp"
#include "shared/program/program_source.hpp"

namespace psicarve::offsets {

using SourceNumbers = std::array<double, kSourceNumbers>;

/// As they stand in a ProgramSource: of each system its zero by letter and its turn, G92's shift by letter
/// and whether it is in force, of each reference whether it is set, and its place by letter.
SourceNumbers source_numbers(const gcode::KeptOffsets& kept);
/// Nothing: no program can have begun with these.
std::optional<gcode::KeptOffsets> kept_from(const SourceNumbers& numbers);

}  // namespace psicarve::offsets
