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

/// One record and no other, whatever has come into its place since.
struct RecordName {
    std::string segment_name;  ///< with its slash
    bool is_simulator = false;
    std::uint64_t job_checksum = 0;
    std::uint64_t sequence = 0;  ///< 0: on no disk, in the segment alone
    bool operator==(const RecordName&) const = default;
};

/// A checkpoint as it stands on a disk, with what somebody wants to know of it for whom segment and core are
/// gone.
struct SavedCheckpoint {
    Checkpoint checkpoint{};
    std::uint64_t job_bytes = 0;     ///< of the job's blob
    std::uint64_t profile_hash = 0;  ///< of the core's profile
    std::uint64_t sequence = 0;      ///< larger than that of the record before it in its folder
    std::int64_t written_s = 0;      ///< when, by the computer's clock, which may go back: seconds, UTC
    bool is_simulator = false;       ///< the machine was none
    std::string segment_name;        ///< of the core's, with its slash
    std::string source_name;         ///< of the job
    std::string tool;                ///< of the job: "ball, 3 mm"

    /// Of this segment's core and that kind of machine: a name alone may be another's.
    bool is_of(const std::string& segment, bool is_simulated) const {
        return segment_name == segment && is_simulator == is_simulated;
    }
    RecordName name() const { return {segment_name, is_simulator, checkpoint.job_checksum, sequence}; }
    /// Begun, and not carved to its end.
    bool is_unfinished() const noexcept { return psicarve::is_unfinished(checkpoint); }
};

/// "ball, 3 mm", "point".
std::string tool_text(const ToolProfile& tool);

/// A file of one size, little-endian: magic, version, size, checksum over all of it, then the fields. Texts
/// that do not fit are cut.
std::vector<std::byte> saved_checkpoint_bytes(const SavedCheckpoint& saved);
/// Trusts nothing. "FILE: what is wrong".
Result<SavedCheckpoint> parse_saved_checkpoint(std::span<const std::byte> bytes,
                                               const std::string& file_name);
Result<SavedCheckpoint> load_saved_checkpoint(const std::string& path);
/// As write_file_atomically; everybody may read it.
Result<void> save_checkpoint(const SavedCheckpoint& saved, const std::string& path);

/// Whose it is, while a core serves the segment.
enum class Keeper : std::uint8_t {
    unknown = 0,     ///< there is no core, or it has not said where it keeps anything
    this_core = 1,   ///< it keeps it there
    other_core = 2,  ///< it keeps it elsewhere, or nothing: it takes nothing from this record
};

struct FoundCheckpoint {
    SavedCheckpoint saved;
    std::string path;
    std::string job_path;  ///< of the job's copy; empty: there is none
    Keeper keeper = Keeper::unknown;
    /// Of unfinished pieces of the same segment in other folders, whose clock said that they are older: which
    /// of them lies on the table, only who mounted it knows.
    std::vector<std::string> other_paths{};
};

/// What is kept of this segment and this kind of machine in this folder. Nothing where there is none; what
/// cannot be read, is damaged or is another segment's or the other machine's is none.
std::optional<FoundCheckpoint> find_in(const std::string& folder, const std::string& segment_name,
                                       bool is_simulator);

/// Of all of them. A core that says where it keeps it has the last word, if that folder is one of these, also
/// that there is none. Else the one that was written last, as far as clocks tell: sequences of two folders
/// say nothing of each other.
std::optional<FoundCheckpoint> find_newest(const std::string& segment_name, bool is_simulator,
                                           const std::vector<std::string>& folders,
                                           const CoreKeeping& core = {});

/// The unfinished piece of this segment, in `folder` or, where that is empty, wherever cores keep them
/// (state_folders_to_read): of a real machine before one of a simulated, or of one kind alone. `core`: of the
/// one that serves the segment (Segment::core_keeping). May wait for a disk that hangs.
std::optional<FoundCheckpoint> find_unfinished(const std::string& segment_name,
                                               std::optional<bool> is_simulator = {},
                                               const std::string& folder = {}, const CoreKeeping& core = {});

/// Takes the record at this path away, durably, if it is this one. Success where there is none;
/// machine_refused where another stands there, bad_input where it cannot be told: both are left alone.
Result<void> withdraw_record(const std::string& path, const RecordName& record);

/// Takes away exactly the record that was found, and its job's copy, so that it stays away (withdraw_file).
/// For where no core keeps it: no other record may come meanwhile, or the lock of the segment's core is held.
/// Success where it is gone already; machine_refused where another stands in its place, which is left alone.
Result<void> forget_piece(const FoundCheckpoint& found);

/// Asks a core for the same (CommandKind::forget_piece), to be sent to the record's segment. It is refused
/// while the machine is not at rest, where the core has another record of this job (for sequence 0: one on
/// its disk), and where too many wait for its disk. Done: the segment knows nothing of that job any more, and
/// what stands on the core's disk goes soon, if it is that record. Of no job (checksum 0) nothing goes.
Command command_to_forget(const RecordName& record) noexcept;
/// Whose record such a command means, in the segment that it came to.
RecordName record_to_forget(const Command& command, const std::string& segment_name);

}  // namespace psicarve
