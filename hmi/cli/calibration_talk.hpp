// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "hmi/profile/profile_draft.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cli {

/// Where the running core counts a head to stand now [mm]; refused with the reason.
using HeadPlace = std::function<Result<double>(Axis)>;

/// Asks one thing after another on standard error, answers come on standard input; what cannot be is told and
/// asked again. The draft then holds what was measured, and nothing is saved. machine_refused: the answers
/// ended, or the last was no.
Result<void> talk_calibration(profile::ProfileDraft& draft, const HeadPlace& place_of);

}  // namespace psicarve::cli
