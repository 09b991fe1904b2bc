// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "hmi/cli/program_reading.hpp"
#include "hmi/gcode/record_maker.hpp"
#include "shared/base/result.hpp"
#include "shared/program/program_source.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::cli {

/// Tells whose records the writer's are. The program has begun, and none of it was asked for.
Result<void> tell_source(ProgramWriter& writer, const GcodeRunOptions& options, const Profile& profile,
                         const CoreStatus& status, const gcode::KeptOffsets& offsets);

/// A source in a snapshot as what it stands for, and the text that is to be its.
struct SourcedProgram {
    GcodeRunOptions options;
    bool is_stream = false;
    Profile profile;
    gcode::InterpreterOptions language;
    gcode::RunOptions steps;
};
/// bad_input: it is another text, or the source cannot be believed. `snapshot`: its file, for messages.
Result<SourcedProgram> sourced_program(const RecordedSource& recorded, const std::string& path,
                                       const std::string& snapshot);

/// Makes the records that the core had taken, and refuses a text that makes others. Its errors go to
/// standard error.
Result<void> require_same_records(const SourcedProgram& program, const RecordedSource& recorded,
                                  const std::string& snapshot);

}  // namespace psicarve::cli
