// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "rtcore/checkpoint/checkpoint_file.hpp"
#include "rtcore/checkpoint/checkpoint_keeper.hpp"
#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/job/loaded_job.hpp"
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
    /// Makes it the current job. Returns what the operator should know of its piece; mostly empty.
    std::string take_job(SegmentHeader& header, const std::shared_ptr<const LoadedJob>& job);
    /// Call it every round. Null: there is no job.
    void note(SegmentHeader& header, const cycle::Sample& sample,
              const std::shared_ptr<const LoadedJob>& job);
    /// Forgets exactly this record, in the segment and, later, on the disk. Returns empty, or why nothing was
    /// forgotten.
    std::string forget(SegmentHeader& header, const RecordName& record);

private:
    std::string take_left(SegmentHeader& header, const std::shared_ptr<const LoadedJob>& job);

    std::uint64_t profile_hash_;
    bool is_simulator_;
    CheckpointKeeper keeper_;
    CheckpointFile file_;
};

}  // namespace psicarve::supervisor
