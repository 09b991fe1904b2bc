// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/job/loaded_job.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/checkpoint.hpp"
#include "shared/segment/layout.hpp"

namespace psicarve::supervisor {

/// Why a checkpoint is written to the disk.
enum class Keeping : std::uint8_t {
    carved,     ///< the carving has come this far
    announced,  ///< a run begins that will make the record of its job false, and has carved nothing yet
    as_before,  ///< that run carved nothing: the record before it is valid again
};
struct ToKeep {
    Checkpoint checkpoint;  ///< as_before: what the segment knows of the job; empty: nothing
    Keeping why;
};

/// Writes into the segment how far a carving has come, a layer at a time and, beside it, the point within the
/// layer that follows (reached_point.hpp), while it carves and as it ends, however it ends. A run that begins
/// with a layer's first point forgets the point in it or beyond. A run of the whole job begins anew, since
/// the layers carved before may be another piece's; how far those came stands beside it until it is passed,
/// so that a start by mistake leaves a way back. A run that begins with a later layer continues from the
/// checkpoint, if it leaves no layer out; or, with exactly the layer behind the run before, it goes back to
/// that run's piece; any other leaves the checkpoint at the first layer that is not carved. A record of the
/// other kind of machine does not count. Used by the supervisor's thread.
class CheckpointKeeper {
public:
    explicit CheckpointKeeper(bool is_simulator) noexcept : is_simulator_(is_simulator) {}

    /// Call it before the core serves: removes a record of the other kind of machine. True: there was one.
    bool clear_foreign(SegmentHeader& header) const noexcept;
    /// Returns what must go to the disk, too, when that has changed: the checkpoint just written; and, from
    /// the start of a run that begins the same job anew, the one that it will write. The disk may be slower
    /// than the run is to leave its first point, and an operator who continued from the old record would
    /// plunge into a fresh blank. `most_told`: the greatest number of layers that the disk may say are carved
    /// of this job, whatever the segment knows.
    std::optional<ToKeep> note(SegmentHeader& header, const cycle::Sample& sample, const LoadedJob* job,
                               std::uint32_t most_told) noexcept;

    /// Every round, whatever the machine does: once steps were lost no point is known to be right.
    void note_lost_steps(SegmentHeader& header, const cycle::Sample& sample) noexcept;

    /// The result of taking over a disk's record of the current job.
    struct TakenOver {
        std::optional<Checkpoint> to_keep;  ///< the disk says more than the segment: this belongs there
        Message remark{};                   ///< the two disagree; else none
    };
    /// Copies the disk's record into a segment that never had one, never into one that is damaged. Where the
    /// segment has a record of this job and the two disagree, the lower layer is taken.
    TakenOver take_over(SegmentHeader& header, const Checkpoint& left, const LoadedJob& job) const;
    /// Forgets the piece of this job, until the next run.
    void forget(SegmentHeader& header, const RecordName& record) noexcept;
    /// Whether the segment has a record of this job and that kind of machine, whatever the sequence.
    bool knows(const SegmentHeader& header, const RecordName& record) const noexcept;
    /// Another job is the current one: a new segment repeats earlier generations.
    void note_new_job() noexcept { run_generation_ = 0; }
    /// The segment was replaced by one without a checkpoint: writes the last one again.
    void write_anew(SegmentHeader& header) const noexcept;

private:
    std::optional<Checkpoint> known_of(const SegmentHeader& header, const LoadedJob& job) const noexcept;
    Checkpoint own(const LoadedJob& job, std::uint32_t next_layer,
                   std::uint32_t earlier_layer) const noexcept;
    std::optional<ToKeep> announce(SegmentHeader& header, const cycle::Sample& sample, const LoadedJob& job,
                                   std::uint32_t most_told) noexcept;
    bool is_carving_of(const cycle::Sample& sample, const LoadedJob& job) noexcept;
    /// The layer with which a run began, and which of its points, in the order of carving.
    struct RunBegin {
        std::uint64_t layer;
        std::uint64_t step;
    };
    void begin_run(const SegmentHeader& header, const RunBegin& begin, const LoadedJob& job) noexcept;
    bool is_known(const RunBegin& begin, const LoadedJob& job) const noexcept;
    void note_point(SegmentHeader& header, const cycle::Sample& sample, const LoadedJob& job,
                    std::uint32_t next_layer) noexcept;
    void write_point(SegmentHeader& header, std::uint64_t word) noexcept;

    bool is_simulator_;
    std::uint64_t run_generation_ = 0;  ///< of the run seen last, and when it was started
    std::uint64_t run_start_tick_ = 0;
    std::uint64_t begun_tick_ = 0;     ///< of the run that these are of
    std::uint32_t carved_before_ = 0;  ///< layers, without a gap
    std::uint32_t earlier_layer_ = 0;  ///< behind those of the run before, which began anew since
    bool leaves_gap_ = false;
    bool is_announced_ = false;      ///< a run that has not left its first point
    std::uint64_t written_job_ = 0;  ///< generation
    std::optional<Checkpoint> written_;
    std::uint64_t reached_points_ = 0;  ///< of the job, without a gap, since the newest begin of a layer
    bool has_lost_steps_ = false;       ///< in this run: its points are no good places
    std::optional<std::uint64_t> written_word_;  ///< of reached_point.hpp, in this run
};

}  // namespace psicarve::supervisor
