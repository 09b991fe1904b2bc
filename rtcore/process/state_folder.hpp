// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <string>

#include "shared/base/result.hpp"

namespace psicarve::supervisor {

/// Makes the folder, and those above it, for everybody to look into, whatever the umask; one that is there
/// stays as it is. Where another user could put something else into its place nothing is changed of what
/// stands there: then the umask has its way.
Result<void> make_state_folder(const std::string& folder);

/// By root, for a user who may not: only where nobody but root can put something else into its place, and
/// only what this call has made becomes that user's. Elsewhere nothing: the user makes it, or cannot.
void make_state_folder_for(const std::string& folder, uid_t user, gid_t group);

}  // namespace psicarve::supervisor
