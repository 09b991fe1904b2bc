// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <sys/types.h>

namespace psicarve::guard {

/// `status` is the text of /proc/PID/status.
bool says_dying(std::string_view status) noexcept;

/// Whether a process has been killed, though it may take long to be gone: on a busy computer a process with
/// much memory was seen to need 200 ms for it. Who asks may not be let at /proc/PID later, nor see it (mount
/// option hidepid), so it is opened at once. Not copied.
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
