// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/machine/command.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::supervisor {

/// Why a command was refused and what to do, in one sentence that fits into Answer::reason. `layer_count`: of
/// the job that the tick looked at.
std::string refusal_text(const cycle::Report& answer, CommandKind command, const cycle::Sample& sample,
                         const Profile& profile, std::uint32_t layer_count);

}  // namespace psicarve::supervisor
