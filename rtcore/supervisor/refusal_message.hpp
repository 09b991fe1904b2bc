// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/machine/command.hpp"
#include "shared/message/message.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::supervisor {

/// Why a command was refused; none: it was not. `layer_count`: of the job that the tick looked at.
Message refusal_message(const cycle::Report& answer, CommandKind command, const cycle::Sample& sample,
                        const Profile& profile, std::uint32_t layer_count);

}  // namespace psicarve::supervisor
