// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/gcode/interpreter.hpp"
#include "hmi/gcode/line_source.hpp"
#include "hmi/gcode/problem.hpp"

namespace psicarve::gcode {

struct ProgramFacts {
    std::uint64_t line_count = 0;  ///< lines read: up to the program's end
    std::uint64_t motion_count = 0;
    bool has_end = false;
};

/// Reads a program to its end and gives its meaning to `sink`. All faults go to `problems`; a missing end is
/// one, except where a stream may end without. Memory does not grow with the program. Ends early where the
/// sink wants no more. An error means that the bytes could not be read.
Result<ProgramFacts> interpret_program(LineSource& lines, const InterpreterOptions& options, CanonSink& sink,
                                       ProblemList& problems);

}  // namespace psicarve::gcode
