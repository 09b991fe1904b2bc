// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rtcore/checkpoint/checkpoint_disk.hpp"
#include "rtcore/checkpoint/checkpoint_keeper.hpp"
#include "rtcore/job/loaded_job.hpp"
#include "rtcore/process/side_thread.hpp"
#include "shared/file/state_place.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"

namespace psicarve::supervisor {

/// Keeps the checkpoint of the segment on a disk, too, with a copy of the job, for when the computer is
/// switched off. Threads of its own write; the caller never waits. A slow disk gets only the newest. A failed
/// write is reported once; a file that claims more than is carved of the present piece is then removed, or,
/// where that fails, reported as false. Used by one thread. Its members: the disk with its two threads, what
/// the disk is known to hold, and what is on its way there: all of it decides what is written next.
class CheckpointFile {
public:
    /// Reads what an earlier core has left; waits for a disk that hangs, but not for long.
    explicit CheckpointFile(CheckpointPlace place);

    /// Call it repeatedly while the job is carved. Copies the job when it is another than before; where that
    /// fails, tries again after one more layer, two, four. Once something is carved, what an earlier core has
    /// left no longer counts.
    void keep(const ToKeep& what, const std::shared_ptr<const LoadedJob>& job);
    /// Call it every round: reports a disk that does not answer, and gives again what could not be given.
    void tend();
    /// True once, after a disk that did not answer in time has said what was left there.
    bool has_answered_late();
    /// Where the checkpoint is kept, and whether the disk has taken it.
    CoreKeeping keeping() const noexcept;
    /// What an earlier core has left of this very job. Nothing: there is none, it is another job's, or
    /// something was kept since.
    std::optional<SavedCheckpoint> left_of(const LoadedJob& job);
    /// The greatest number of layers that a file on the disk may say are carved of this job, whatever the
    /// disk has done of what was given; 0: none.
    std::uint32_t most_told_of(const LoadedJob& job);
    /// Whether nothing newer is known of this job than this record: it is the newest that was written, or,
    /// for sequence 0, the disk has none of the job. Always true where nothing is kept.
    bool is_newest(const RecordName& record) const noexcept;
    /// Removes this record, if it is on the disk, and the copy of its job, whichever core left it. False: too
    /// many wait for a disk that does not answer, and this one is not forgotten.
    bool forget(const RecordName& record);

private:
    void look_at_left();
    bool is_forgotten(const RecordName& left) const noexcept;
    void try_again();
    void ask();
    void copy(const std::shared_ptr<const LoadedJob>& job);

    std::shared_ptr<CheckpointDisk> disk_;  ///< shared with the threads, which may outlive this; null:
                                            ///< nothing is kept
    CoreKeeping place_;
    std::string folder_;
    std::uint64_t copied_job_ = 0;
    std::uint32_t layers_to_next_copy_ = 0;
    std::uint32_t copy_pause_layers_ = 1;
    std::future<LeftCheckpoint> reading_;
    bool is_late_ = false;
    std::optional<SavedCheckpoint> left_;
    std::vector<RecordName> forgotten_;  ///< before the disk has said what is there; sequence 0: the whole
                                         ///< job
    bool is_left_past_ = false;
    bool is_left_unknown_ = false;                 ///< something stands there that cannot be read
    std::map<std::uint64_t, std::uint32_t> told_;  ///< most layers, by the job's checksum
    std::uint64_t given_ = 0;                      ///< order of what the disk was given last
    std::uint64_t carved_job_ = 0;                 ///< checksum of what was carved last, and its order
    std::uint64_t carved_order_ = 0;
    std::uint64_t done_seen_ = 0;
    std::optional<std::chrono::steady_clock::time_point> waiting_since_;  ///< waiting for the disk to answer
                                                                          ///< since then
    std::optional<CheckpointDisk::KeptState> last_carved_;                ///< if nothing was given since
    std::chrono::steady_clock::time_point next_try_{};
    bool must_ask_ = false;
    bool is_silent_ = false;  ///< the disk does not answer
    bool has_said_silent_ = false;
    std::unique_ptr<rtcore::SideThread> checkpoints_;
    std::unique_ptr<rtcore::SideThread> jobs_;
};

}  // namespace psicarve::supervisor
