// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hmi/session/background_queue.hpp"
#include "hmi/session/message_log.hpp"

namespace psicarve::session {

/// A difference between two files, for display.
struct DifferenceRow {
    Phrase what;
    Phrase a;
    Phrase b;

    friend bool operator==(const DifferenceRow&, const DifferenceRow&) = default;
};
struct Comparison {
    std::string path_a;
    std::string path_b;
    std::vector<DifferenceRow> rows;  ///< empty: no difference
};

/// Compares two snapshots or jobs, as `psicarve snapshot diff` does, on a thread of its own. All calls come
/// from one thread, the owner's.
class SnapshotCompare {
public:
    explicit SnapshotCompare(MessageLog& log) : log_(log) {}

    void compare(const std::string& path_a, const std::string& path_b);
    bool is_comparing() const noexcept { return is_comparing_; }
    /// Call it at screen rate.
    void poll() { queue_.deliver(); }
    /// The result of the last comparison, once.
    std::shared_ptr<const Comparison> take() noexcept { return std::move(done_); }

private:
    MessageLog& log_;
    bool is_comparing_ = false;
    std::shared_ptr<const Comparison> done_;
    BackgroundQueue queue_{BackgroundQueue::Haste::background};  // last: its thread uses the others
};

/// "layers", "profile axis.r1.speed_mm_s" ... as the command line names it.
Phrase difference_phrase(const std::string& what);

}  // namespace psicarve::session
