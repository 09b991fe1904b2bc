// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "shared/machine/signal.hpp"

namespace psicarve {

inline constexpr std::size_t kShownGCodes = 16;
inline constexpr std::size_t kShownMCodes = 8;

/// What holds for a program at the motion record that the machine is at: written by the program's writer,
/// which follows the machine, a few times a second. It is for display: nothing moves by it, and whoever reads
/// it trusts none of its numbers.
struct ProgramModes {
    std::uint64_t program;                           ///< its number; 0: nobody has told anything
    std::uint64_t sequence;                          ///< of the last record of the way that it holds for
    std::uint64_t line;                              ///< of that way, from 1
    std::array<std::int16_t, kShownGCodes> g_codes;  ///< active ones in tenths (G54: 540); unused: -1
    std::array<std::int16_t, kShownMCodes> m_codes;  ///< active ones (M3: 3); unused: -1
    double feed;          ///< F as it was programmed, in the units of its mode; 0: none yet
    double speed_rpm;     ///< S; 0: none yet
    std::int64_t tool;    ///< T of the tool in the spindle; 0: none was named
    double rotation_deg;  ///< of the coordinate system in force
    std::array<double, kAxisCount>
        zero;  ///< by Axis: machine position that the program counts as 0 [mm, degrees]
    std::array<double, kAxisCount>
        end;  ///< by Axis: where the way at hand ends, a machine position [mm, degrees]
};
static_assert(sizeof(ProgramModes) == 168 && std::is_trivially_copyable_v<ProgramModes>,
              "bump kLayoutVersion");

}  // namespace psicarve
