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

/// Runs a carver in a thread of its own, begun with the first cut, so that the thread that reports positions
/// goes on meanwhile, until some ten thousand of them wait. The result is the same.
///
/// One thread at a time calls settle(); finish() after the last of them. No other code uses the carver and
/// its stock before finish() has returned.
class CarvingThread {
public:
    /// The carver outlives this.
    explicit CarvingThread(PieceCarver& carver) : carver_(carver) {}
    /// Drops the positions that wait.
    ~CarvingThread();
    CarvingThread(const CarvingThread&) = delete;
    CarvingThread& operator=(const CarvingThread&) = delete;

    /// As PieceCarver's. Waits while too many positions wait.
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
    Batch told_;  ///< used by the reporting thread alone
    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<Batch> waiting_;  ///< under the mutex, as the next two
    bool is_told_all_ = false;
    bool is_dropped_ = false;
    std::thread thread_;
};

}  // namespace psicarve::piece
