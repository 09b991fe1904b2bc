// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "shared/computer/process_identity.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::test {

/// Before the words named_after_this_process() adds, of tests in one program and of those that run others.
inline constexpr std::string_view kTestSegmentPrefix = "psicarve-test-";
inline constexpr std::string_view kCliTestSegmentPrefix = "psicarve-cli-test-";

/// Removes what tests that were killed have left in /dev/shm. `folder` is where the system keeps shared
/// memory.
inline void remove_stale_segments(const std::filesystem::path& folder = "/dev/shm") {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator{folder, ignored}) {
        const std::string name = entry.path().filename().string();
        if (is_named_after_dead_process(name, kTestSegmentPrefix) ||
            is_named_after_dead_process(name, kCliTestSegmentPrefix))
            (void)Segment::remove("/" + name).has_value();
    }
}

/// Once in a test program, before it makes segments of its own.
inline void remove_stale_segments_once() {
    [[maybe_unused]] static const bool s_done = (remove_stale_segments(), true);
}

}  // namespace psicarve::test
