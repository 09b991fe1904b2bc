// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::supervisor {

/// The core's own profile: the built-in one for an empty path, else a TOML file, or the profile in a job or
/// snapshot file.
Result<Profile> load_core_profile(const std::string& path);

}  // namespace psicarve::supervisor
