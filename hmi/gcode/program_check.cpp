// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/program_check.hpp"

#include "hmi/gcode/program_reader.hpp"

namespace psicarve::gcode {

Result<ProgramFacts> interpret_program(LineSource& lines, const InterpreterOptions& options, CanonSink& sink,
                                       ProblemList& problems) {
    return ProgramReader{lines, options, sink, problems}.read();
}

}  // namespace psicarve::gcode
