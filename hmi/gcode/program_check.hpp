// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "hmi/gcode/interpreter.hpp"
#include "hmi/gcode/line_source.hpp"
#include "hmi/gcode/problem.hpp"

namespace psicarve::gcode {

struct ProgramFacts {
    std::uint64_t line_count = 0;  ///< that were read: up to the program's end
    std::uint64_t motion_count = 0;
    bool has_end = false;
};

/// Reads a program to its end and gives what it means to `sink`. All that is wrong goes to `problems`; a
/// program without an end is. Memory does not grow with the program. An error is one of reading the bytes.
Result<ProgramFacts> interpret_program(LineSource& lines, const InterpreterOptions& options, CanonSink& sink,
                                       ProblemList& problems);

}  // namespace psicarve::gcode
