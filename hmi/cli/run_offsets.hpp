// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hmi/cli/command_set.hpp"
#include "hmi/offsets/settled_offsets.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::cli {

/// Where the work offsets of the machine are that the common options mean: of the core that serves the
/// segment, and while none does, of the real machine. An error where that cannot be known.
Result<offsets::OffsetsPlace> offsets_place(const CommonOptions& common);
offsets::OffsetsOwner offsets_owner(const CommonOptions& common);
/// Those that are kept there. Warns of what was dropped.
Result<offsets::Offsets> kept_offsets(const CommonOptions& common, const Profile& profile);

/// The work offsets of a program's run, a transaction: those that it begins with, and those that it leaves if
/// it ends in order. Else the file stays as it was.
class RunOffsets {
public:
    /// `keeps`: what it sets outlives it.
    static Result<RunOffsets> read(const CommonOptions& common, const Profile& profile, bool keeps);
    /// Of the same machine, as they are now.
    Result<void> read_again();

    const gcode::KeptOffsets& begin() const noexcept { return begin_.kept; }
    /// Says so where a program does not begin at the machine's zero.
    void tell_begin() const;
    /// Before the first record is written. From here on no other process changes them; an error where one has
    /// since they were read, or where none can be written.
    Result<void> hold();

    /// Before the program's last record is written, by whichever thread writes it: their next reader
    /// keeps or drops what it left, if this process does not live to do that.
    void promise(const gcode::KeptOffsets& left, const Segment& segment, std::uint64_t program);
    /// No thread writes any more. `is_in_order`: the program was right, and is run to its end. An error where
    /// something was to be kept and could not be.
    Result<void> finish(const gcode::KeptOffsets& left, bool is_in_order, const Segment& segment,
                        std::uint64_t program);

    /// Beside a trace that was written, and with which profile, for judging it later.
    void write_beside(const std::string& trace_path) const;

private:
    RunOffsets(offsets::OffsetsPlace place, offsets::OffsetsOwner owner, const Profile& profile, bool keeps)
        : place_(std::move(place)),
          owner_(std::move(owner)),
          letters_(profile.gcode),
          made_with_{profile.name, profile_hash(profile)},
          keeps_(keeps) {}

    offsets::OffsetsPlace place_;
    offsets::OffsetsOwner owner_;
    GcodeProfile letters_;
    offsets::ProfileMark made_with_;
    bool keeps_;
    offsets::Offsets begin_;
    bool has_promised_ = false;
    std::optional<offsets::OffsetsLock> lock_;
};

}  // namespace psicarve::cli
