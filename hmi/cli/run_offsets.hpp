// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "hmi/cli/command_set.hpp"
#include "hmi/gcode/offsets_log.hpp"
#include "hmi/offsets/offsets_file.hpp"
#include "hmi/offsets/offsets_lock.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::cli {

/// Where the work offsets of the machine are that the common options mean: of the core that serves the
/// segment, and while none does, of the real machine.
offsets::OffsetsPlace offsets_place(const CommonOptions& common);
/// Those that are kept there.
Result<offsets::Offsets> kept_offsets(const CommonOptions& common, const Profile& profile);

/// The work offsets of a program's run: those that it begins with, and those that it leaves.
class RunOffsets {
public:
    struct Run {
        std::string program;  ///< its file; empty: a stream
        bool is_from_line = false;
        bool keeps = true;  ///< what it sets outlives it
    };
    static Result<RunOffsets> read(const CommonOptions& common, const Profile& profile, const Run& run);

    const gcode::KeptOffsets& begin() const noexcept { return begin_; }
    /// Before the first record is written. From here on nobody else changes them; an error where somebody has
    /// since they were read.
    Result<void> hold();

    // While it runs, and once it is over:
    /// How far the machine is: keeps what it has reached, now and then.
    void watch(gcode::OffsetsLog& log, const ProgramReport& report);
    /// `is_whole`: to its end. An error where something was to be kept and could not be.
    Result<void> finish(gcode::OffsetsLog& log, const ProgramReport& report, bool is_whole);

    /// Beside a trace that was written, for whoever judges it later.
    void write_beside(const std::string& trace_path) const;

private:
    RunOffsets(offsets::OffsetsPlace place, GcodeProfile letters) noexcept
        : place_(std::move(place)), letters_(letters) {}
    offsets::Offsets left_by(const gcode::KeptOffsets& reached, bool is_whole) const;
    Result<void> store(const offsets::Offsets& left);

    offsets::OffsetsPlace place_;
    GcodeProfile letters_;
    Run run_;
    offsets::Offsets before_;  ///< as it was read
    offsets::Offsets stored_;
    gcode::KeptOffsets begin_;
    std::optional<offsets::OffsetsLock> lock_;
    std::chrono::steady_clock::time_point next_store_{};
};

}  // namespace psicarve::cli
