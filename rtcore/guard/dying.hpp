// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <sys/types.h>

namespace psicarve::guard {

/// Whether the text of /proc/PID/status shows a process that is dying.
bool says_dying(std::string_view status) noexcept;

/// Whether a process has been killed, though it may take long to be gone: on a busy computer a process with
/// much memory was seen to need 200 ms for it. The file in /proc/PID is opened at once, because the watching
/// process may lose the right to it, or not see it later (mount option hidepid). Not copied.
class DyingWatch {
public:
    explicit DyingWatch(pid_t pid) noexcept;
    ~DyingWatch();
    DyingWatch(const DyingWatch&) = delete;
    DyingWatch& operator=(const DyingWatch&) = delete;
    /// False where the kernel does not say.
    bool is_dying() const noexcept;

private:
    int status_;
};

}  // namespace psicarve::guard
