// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hmi/gcode/kept_offsets.hpp"
#include "hmi/offsets/offsets_place.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::offsets {

/// A program that runs, or was ended before its end: --from-line begins with what it began with.
struct Unfinished {
    std::string program;  ///< its path from the root
    gcode::KeptOffsets began_with;
    bool operator==(const Unfinished&) const = default;
};

/// What a file of work offsets says.
struct Offsets {
    gcode::KeptOffsets kept;
    std::optional<Unfinished> unfinished;

    /// What a run of the program begins with. `program`: its path from the root, empty: none that can be read
    /// twice.
    const gcode::KeptOffsets& begin_of(std::string_view program, bool is_from_line) const noexcept;
    bool operator==(const Offsets&) const = default;
};

/// What was set between two states is set in a third one, too.
void carry_over(const gcode::KeptOffsets& before, const gcode::KeptOffsets& after, gcode::KeptOffsets& into);

/// As JSON, with the names of letters that move something or not, and which machine's they are.
std::string text_of(const Offsets& offsets, const GcodeProfile& letters);
/// bad_input, without the file's name, for what is no such text, of a newer format, or has other letters.
Result<Offsets> offsets_from(std::string_view text, const GcodeProfile& letters);

/// Nothing kept where there is no file. An error names the file and the remedy.
Result<Offsets> read_offsets(const OffsetsPlace& place, const GcodeProfile& letters);
/// Whole or not at all. Requires OffsetsLock, and a place where something is kept.
Result<void> write_offsets(const OffsetsPlace& place, const Offsets& offsets, const GcodeProfile& letters);

/// The file of the offsets that a recorded run began with, beside its trace.
std::string path_beside_trace(const std::string& trace_path);

}  // namespace psicarve::offsets
