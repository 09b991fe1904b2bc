// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace psicarve {

/// Where the machine's profile is looked for when none is named, first to last: psicarve/machine.toml in
/// $XDG_CONFIG_HOME (~/.config), then /etc/psicarve/machine.toml. $PSICARVE_PROFILE names the one place
/// instead; set but empty, there is none.
std::vector<std::string> profile_places();

/// The first of them where something stands, readable or not, or where that cannot be told: what is there is
/// never passed over. Empty: the built-in profile applies.
std::string default_profile_path();

}  // namespace psicarve
