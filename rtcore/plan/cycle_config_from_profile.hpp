// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rtcore/cycle/cycle_config.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::plan {

/// The tick's view of a profile that parse_profile accepted.
cycle::CycleConfig cycle_config_from_profile(const Profile& profile);

}  // namespace psicarve::plan
