// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cli/command_set.hpp"
#include "hmi/machine/machine_link.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {

// What a machine must be for a program in G-code.

/// The core's numbers are pulses, and its limits are its own.
Result<Profile> profile_of_core(const machine::MachineLink& link, const CommonOptions& common);
Result<void> require_ready(const CoreStatus& status);
/// Where one letter moves both heads they must begin alike: the first move would drive R2 where nobody sent
/// it.
Result<void> require_heads_alike(const Profile& profile, const CoreStatus& status);

}  // namespace psicarve::cli
