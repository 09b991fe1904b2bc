// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>

namespace psicarve::rtcore {

/// What the kernel counts for a thread.
struct ThreadCounts {
    std::uint64_t minor_faults = 0;  ///< a page was not mapped, but in memory
    std::uint64_t major_faults = 0;  ///< a page came from the disk
    std::uint64_t sleeps = 0;        ///< context switches of its own accord
    std::uint64_t preemptions = 0;   ///< context switches that others forced on it

    friend bool operator==(const ThreadCounts&, const ThreadCounts&) = default;
    ThreadCounts since(const ThreadCounts& before) const noexcept;
};

/// Reads the counts of a thread of this process from /proc, in any other thread: the thread itself makes no
/// system call for it. Nothing when there is no such thread. `root` stands before /proc.
std::optional<ThreadCounts> counts_of_thread(pid_t thread, const std::string& root = {});

}  // namespace psicarve::rtcore
