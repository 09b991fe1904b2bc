// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "shared/machine/status.hpp"

namespace psicarve {

/// Of a flight recorder, oldest record first: the one from which the newest job's runs are run again, the
/// first moment behind that job, and behind the last program, at which the machine was homed and at rest.
std::optional<std::size_t> replay_begin(std::span<const FlightRecord> records);

/// The rest at which the last program was started.
std::optional<std::size_t> program_replay_begin(std::span<const FlightRecord> records);

}  // namespace psicarve
