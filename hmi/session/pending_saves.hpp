// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "hmi/session/background_queue.hpp"

namespace psicarve::session {

/// A file that is being written, or waits to be.
struct SaveUnderWay {
    std::uint64_t number = 0;  ///< of the ledger's entry
    std::string path;
    /// Grows while its thread works: a disk that answers lets the thread go on.
    std::int64_t progress = 0;

    bool operator==(const SaveUnderWay&) const = default;
};

/// The saves under way, for the decision whether the program may end. Any thread; entries and tasks may live
/// longer than the ledger.
class PendingSaves {
    struct Book;

public:
    /// One save, under way until the last copy is destroyed.
    using Entry = std::shared_ptr<void>;

    PendingSaves();
    /// Makes the task a save under way from now on, until it has run or was dropped.
    BackgroundQueue::Task noted(const std::string& path, BackgroundQueue::Task task);
    /// A save that this thread makes, with others that it waits for.
    Entry begin(const std::string& path);
    /// Oldest first.
    std::vector<SaveUnderWay> under_way() const;

private:
    std::shared_ptr<Book> book_;
};

}  // namespace psicarve::session
