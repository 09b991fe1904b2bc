// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>

#include "hmi/session/background_queue.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/session/pending_saves.hpp"
#include "shared/base/result.hpp"

namespace psicarve::session {

/// "2026-11-21T14:58:07.123Z alarm   Limit switch R2 closed: Clear switch R2", in English: for support.
std::string log_line(const Message& message);
std::string log_text(const std::deque<Message>& messages);

/// The folder for this user's program state: $XDG_STATE_HOME/psicarve, or ~/.local/state/psicarve. Empty when
/// neither is known.
std::string state_folder(const char* xdg_state_home, const char* home);

/// A file that lines are added to. When it is full it becomes FILE.1, and FILE.1 becomes FILE.2, whose old
/// content is lost.
class LogFile {
public:
    static constexpr std::uintmax_t kMostBytes = 1'000'000;
    static constexpr int kOldFiles = 2;

    explicit LogFile(std::string path, std::uintmax_t most_bytes = kMostBytes)
        : path_(std::move(path)), most_bytes_(most_bytes) {}
    /// Makes the folder when it is not there.
    Result<void> add(const std::string& lines);
    const std::string& path() const noexcept { return path_; }

private:
    std::string path_;
    std::uintmax_t most_bytes_;
};

/// Writes every new message to the log file, on a thread of its own: a slow disk delays no other work. Leaves
/// out finished messages from before the window was open: each window would write them again.
class LogKeeper {
public:
    /// With an empty folder it writes nothing.
    explicit LogKeeper(const std::string& folder, PendingSaves saves = {});
    /// Writes the rest.
    ~LogKeeper();
    /// Reports once when the file cannot be written.
    void poll(MessageLog& log);
    /// Empty: nothing is written.
    const std::string& folder() const noexcept { return folder_; }

private:
    Result<void> flush();

    std::string folder_;
    LogFile file_;
    PendingSaves saves_;
    std::mutex mutex_;
    std::string pending_;  ///< guarded by mutex_
    std::uint64_t seen_ = 0;
    bool has_complained_ = false;
    std::optional<BackgroundQueue> queue_;
};

}  // namespace psicarve::session
