// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "shared/segment.hpp"

namespace psicarve::test {

/// Removes what tests that were killed have left in /dev/shm: their segments carry the number of a process
/// that is no more. `folder` is where the system keeps shared memory.
inline void remove_stale_segments(const std::filesystem::path& folder = "/dev/shm") {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator{folder, ignored}) {
        const std::string name = entry.path().filename().string();
        for (const std::string_view prefix : {"psicarve-test-", "psicarve-cli-test-"}) {
            if (!name.starts_with(prefix)) continue;
            const long pid = std::strtol(name.c_str() + prefix.size(), nullptr, 10);
            const bool is_gone = pid > 0 && ::kill(static_cast<pid_t>(pid), 0) != 0 && errno == ESRCH;
            if (is_gone) (void)Segment::remove("/" + name).has_value();
        }
    }
}

/// Once in a test program, before it makes segments of its own.
inline void remove_stale_segments_once() {
    [[maybe_unused]] static const bool s_done = (remove_stale_segments(), true);
}

}  // namespace psicarve::test
