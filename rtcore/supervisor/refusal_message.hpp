// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/machine/command.hpp"
#include "shared/message/message.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::supervisor {

struct JobCounts {
    std::uint32_t layers = 0;
    std::uint32_t points = 0;  ///< in a layer
};

/// Why a command was refused; none: it was not. `of_job`: the one that the tick looked at.
Message refusal_message(const cycle::Report& answer, CommandKind command, const cycle::Sample& sample,
                        const Profile& profile, JobCounts of_job);

}  // namespace psicarve::supervisor
