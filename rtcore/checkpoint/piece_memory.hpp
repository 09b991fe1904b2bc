// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rtcore/checkpoint/checkpoint_file.hpp"
#include "rtcore/checkpoint/checkpoint_keeper.hpp"
#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/job/loaded_job.hpp"
#include "shared/message/message.hpp"
#include "shared/segment/layout.hpp"

namespace psicarve::supervisor {

/// Remembers how far the piece is carved, in the segment and on a disk. Used by the supervisor's thread.
class PieceMemory {
public:
    explicit PieceMemory(const CheckpointPlace& place)
        : profile_hash_(place.profile_hash),
          is_simulator_(place.is_simulator),
          keeper_(place.is_simulator),
          file_(place) {}

    /// Call it before this core serves a segment.
    void enter(SegmentHeader& header) const;
    /// The segment was replaced: the new one holds no checkpoint yet.
    void write_anew(SegmentHeader& header) const noexcept { keeper_.write_anew(header); }
    /// It is the job at hand from here on. What is to be known of it, where there is something.
    std::vector<Message> take_job(SegmentHeader& header, const std::shared_ptr<const LoadedJob>& job);
    /// Every round. Null: there is no job.
    void note(SegmentHeader& header, const cycle::Sample& sample,
              const std::shared_ptr<const LoadedJob>& job);
    /// This record and no other: gone from the segment, and to go from the disk. None: it is done; else why
    /// it is not, and nothing was forgotten.
    Message forget(SegmentHeader& header, const RecordName& record);

private:
    std::vector<Message> take_left(SegmentHeader& header, const std::shared_ptr<const LoadedJob>& job);

    std::uint64_t profile_hash_;
    bool is_simulator_;
    CheckpointKeeper keeper_;
    CheckpointFile file_;
};

}  // namespace psicarve::supervisor
