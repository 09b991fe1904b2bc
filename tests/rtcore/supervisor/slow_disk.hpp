// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace psicarve::supervisor::test {

/// While this lives the disk answers no other thread of this program: whoever looks what an open file is, or
/// syncs it, waits. One at a time.
class SlowDisk {
public:
    SlowDisk() noexcept;
    ~SlowDisk();
    SlowDisk(const SlowDisk&) = delete;
    SlowDisk& operator=(const SlowDisk&) = delete;

    /// Until somebody waits for it.
    void wait_for_somebody() const noexcept;
};

}  // namespace psicarve::supervisor::test
