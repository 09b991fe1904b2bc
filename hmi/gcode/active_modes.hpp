// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "hmi/gcode/position.hpp"
#include "shared/machine/program_modes.hpp"

namespace psicarve::gcode {

/// What holds for a program, as it is shown to those who look on.
struct ActiveModes {
    std::array<std::int16_t, kShownGCodes> g_codes{};  ///< as ProgramModes has them
    std::array<std::int16_t, kShownMCodes> m_codes{};
    double feed = 0.0;
    double speed_rpm = 0.0;
    std::int64_t tool = 0;
    double rotation_deg = 0.0;
    Position zero{};  ///< of the program, machine coordinates: system, G92 and tool length together
    bool operator==(const ActiveModes&) const = default;
};

}  // namespace psicarve::gcode
