// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <string>

#include "shared/base/result.hpp"

namespace psicarve::supervisor {

/// Makes the folder, and those above it, readable for all users, whatever the umask; a folder that exists
/// stays as it is. Where another user could replace what stands there, it changes no rights: then the umask
/// decides.
Result<void> make_state_folder(const std::string& folder);

/// Root calls it for a user who may not make the folder: only where root alone can replace it, and only
/// what this call has made is given to that user. Elsewhere it does nothing: the user makes the folder, or
/// cannot.
void make_state_folder_for(const std::string& folder, uid_t user, gid_t group);

}  // namespace psicarve::supervisor
