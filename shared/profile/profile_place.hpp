// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace psicarve {

/// Where a program looks for the machine's profile when none is named, in this order: psicarve/machine.toml
/// in $XDG_CONFIG_HOME (~/.config), then /etc/psicarve/machine.toml. $PSICARVE_PROFILE names one place
/// instead of both; set but empty, there is none.
std::vector<std::string> profile_places();

/// The first of them where something stands, also where that cannot be read or the system does not say: a
/// profile that exists is never passed over. Empty: the built-in profile applies.
std::string default_profile_path();

}  // namespace psicarve
