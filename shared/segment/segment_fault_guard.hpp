// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace psicarve {

/// Keeps a process alive when somebody truncates a shared-memory object that it has mapped. The first guard
/// installs a SIGBUS handler for the process: a fault inside a guarded range puts private zero pages over the
/// whole range and notes that it is lost; any other fault goes to whoever handled SIGBUS before.
/// (Signal handlers need memory of static storage: a table of eight ranges, more are simply not guarded.)
class SegmentFaultGuard {
public:
    SegmentFaultGuard(void* begin, std::size_t bytes) noexcept;
    ~SegmentFaultGuard();
    SegmentFaultGuard(const SegmentFaultGuard&) = delete;
    SegmentFaultGuard& operator=(const SegmentFaultGuard&) = delete;

    /// The range no longer shows the shared object.
    bool is_lost() const noexcept;

private:
    int entry_ = -1;
};

}  // namespace psicarve
