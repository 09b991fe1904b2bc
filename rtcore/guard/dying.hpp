// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <sys/types.h>

namespace psicarve::guard {

/// Whether a process has been killed, though it may take long to be gone: on a busy computer a process with
/// much memory was seen to need 200 ms for it. `status` is the text of /proc/PID/status.
bool says_dying(std::string_view status) noexcept;
bool is_dying(pid_t pid) noexcept;

}  // namespace psicarve::guard
