// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "rtcore/sim/machine.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::supervisor {

/// The blank of its configuration. Refused when that has none.
Result<void> put_blank_on_table(sim::Machine& machine, const sim::SimConfig& config);

/// What was left of the blank, as CSV; and on standard error where each tip met it first, as its head was
/// shown then. `truth` is the profile of the machine. When the tick has ended.
Result<void> write_piece(const std::string& path, const sim::Machine& machine, const Profile& truth);

}  // namespace psicarve::supervisor
