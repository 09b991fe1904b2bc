// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "hmi/session/work_lane.hpp"

namespace psicarve::session {

/// A file that is being written, or waits for it.
struct SaveUnderWay {
    std::uint64_t number = 0;  ///< of the ledger's entry
    std::string path;
    /// Grows while somebody works on it: a disk that answers leaves its thread something to do.
    std::int64_t progress = 0;

    bool operator==(const SaveUnderWay&) const = default;
};

/// What is being written, for whoever wants to know before the program ends. Any thread; entries and tasks
/// may live longer than the ledger.
class SaveLedger {
    struct Book;

public:
    /// One save, under way until the last copy is gone.
    using Entry = std::shared_ptr<void>;

    SaveLedger();
    /// Under way from now on, until the task has run or was dropped.
    WorkLane::Task noted(const std::string& path, WorkLane::Task task);
    /// By this thread and others that it waits for.
    Entry begin(const std::string& path);
    /// Oldest first.
    std::vector<SaveUnderWay> under_way() const;

private:
    std::shared_ptr<Book> book_;
};

}  // namespace psicarve::session
