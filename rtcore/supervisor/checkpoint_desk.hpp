// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "rtcore/newest.hpp"
#include "rtcore/supervisor/loaded_job.hpp"
#include "shared/checkpoint.hpp"
#include "shared/saved_checkpoint.hpp"
#include "shared/state_place.hpp"

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

/// What the threads of CheckpointFile share; each member is one's alone, but for those that wait. Whatever it
/// says of a disk it says on standard error, once.
class CheckpointDesk {
public:
    explicit CheckpointDesk(CheckpointPlace whose)
        : place_(std::move(whose)), names_(place_.folder, place_.segment_name, place_.is_simulator) {}

    struct KeptState {
        Checkpoint checkpoint;
        std::shared_ptr<const LoadedJob> job;  ///< null: all that is kept is to be forgotten
        std::int64_t written_s;
    };

    // --- the thread of the checkpoint
    /// What an earlier core has left, of this segment and this kind of machine. Before anything is written.
    std::optional<SavedCheckpoint> read_left();
    void write_newest();
    void forget(const RecordName& record);

    // --- the thread of the jobs
    void copy_newest();

    rtcore::Newest<KeptState> states;
    rtcore::Newest<std::shared_ptr<const LoadedJob>> jobs;

private:
    const SavedCheckpoint& facts_of(const KeptState& state);
    bool may_stay(const Checkpoint& now) const noexcept;
    void mend(const KeptState& state, const Error& why);
    Result<void> copy(const LoadedJob& job) const;
    void remove_other_jobs(const std::string& path) const;

    CheckpointPlace place_;
    StateNames names_;
    SavedCheckpoint facts_;  ///< of the job, and of the state written last
    std::optional<Checkpoint> written_;
    std::uint64_t facts_generation_ = 0;
    std::uint64_t sequence_ = 0;  ///< of the newest file
    bool has_failed_ = false;
    bool has_lied_ = false;  ///< what cannot be taken away was told of
};

}  // namespace psicarve::supervisor
