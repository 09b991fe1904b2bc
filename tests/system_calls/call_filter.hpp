// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace psicarve::system_calls {

/// Is told the number of every system call before it is made. In a signal handler: only what one may do.
using Watcher = void (*)(long number) noexcept;

/// From here on the kernel itself hands every system call of the calling thread (and of threads that it
/// starts) to `watcher`, whichever library or instruction makes it; then it is made as it was asked for.
/// There is no way back before the thread ends. Costs some microseconds a call. Looks at the clock that the
/// kernel answers without being called (vDSO) are none. False: this kernel lets nobody. x86-64.
bool watch_this_thread(Watcher watcher) noexcept;

}  // namespace psicarve::system_calls
