// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace psicarve::gcode {

/// Modal groups, as RS274/NGC has them: a block may have one code of each.
enum class CodeGroup : std::uint8_t {
    once,          ///< G4 G10 G28 G30 G53 G92 and those with a point
    motion,        ///< G0 G1 G2 G3 G80 G81 G82 G83
    plane,         ///< G17 G18 G19
    distance,      ///< G90 G91
    arc_distance,  ///< G90.1 G91.1
    feed_mode,     ///< G93 G94 G95
    units,         ///< G20 G21
    compensation,  ///< G40
    length,        ///< G43.1 G49
    retract,       ///< G98 G99
    system,        ///< G54 to G59.3
    path,          ///< G61 G61.1 G64
    drawing,       ///< G7.1 G12.1 G13.1
    outputs,       ///< M62 to M66
    tool,          ///< M6
    spindle,       ///< M3 M4 M5
    coolant,       ///< M7 M8 M9
    overrides,     ///< M48 to M53
    stop,          ///< M0 M1 M2 M30 M60 M98 M99
};
inline constexpr std::size_t kCodeGroupCount = 19;
inline constexpr int kNoCode = -1;

/// What is known of a code. Codes are counted in tenths: G92.1 is 921.
enum class CodeStanding : std::uint8_t { unknown, known, compensation, tool_table };
struct CodeEntry {
    CodeStanding standing = CodeStanding::unknown;
    CodeGroup group = CodeGroup::once;
};
CodeEntry g_code_entry(int tenths) noexcept;
CodeEntry m_code_entry(int number) noexcept;

}  // namespace psicarve::gcode
