// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "hmi/cli/operator_break.hpp"
#include "hmi/gcode/approach.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {

/// What the machine does first where a program begins with a line, step by step.
struct LineStart {
    std::uint32_t line = 0;
    gcode::Approach approach;
    bool turns_shortest = false;  ///< psi goes the short way: how far depends on where it stands
    bool is_dry = false;
    bool is_spindle_on = false;  ///< the machine's, now
};

/// "before line 7 the machine does this:\n  the spindle goes on\n ...", without a line's end at its own.
std::string start_text(const LineStart& start);

/// Whether a person can be asked and reads the question: standard input and standard error are terminals.
bool can_ask() noexcept;
/// Asks on standard error until standard input answers. cancelled: the answer was no, or there was none.
Result<void> confirm_start(const OperatorBreak& operator_break);

}  // namespace psicarve::cli
