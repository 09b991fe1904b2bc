// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hmi/machine/loose_work.hpp"
#include "hmi/session/message_log.hpp"

namespace psicarve::session {

/// What happened to the machine before the window was opened, over the restarts of cores and windows, by the
/// cores' own journals. Read once, on a thread of its own: a disk may hang. One owner's thread.
class JournalHistory {
public:
    static constexpr std::size_t kMost = 5000;

    /// Begins to read. `folder`: where cores keep journals; empty: their default folders.
    JournalHistory(const std::string& segment, const std::string& folder,
                   std::chrono::system_clock::time_point opened = std::chrono::system_clock::now(),
                   std::size_t most = kMost);

    /// Takes what was read, and tells once what could not be. Never waits.
    void poll(MessageLog& log);
    /// The newest, oldest first; they stay as they are once they are there. None while they are read.
    const std::vector<Message>& messages() const noexcept { return messages_; }
    bool is_read() const noexcept { return is_read_; }

private:
    struct Outcome {
        std::vector<Message> messages;
        std::string problem;  ///< of the first file that cannot be read; else empty
        std::uint64_t damaged_count = 0;
    };
    static Outcome read(const std::string& segment, const std::string& folder, std::int64_t opened_ms,
                        std::size_t most);

    machine::LooseWork<Outcome> work_;
    std::vector<Message> messages_;
    bool is_read_ = false;
};

}  // namespace psicarve::session
