// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "hmi/gcode/kept_offsets.hpp"
#include "hmi/offsets/offsets_place.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::offsets {

/// Which run of a program, in the life of which core.
struct ProgramIdentity {
    std::string segment;  ///< its name, with the slash
    std::string boot_id;  ///< of the computer when it ran
    std::uint32_t core_pid = 0;
    std::uint64_t core_start_time = 0;  ///< as in the segment's header
    std::uint64_t program = 0;          ///< its number, which no other program of that core has
    bool operator==(const ProgramIdentity&) const = default;
};

/// What a program leaves if it ends in order. In the file from before its last record is written until its
/// reader has seen how it ended, for the case that the reader does not live to see it.
struct Pending {
    ProgramIdentity of;
    gcode::KeptOffsets offsets;
    bool operator==(const Pending&) const = default;
};

/// With which machine's profile a recorded run was made.
struct ProfileMark {
    std::string name;
    std::uint64_t hash = 0;  ///< profile_hash()
    bool operator==(const ProfileMark&) const = default;
};

/// What a file of work offsets says.
struct Offsets {
    gcode::KeptOffsets kept;
    std::optional<Pending> pending{};
    std::optional<ProfileMark> profile{};  ///< beside a trace
    bool operator==(const Offsets&) const = default;
};

/// As JSON, with the names of letters that move something or not, and which machine's they are.
std::string text_of(const Offsets& offsets, const GcodeProfile& letters);
/// bad_input, without the file's name, for what is no such text, of a newer format, or has other letters.
Result<Offsets> offsets_from(std::string_view text, const GcodeProfile& letters);

/// Nothing kept where there is no file. An error names the file and the remedy.
Result<Offsets> read_offsets(const OffsetsPlace& place, const GcodeProfile& letters);
/// Whole or not at all; refused where read_offsets() would refuse it. Requires OffsetsLock, and a place where
/// something is kept.
Result<void> write_offsets(const OffsetsPlace& place, const Offsets& offsets, const GcodeProfile& letters);

/// The file of the offsets that a recorded run began with, beside its trace.
std::string path_beside_trace(const std::string& trace_path);

}  // namespace psicarve::offsets
