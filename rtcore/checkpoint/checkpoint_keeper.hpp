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

/// What a checkpoint that goes to the disk is there for.
enum class Keeping : std::uint8_t {
    carved,     ///< so far it is carved
    announced,  ///< a run begins that will make the record of its job false, and has carved nothing yet
    as_before,  ///< it came to nothing: what stood there stands again
};
struct ToKeep {
    Checkpoint checkpoint;  ///< as_before: what the segment knows of the job; empty: nothing
    Keeping why;
};

/// Writes into the segment how far a carving has come, a layer at a time, while it carves and as it ends in
/// whatever way. A run of the whole job begins anew: what was carved before it may be another piece's. How
/// far that was stands beside it until it is passed, so that a start by mistake leaves a way back. One that
/// begins with a later layer goes on from where the checkpoint stands, if it leaves no layer out, or, with
/// exactly the layer behind the run before, goes back to that one's piece; any other leaves the checkpoint at
/// the first layer that is not carved. A record of the other kind of machine is none. The supervisor's
/// thread.
class CheckpointKeeper {
public:
    explicit CheckpointKeeper(bool is_simulator) noexcept : is_simulator_(is_simulator) {}

    /// Before anything is served: a record of the other kind of machine goes. True: there was one.
    bool clear_foreign(SegmentHeader& header) const noexcept;
    /// What is to be kept on a disk, too, where that has changed: what was written; and of a run that begins
    /// the same job anew what will be, from its start on. A disk is slower than the first point is left, and
    /// whoever goes on by what it said before would plunge into a fresh blank. `most_told`: behind the most
    /// layers that the disk may say are carved of this job, whatever the segment knows.
    std::optional<ToKeep> note(SegmentHeader& header, const cycle::Sample& sample, const LoadedJob* job,
                               std::uint32_t most_told) noexcept;

    /// What came of what a disk has of the job at hand.
    struct TakenOver {
        std::optional<Checkpoint> to_keep;  ///< the disk says more than the segment: this belongs there
        Message remark{};                   ///< the two disagree; else none
    };
    /// Into a segment that never had a record, never into one that is damaged. Where the segment knows of
    /// this job itself and the two disagree, it is the lower layer.
    TakenOver take_over(SegmentHeader& header, const Checkpoint& left, const LoadedJob& job) const;
    /// Nothing is known of a piece of this job from here on, until the next run.
    void forget(SegmentHeader& header, const RecordName& record) noexcept;
    /// Whether the segment knows of this job and that kind of machine, whatever the sequence.
    bool knows(const SegmentHeader& header, const RecordName& record) const noexcept;
    /// Another job is at hand: a new segment gives generations that were given before.
    void note_new_job() noexcept { run_generation_ = 0; }
    /// The segment was replaced: the new one holds no checkpoint yet.
    void write_anew(SegmentHeader& header) const noexcept;

private:
    std::optional<Checkpoint> known_of(const SegmentHeader& header, const LoadedJob& job) const noexcept;
    Checkpoint own(const LoadedJob& job, std::uint32_t next_layer,
                   std::uint32_t earlier_layer) const noexcept;
    std::optional<ToKeep> announce(const SegmentHeader& header, const cycle::Sample& sample,
                                   const LoadedJob& job, std::uint32_t most_told) noexcept;
    bool is_carving_of(const cycle::Sample& sample, const LoadedJob& job) noexcept;
    void begin_run(const SegmentHeader& header, std::uint64_t first_layer, const LoadedJob& job) noexcept;

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
};

}  // namespace psicarve::supervisor
