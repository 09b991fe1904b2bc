// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rtcore/checkpoint/checkpoint_keeper.hpp"
#include "rtcore/job/loaded_job.hpp"
#include "rtcore/process/newest.hpp"
#include "shared/file/state_place.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"

namespace psicarve::supervisor {

/// Which checkpoint is kept, and where.
struct CheckpointPlace {
    std::string folder;  ///< made when something is first kept; empty: nothing is kept
    std::string segment_name;
    bool is_simulator = false;
    std::uint64_t profile_hash = 0;
};

/// The record on the disk when a core began.
struct LeftCheckpoint {
    std::optional<SavedCheckpoint> saved;
    bool is_unknown = false;  ///< something stands there that cannot be read, or can be read only now
};

/// A job is copied beside the checkpoint up to this size, and only if the disk has as much room again.
inline constexpr std::uint64_t kMostCopiedBytes = std::uint64_t{512} << 20;

/// What the threads of CheckpointFile share; only one thread uses each member, except those of "any thread".
/// A fault of a disk is reported on standard error, once.
class CheckpointDisk {
public:
    explicit CheckpointDisk(CheckpointPlace whose)
        : place_(std::move(whose)), names_(place_.folder, place_.segment_name, place_.is_simulator) {}

    struct KeptState {
        Checkpoint checkpoint;
        std::shared_ptr<const LoadedJob> job;
        std::int64_t written_s;
        Keeping why;
        std::uint64_t order;  ///< larger than that of all given before
    };

    // --- the thread of the checkpoint
    /// Reads what an earlier core has left of this segment and this kind of machine. Before anything is
    /// written.
    LeftCheckpoint read_left() noexcept;
    /// Does all that was given: writes what is carved, and what became of a run; removes what is to be
    /// forgotten.
    void do_given();

    // --- the thread of the jobs
    void copy_newest();

    // --- any thread
    rtcore::Newest<KeptState> carved;  ///< of each of these three, the newest alone
    rtcore::Newest<KeptState> runs;    ///< announced, or as before: never in place of what is carved
    rtcore::Newest<std::vector<RecordName>> forgets;
    std::atomic<std::uint64_t> given_order{0};        ///< order of what was given last
    std::atomic<std::uint64_t> done_order{0};         ///< all given up to this order is done
    std::atomic<std::uint64_t> standing_job{0};       ///< its checksum; 0: no record is known to be on the
                                                      ///< disk
    std::atomic<std::uint64_t> standing_sequence{0};  ///< of that record
    std::atomic<std::uint64_t> tried_sequence{0};     ///< of the newest, whether it was taken or not
    std::atomic<std::uint64_t> tried_order{0};        ///< the order of that record
    std::atomic<bool> is_asked_for{false};            ///< do_given() is about to be called
    rtcore::Newest<std::shared_ptr<const LoadedJob>> jobs;
    std::atomic<bool> is_refused{false};         ///< the disk has not taken the newest
    std::atomic<std::uint64_t> uncopied_job{0};  ///< its checksum: copying it has failed

private:
    LeftCheckpoint look();
    void write(const KeptState& state);
    void forget(const RecordName& record);
    bool tells_of(std::uint64_t job_checksum) const noexcept;
    void take_back(const KeptState& state);
    void put(const SavedCheckpoint& saved);
    void note_standing(const SavedCheckpoint& saved);
    void note_gone();
    SavedCheckpoint saved_of(const KeptState& state);
    bool may_stay(const Checkpoint& now) const noexcept;
    void mend(const SavedCheckpoint& wanted, const Error& why);
    Result<void> copy(const LoadedJob& job) const;
    void remove_other_jobs(const std::string& path) const;

    CheckpointPlace place_;
    StateNames names_;
    SavedCheckpoint facts_;  ///< of the job written last
    std::optional<SavedCheckpoint> standing_;
    /// All that a reader may find there, now or after a power cut: of those that were not written completely,
    /// the furthest of each run.
    std::vector<Checkpoint> may_stand_;
    std::optional<SavedCheckpoint> stood_;  ///< the record before what was announced
    bool is_announced_ = false;
    bool is_unread_ = false;
    std::uint64_t order_ = 0;     ///< of what is being written now
    std::uint64_t sequence_ = 0;  ///< of the newest file
    bool has_failed_ = false;
    bool has_told_unread_ = false;
    bool has_told_unforgotten_ = false;
    bool has_lied_ = false;  ///< a false record that cannot be removed was reported
};

}  // namespace psicarve::supervisor
