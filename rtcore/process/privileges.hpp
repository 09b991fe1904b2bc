// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::rtcore {

/// The user that a core goes on as when root starts it.
struct UserAccount {
    std::string name;
    uid_t user = 0;
    gid_t group = 0;
};

/// Refuses unknown users and root.
Result<UserAccount> account_of(const std::string& name);

/// Makes this process, which has one thread, the user's, with the user's groups and no others; it cannot go
/// back once its capabilities are dropped. Until then it keeps them, and none of them is in effect before
/// raise_privileges(). The kernel no longer lets that user's other programs look into it, nor writes a core
/// file of it (PR_SET_DUMPABLE 0): through it they would gain rights that the user has not. Refused for a
/// process that may not change its user; a process that is that user's already changes nothing.
Result<void> become_user(const UserAccount& account);
/// Puts all permitted capabilities into effect.
void raise_privileges() noexcept;
/// Whether this process is in the group, by its main group or a supplementary one.
bool is_in_group(gid_t group);
/// Whether this process will be in the group once it is that user's.
bool will_be_in_group(const UserAccount& account, gid_t group);

/// What the core still does without privileges, within limits of the process, once they are dropped.
struct StillNeeded {
    int priority = 0;  ///< threads still become SCHED_FIFO up to this; 0: none does
    bool locks_memory = false;
    std::string group;  ///< of files made later; empty: none
};

/// Drops every capability of the calling thread for good: from its effective, permitted, inheritable,
/// bounding and ambient sets, so that no program that it starts can gain any. Threads started later have none
/// either, so call it before them, and after what only privileges can do: the port, locked memory. What is
/// still needed becomes a limit of the process; where that is refused its capability stays. Returns the names
/// of those that stayed; a process without capabilities changes nothing else.
std::vector<std::string> drop_privileges(const StillNeeded& needed);

}  // namespace psicarve::rtcore
