// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace psicarve {

/// Keeps a process alive when a shared-memory object that it has mapped is truncated. The first guard
/// installs a SIGBUS handler for the process: a fault inside a guarded range puts private zero pages over the
/// whole range and marks it as lost; any other fault goes to the handler that was there before. (Signal
/// handlers need memory of static storage: a table of eight ranges, further ones are not guarded.)
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
