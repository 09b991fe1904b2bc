// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "rtcore/side_thread.hpp"
#include "rtcore/supervisor/loaded_job.hpp"
#include "shared/checkpoint.hpp"
#include "shared/saved_checkpoint.hpp"

namespace psicarve::supervisor {

/// Whose checkpoint is kept, and where.
struct CheckpointPlace {
    std::string folder;  ///< made when something is first kept; empty: nowhere
    std::string segment_name;
    bool is_simulator = false;
    std::uint64_t profile_hash = 0;
};

/// A job is copied beside the checkpoint up to this size, and where the disk keeps as much room again.
inline constexpr std::uint64_t kMostCopiedBytes = std::uint64_t{512} << 20;

/// Keeps the checkpoint of the segment on a disk, too, with a copy of the job, for when the computer is
/// switched off. Threads of its own write; whoever gives it something never waits. A slow disk gets the
/// newest alone. What cannot be written is said once; a file that tells of more than what is carved of the
/// piece at hand is then taken away. One owner's thread.
class CheckpointFile {
public:
    /// Reads what an earlier core has left; a disk that hangs is waited for, but not for long.
    explicit CheckpointFile(CheckpointPlace place);

    /// Again and again while it is carved. The job is copied when it is another than before.
    void keep(const Checkpoint& checkpoint, const std::shared_ptr<const LoadedJob>& job);
    /// What an earlier core has left of this very job; nothing: nothing, or of another.
    std::optional<Checkpoint> left_of(const LoadedJob& job);

private:
    struct Desk;
    std::shared_ptr<Desk> desk_;  ///< with the threads, which may outlive this; null: nothing is kept
    std::uint64_t copied_job_ = 0;
    std::future<std::optional<SavedCheckpoint>> reading_;
    std::optional<SavedCheckpoint> left_;
    std::unique_ptr<rtcore::SideThread> checkpoints_;
    std::unique_ptr<rtcore::SideThread> jobs_;
};

}  // namespace psicarve::supervisor
