// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

#include "hmi/piece/piece_carver.hpp"
#include "hmi/surface/job_geometry.hpp"

namespace psicarve::piece {

/// A thread of its own for a carver, begun when there is something to carve, so that whoever tells the
/// positions goes on meanwhile, until some ten thousand of them wait. What is carved is the same.
///
/// settle() is called by one thread at a time; finish() after the last of them. Nobody else uses the carver
/// and its stock before finish() has returned.
class CarvingThread {
public:
    /// The carver outlives this.
    explicit CarvingThread(PieceCarver& carver) : carver_(carver) {}
    /// Leaves out what waits.
    ~CarvingThread();
    CarvingThread(const CarvingThread&) = delete;
    CarvingThread& operator=(const CarvingThread&) = delete;

    /// As PieceCarver's. Waits while too much waits.
    void settle(const verify::Positions& positions, bool spindle_on);
    /// Waits until all is carved, and ends the thread. Once.
    void finish();

private:
    struct Instant {
        verify::Positions positions;
        bool spindle_on;
    };
    using Batch = std::vector<Instant>;

    void hand_over();
    void carve();

    PieceCarver& carver_;
    Batch told_;  ///< of the telling thread alone
    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Batch> waiting_;  ///< under the mutex, as both below
    bool is_told_all_ = false;
    bool is_dropped_ = false;
    std::thread thread_;
};

}  // namespace psicarve::piece
