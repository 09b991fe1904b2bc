// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/gcode/modes_trail.hpp"
#include "shared/machine/program_modes.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::cli {

/// Follows the machine through the program that this process writes, and tells those who look on what holds
/// where it is.
class ModesTeller {
public:
    /// Both outlive it.
    ModesTeller(gcode::ModesTrail& trail, ProgramWriter& writer) noexcept : trail_(trail), writer_(writer) {}

    /// Some ten times a second. Writes only what is new.
    void follow(const ProgramReport& report);

private:
    gcode::ModesTrail& trail_;
    ProgramWriter& writer_;
    ProgramModes told_{};
    bool has_told_ = false;
};

}  // namespace psicarve::cli
