// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cli/command_set.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/record_feeder.hpp"
#include "hmi/gcode/canon.hpp"
#include "hmi/gcode/interpreter.hpp"
#include "hmi/gcode/line_source.hpp"
#include "hmi/gcode/problem.hpp"
#include "hmi/gcode/program_check.hpp"
#include "hmi/machine/machine_link.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {

// What a machine must be for a program in G-code.

/// The core's numbers are pulses, and its limits are its own.
Result<Profile> profile_of_core(const machine::MachineLink& link, const CommonOptions& common);
Result<void> require_ready(const Segment& segment, const CoreStatus& status);
/// Where one letter moves both heads they must begin alike: the first move would drive R2 where it was not
/// sent it.
Result<void> require_heads_alike(const Profile& profile, const CoreStatus& status);

Error interrupted_before_it_began();

/// So that the core finds something to plan. Nothing was sent to it yet.
Result<void> wait_for_records(const RecordFeeder& feeder, const machine::MachineLink& link,
                              const OperatorBreak& operator_break);
/// Reads a program until it is interrupted; then that is the error.
Result<gcode::ProgramFacts> interpret_patiently(gcode::LineSource& lines,
                                                const gcode::InterpreterOptions& how, gcode::CanonSink& sink,
                                                gcode::ProblemList& problems,
                                                const OperatorBreak& operator_break);

}  // namespace psicarve::cli
