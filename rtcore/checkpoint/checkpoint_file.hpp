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

#include "rtcore/checkpoint/checkpoint_desk.hpp"
#include "rtcore/checkpoint/checkpoint_keeper.hpp"
#include "rtcore/job/loaded_job.hpp"
#include "rtcore/process/side_thread.hpp"
#include "shared/file/state_place.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"

namespace psicarve::supervisor {

/// Keeps the checkpoint of the segment on a disk, too, with a copy of the job, for when the computer is
/// switched off. Threads of its own write; whoever gives it something never waits. A slow disk gets the
/// newest alone. What cannot be written is said once; a file that tells of more than what is carved of the
/// piece at hand is then taken away, or, where that fails, said to be false. One owner's thread.
class CheckpointFile {
public:
    /// Reads what an earlier core has left; a disk that hangs is waited for, but not for long.
    explicit CheckpointFile(CheckpointPlace place);

    /// Again and again while it is carved. The job is copied when it is another than before; where that
    /// fails, again after one more layer, two, four. What an earlier core has left is past once something is
    /// carved.
    void keep(const ToKeep& what, const std::shared_ptr<const LoadedJob>& job);
    /// Every round: a disk that does not answer is told of, what could not be given is given again.
    void tend();
    /// True once: a disk that did not answer in time has said what was left there.
    bool has_answered_late();
    /// Where it is, and whether it is to be believed.
    CoreKeeping keeping() const noexcept;
    /// What an earlier core has left of this very job, unless something was kept since; nothing: nothing, or
    /// of another.
    std::optional<SavedCheckpoint> left_of(const LoadedJob& job);
    /// Behind the most layers that a file on the disk may say are carved of this job, whatever the disk has
    /// done of what was wanted; 0: of none.
    std::uint32_t most_told_of(const LoadedJob& job);
    /// Whether nothing newer is known of this job than the record of this name: it is the newest that was
    /// written, or, for sequence 0, there is none of the job on the disk. Where none is kept, whichever.
    bool is_newest(const RecordName& record) const noexcept;
    /// This record, if it stands there, and the copy of its job; whoever left it. False: too many wait for a
    /// disk that does not answer; it is not forgotten.
    bool forget(const RecordName& record);

private:
    void look_at_left();
    bool is_forgotten(const RecordName& left) const noexcept;
    void try_again();
    void ask();
    void copy(const std::shared_ptr<const LoadedJob>& job);

    std::shared_ptr<CheckpointDesk> desk_;  ///< with the threads, which may outlive this; null: none is kept
    CoreKeeping place_;
    std::string folder_;
    std::uint64_t copied_job_ = 0;
    std::uint32_t layers_to_next_copy_ = 0;
    std::uint32_t copy_pause_layers_ = 1;
    std::future<LeftCheckpoint> reading_;
    bool is_late_ = false;
    std::optional<SavedCheckpoint> left_;
    std::vector<RecordName> forgotten_;  ///< before the disk has said what is there; of 0 the whole job
    bool is_left_past_ = false;
    bool is_left_unknown_ = false;                 ///< something stands there and cannot be read
    std::map<std::uint64_t, std::uint32_t> told_;  ///< most layers, by the job's checksum
    std::uint64_t given_ = 0;                      ///< order of what the desk was given last
    std::uint64_t carved_job_ = 0;                 ///< checksum of what was carved last, and its order
    std::uint64_t carved_order_ = 0;
    std::uint64_t done_seen_ = 0;
    std::optional<std::chrono::steady_clock::time_point> waiting_since_;  ///< for the disk to answer
    std::optional<CheckpointDesk::KeptState> last_carved_;                ///< nothing was given since
    std::chrono::steady_clock::time_point next_try_{};
    bool must_ask_ = false;
    bool is_silent_ = false;  ///< the disk
    bool has_said_silent_ = false;
    std::unique_ptr<rtcore::SideThread> checkpoints_;
    std::unique_ptr<rtcore::SideThread> jobs_;
};

}  // namespace psicarve::supervisor
