// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "hmi/piece/stock_map.hpp"

namespace psicarve::piece {

/// What one thread carves, for another one to look at: copies, so that the one never waits for the other's
/// work, and always of a whole state that the carver has published. Neither holds the lock for longer than
/// copying the rows that have changed takes.
class PieceFront {
public:
    explicit PieceFront(const StockMap& blank);

    /// The carving thread's. Requires a map of the same cells.
    void publish(const StockMap& stock);
    /// Grows with each published state that is another than the one before.
    std::uint64_t edition() const noexcept { return edition_.load(); }

    // The looking thread's:

    /// Brings shown() up to what was published last. Rows that are others now, from the lowest on.
    std::vector<std::size_t> take_changed_rows();
    const StockMap& shown() const noexcept { return shown_; }

private:
    StockMap shown_;
    std::mutex mutex_;
    StockMap front_;                     ///< under the mutex, as below
    std::vector<std::uint8_t> differs_;  ///< by row: from shown_
    std::atomic<std::uint64_t> edition_{0};
};

}  // namespace psicarve::piece
