// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::rtcore {

/// A user as whom a core that root starts goes on.
struct UserAccount {
    std::string name;
    uid_t user = 0;
    gid_t group = 0;
};

/// Refuses unknown users and root.
Result<UserAccount> account_of(const std::string& name);

/// From here on this process, which has one thread, is this user's, with the user's groups and no others, and
/// cannot go back once its capabilities are dropped; until then it keeps them, and none of them is in effect
/// before raise_privileges(). The kernel no longer lets that user's other programs look into it, nor writes a
/// core file of it (PR_SET_DUMPABLE 0): by it they would have what the user has not. Refused: whoever may not
/// do it; who is that user already changes nothing.
Result<void> become_user(const UserAccount& account);
/// All that are permitted are in effect.
void raise_privileges() noexcept;
/// Of this process, by its own group or one that it was put into.
bool is_in_group(gid_t group);
/// Whether this process will be of that group once it is that user's.
bool will_be_in_group(const UserAccount& account, gid_t group);

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
