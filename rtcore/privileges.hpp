// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace psicarve::rtcore {

/// What goes on without privileges, by limits instead, once they are dropped.
struct StillNeeded {
    int priority = 0;  ///< threads still become SCHED_FIFO up to this; 0: none does
    bool locks_memory = false;
    std::string group;  ///< of files made later; empty: none
};

/// Every capability of the calling thread goes, for good: of its effective, permitted, inheritable, bounding
/// and ambient sets, and no program that it starts can gain any. Threads started from here on have none
/// either, so it is called before them, and after what only privileges can do: the port, locked memory. What
/// is still needed becomes a limit of the process; where that is refused its capability stays. Returns the
/// names of those that stayed; a process without capabilities changes nothing else.
std::vector<std::string> drop_privileges(const StillNeeded& needed);

}  // namespace psicarve::rtcore
