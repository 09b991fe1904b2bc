// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hmi/cli/command_set.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/gcode/approach.hpp"
#include "hmi/gcode/interpreter.hpp"
#include "hmi/gcode/line_source.hpp"
#include "hmi/gcode/program_check.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/status.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {

/// A program in G-code, and how it is to be run.
struct GcodeRunOptions {
    std::string path;
    std::string dialect = "ngc";
    std::uint32_t from_line = 0;
    bool is_single = false;
    bool stops_at_optional = false;
    bool skips_deleted = false;
    bool is_dry = false;
    bool is_typed = false;  ///< a block that an operator typed, in a file
    bool is_simulated = false;
    bool is_confirmed = false;  ///< what a run from a line does first need not be asked
    std::string trace;
    std::optional<gcode::FileState> state{};  ///< of a file, as it is checked, run and judged

    bool is_stream() const { return path == "-"; }
    /// Those that act while it runs, as kProgram... bits.
    std::uint32_t switches() const {
        return (is_single ? kProgramIsSingle : 0) | (stops_at_optional ? kProgramStopsAtOptional : 0);
    }
};

/// How the program is read. It begins where the machine stands.
gcode::InterpreterOptions language_of(const GcodeRunOptions& options, const Profile& profile,
                                      const CoreStatus& status, const gcode::KeptOffsets& offsets);

/// Of a program that is right, and what a run from its line does first.
struct RightProgram {
    gcode::ProgramFacts facts;
    gcode::Approach approach;
};

/// Reads the whole file before the first pulse. Nothing: it is wrong, and that was told.
Result<std::optional<RightProgram>> read_right_program(const GcodeRunOptions& options,
                                                       const gcode::InterpreterOptions& how,
                                                       const Profile& profile, const CommonOptions& common,
                                                       const OperatorBreak& operator_break);

}  // namespace psicarve::cli
