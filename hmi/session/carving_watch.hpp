// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "hmi/scene/carving_record.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/layers_in_doubt.hpp"
#include "hmi/session/live_piece.hpp"
#include "hmi/session/machine_session.hpp"
#include "hmi/session/open_job.hpp"

namespace psicarve::session {

/// Records what the machine carves, visible or not: the core's job since its last start. Used by one thread,
/// the window's, which never waits for it.
class CarvingWatch {
public:
    CarvingWatch(MachineSession& machine, OpenJob& desk) : machine_(machine), desk_(desk) {}

    /// Call it with each look at the machine.
    void refresh();

    /// Null while a fresh blank is made.
    CarvingRecord* record() const noexcept { return record_.get(); }
    /// Exists with the record, if the job's tool has a size.
    LivePiece* piece() const noexcept { return piece_.get(); }
    /// Of the job on the table.
    const LayersInDoubt& doubt() const noexcept { return doubt_; }
    bool has_job() const noexcept { return job_ != nullptr; }
    /// Grows with each fresh blank.
    std::uint64_t edition() const noexcept { return edition_; }

private:
    void make_blank();
    void take_increments(const CoreStatus& status);
    void take_doubt(const CoreStatus& status);
    /// Of the job, from its first on.
    std::uint32_t layers_carved(const CoreStatus& status) const noexcept;

    MachineSession& machine_;
    OpenJob& desk_;
    std::shared_ptr<const cam::PreparedJob> job_;
    std::unique_ptr<CarvingRecord> record_;
    std::unique_ptr<LivePiece> piece_;
    LayersInDoubt doubt_;
    bool is_doubt_told_ = false;       ///< the record has it
    std::uint32_t layers_carved_ = 0;  ///< at the last look
    std::uint64_t blank_number_ = 0;   ///< of the blank that is being made
    std::uint64_t edition_ = 0;
    std::uint64_t job_start_tick_ = 0;
    std::uint64_t lost_ = 0;  ///< increments, at the last read
    bool ran_job_ = false;    ///< at the last read
    BackgroundQueue queue_;
};

}  // namespace psicarve::session
