// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "hmi/profile/profile_draft.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cli {

/// The position at which the running core counts a head now [mm]; refused with the reason.
using HeadPlace = std::function<Result<double>(Axis)>;

/// Asks for the measurements one after another on standard error, reads answers from standard input; reports
/// an impossible answer and asks again. The draft then holds the measurements, and nothing is saved.
/// machine_refused: the answers ended, or the last was no.
Result<void> talk_calibration(profile::ProfileDraft& draft, const HeadPlace& place_of);

}  // namespace psicarve::cli
