// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/file/state_place.hpp"
#include "shared/machine/command.hpp"
#include "shared/profile/profile.hpp"
#include "shared/segment/checkpoint.hpp"

namespace psicarve {

/// Names one record, so that a newer one in its place is not taken for it.
struct RecordName {
    std::string segment_name;  ///< with its slash
    bool is_simulator = false;
    std::uint64_t job_checksum = 0;
    std::uint64_t sequence = 0;  ///< 0: on no disk, only in the segment
    bool operator==(const RecordName&) const = default;
};

/// A checkpoint as it stands on a disk, with what a reader needs to know when segment and core are gone.
struct SavedCheckpoint {
    Checkpoint checkpoint{};
    std::uint64_t job_bytes = 0;     ///< of the job's blob
    std::uint64_t profile_hash = 0;  ///< of the core's profile
    std::uint64_t sequence = 0;      ///< larger than that of the record before it in its folder
    std::int64_t written_s = 0;      ///< by the computer's clock, which may be set back: seconds, UTC
    bool is_simulator = false;       ///< the machine was simulated
    std::string segment_name;        ///< of the core's segment, with its slash
    std::string source_name;         ///< of the job
    std::string tool;                ///< of the job: "ball, 3 mm"

    /// Whether it belongs to this segment and this kind of machine: a file's name alone may be another's.
    bool is_of(const std::string& segment, bool is_simulated) const {
        return segment_name == segment && is_simulator == is_simulated;
    }
    RecordName name() const { return {segment_name, is_simulator, checkpoint.job_checksum, sequence}; }
    /// The carving began, and has not come to its end.
    bool is_unfinished() const noexcept { return psicarve::is_unfinished(checkpoint); }
};

/// "ball, 3 mm", "point".
std::string tool_text(const ToolProfile& tool);

/// The bytes of a file of fixed size, little-endian: magic, version, size, checksum over all of it, then the
/// fields. Texts that do not fit are cut.
std::vector<std::byte> saved_checkpoint_bytes(const SavedCheckpoint& saved);
/// Trusts no byte. Error: "FILE: what is wrong".
Result<SavedCheckpoint> parse_saved_checkpoint(std::span<const std::byte> bytes,
                                               const std::string& file_name);
Result<SavedCheckpoint> load_saved_checkpoint(const std::string& path);
/// As write_file_atomically; all users may read the file.
Result<void> save_checkpoint(const SavedCheckpoint& saved, const std::string& path);

/// Which core keeps a record, while a core serves the segment.
enum class Keeper : std::uint8_t {
    unknown = 0,     ///< no core serves it, or the core has not said where it keeps anything
    this_core = 1,   ///< this core keeps the record here
    other_core = 2,  ///< this core keeps its own elsewhere, or none: it ignores this record
};

struct FoundCheckpoint {
    SavedCheckpoint saved;
    std::string path;
    std::string job_path;  ///< of the job's copy; empty: there is none
    Keeper keeper = Keeper::unknown;
    /// Unfinished pieces of the same segment in other folders, older by the clock. Which of them is on the
    /// table, only the person who mounted it knows.
    std::vector<std::string> other_paths{};
};

/// The record of this segment and this kind of machine in this folder. Nothing where there is none that can
/// be read, is whole, and belongs to this segment and this kind of machine.
std::optional<FoundCheckpoint> find_in(const std::string& folder, const std::string& segment_name,
                                       bool is_simulator);

/// The newest record in all folders. A core that says where it keeps its record decides, if that folder is
/// one of these, also when it has none. Else the one that was written last, as far as clocks tell: sequences
/// of two folders cannot be compared.
std::optional<FoundCheckpoint> find_newest(const std::string& segment_name, bool is_simulator,
                                           const std::vector<std::string>& folders,
                                           const CoreKeeping& core = {});

/// The unfinished piece of this segment, in `folder` or, where that is empty, in all folders in which cores
/// keep them (state_folders_to_read): of a real machine before one of a simulated, or of one kind alone.
/// `core`: Segment::core_keeping of the core that serves the segment. May wait for a disk that hangs.
std::optional<FoundCheckpoint> find_unfinished(const std::string& segment_name,
                                               std::optional<bool> is_simulator = {},
                                               const std::string& folder = {}, const CoreKeeping& core = {});

/// Removes the record at this path, durably, if it is this one. Success where there is none; machine_refused
/// where another stands there, bad_input where the file does not say: both are left alone.
Result<void> withdraw_record(const std::string& path, const RecordName& record);

/// Removes exactly the record that was found, and its job's copy, so that they stay away (withdraw_file).
/// Only where no core keeps it: no other record may be written meanwhile, or the caller holds the lock of the
/// segment's core. Success where it is gone already; machine_refused where another stands in its place, which
/// is left alone.
Result<void> forget_piece(const FoundCheckpoint& found);

/// Makes the command that asks a core for the same (CommandKind::forget_piece), to be sent to the record's
/// segment. The core refuses it while the machine is not at rest, while it has another record of this job
/// (for sequence 0: one on its disk), and while too many writes wait for its disk. Once it is done, the
/// segment has no checkpoint of that job any more, and the core soon removes the record on its disk, if it is
/// this one. Checksum 0 names no job: nothing is removed.
Command command_to_forget(const RecordName& record) noexcept;
/// The record that such a command means, in the segment that received it.
RecordName record_to_forget(const Command& command, const std::string& segment_name);

}  // namespace psicarve
