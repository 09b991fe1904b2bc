// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace psicarve::system_calls {

/// Is told the number of every system call before it is made. In a signal handler: only what one may do.
using Watcher = void (*)(long number) noexcept;

/// From here on the kernel itself hands every system call of the calling thread (and of threads that it
/// starts) to `watcher`, whichever library or instruction makes it; then the call is made as it was. There is
/// no way back before the thread ends. Costs some microseconds a call. Readings of the clock that need no
/// system call (vDSO) do not count. False: this kernel does not allow it. x86-64.
bool watch_this_thread(Watcher watcher) noexcept;

}  // namespace psicarve::system_calls
