// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "hmi/cli/command_set.hpp"
#include "hmi/gcode/interpreter.hpp"
#include "hmi/verify/program/program_verifier.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {

/// What `psicarve verify --program` is asked.
struct ProgramVerifyOptions {
    std::string program;
    std::string offsets;  ///< their file; empty: the one beside the trace
    std::string dialect = "ngc";
    bool skips_deleted = false;
    std::uint32_t override_percent = 100;
};

/// A file of G-code as it was when its state was taken, to be judged by.
verify::JudgedProgram program_of_file(const std::string& path, const gcode::FileState& state,
                                      const gcode::InterpreterOptions& language,
                                      std::uint32_t override_percent);

/// Judges a trace by a program, prints the report and returns the exit code.
Result<int> verify_program(const CommonOptions& common, const std::string& trace_path,
                           const ProgramVerifyOptions& options);

}  // namespace psicarve::cli
