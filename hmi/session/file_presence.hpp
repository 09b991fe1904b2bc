// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "hmi/session/background_queue.hpp"

namespace psicarve::session {

/// Finds out which of the files that a window offers exist, on a thread of its own: a disk that sleeps, or a
/// server that does not answer, must not stop the window. All calls come from one thread, the owner's.
class FilePresence {
public:
    enum class State : std::uint8_t { unknown, there, gone };
    struct Seen {
        State state = State::unknown;
        std::filesystem::file_time_type written{};  ///< of a file that exists
    };

    /// Looks for these files, again for known ones; the last result holds meanwhile.
    void look(std::vector<std::string> paths);
    /// Looks for a folder and all above it.
    void look_above(const std::string& folder);
    /// The folder, or the nearest above it that is known to exist; empty: none is known.
    std::string nearest_folder(const std::string& folder) const;
    /// Call it at screen rate.
    void poll() { queue_.deliver(); }
    Seen seen(const std::string& path) const;

private:
    std::map<std::string, Seen> seen_;
    BackgroundQueue queue_;  // last: its thread uses the others
};

}  // namespace psicarve::session
