// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "hmi/piece/stock_map.hpp"

namespace psicarve::piece {

/// Passes the piece from the thread that carves it to a thread that shows it: copies, so that neither waits
/// for the other's work, and always of a complete state that the carver has published. Each holds the lock
/// only while it copies the rows that have changed.
class PieceFront {
public:
    explicit PieceFront(const StockMap& blank);

    /// Called by the carving thread. Requires a map of the same cells.
    void publish(const StockMap& stock);
    /// Grows with each published state that differs from the one before.
    std::uint64_t edition() const noexcept { return edition_.load(); }

    // Called by the thread that shows it:

    /// Brings shown() up to the last published state. Returns the changed rows, from the lowest on.
    std::vector<std::size_t> take_changed_rows();
    const StockMap& shown() const noexcept { return shown_; }

private:
    StockMap shown_;
    std::mutex mutex_;
    StockMap front_;                     ///< under the mutex, as the next member
    std::vector<std::uint8_t> differs_;  ///< by row: from shown_
    std::atomic<std::uint64_t> edition_{0};
};

}  // namespace psicarve::piece
