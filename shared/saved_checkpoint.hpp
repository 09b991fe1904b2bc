// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/checkpoint.hpp"
#include "shared/profile.hpp"
#include "shared/result.hpp"
#include "shared/state_place.hpp"

namespace psicarve {

/// A checkpoint as it stands on a disk, with what somebody wants to know of it for whom segment and core are
/// gone.
struct SavedCheckpoint {
    Checkpoint checkpoint{};
    std::uint64_t job_bytes = 0;     ///< of the job's blob
    std::uint64_t profile_hash = 0;  ///< of the core's profile
    std::uint64_t sequence = 0;      ///< larger than that of any file that its core knew of
    std::int64_t written_s = 0;      ///< when, by the computer's clock, which may go back: seconds, UTC
    bool is_simulator = false;       ///< the machine was none
    std::string segment_name;        ///< of the core's, with its slash
    std::string source_name;         ///< of the job
    std::string tool;                ///< of the job: "ball, 3 mm"

    /// Of this segment's core and that kind of machine: a name alone may be another's.
    bool is_of(const std::string& segment, bool is_simulated) const {
        return segment_name == segment && is_simulator == is_simulated;
    }
    /// Begun, and not carved to its end.
    bool is_unfinished() const noexcept {
        const bool is_whole = checkpoint.next_layer == checkpoint.layer_count;
        return !is_whole && (checkpoint.next_layer != 0 || checkpoint.earlier_layer != 0);
    }
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

struct FoundCheckpoint {
    SavedCheckpoint saved;
    std::string path;
    std::string job_path;  ///< of the job's copy; empty: there is none
};

/// What a core of this segment and this kind of machine has written down last, in any of the folders: by its
/// sequence, for clocks go back. Nothing where there is none; what cannot be read, is damaged or is another
/// segment's or the other machine's is none.
std::optional<FoundCheckpoint> find_newest(const std::string& segment_name, bool is_simulator,
                                           const std::vector<std::string>& folders);

/// The unfinished piece of this segment, in `folder` or, where that is empty, wherever cores keep them
/// (state_folders_to_read): of a real machine before one of a simulated, or of one kind alone. May wait for
/// a disk that hangs.
std::optional<FoundCheckpoint> find_unfinished(const std::string& segment_name,
                                               std::optional<bool> is_simulator = {},
                                               const std::string& folder = {});

/// Takes away what is kept of it, job and all, so that it stays away (withdraw_file).
Result<void> forget_piece(const FoundCheckpoint& found);

}  // namespace psicarve
