// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/cli/run_report.hpp"
#include "hmi/verify/verifier.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"

namespace psicarve::cli {

// Adds the verification of a run's pins to its report.

/// A job that was not carved to its end is neither right nor wrong, but its pulses count.
void add_verification(RunReport& report, Result<verify::VerifyReport> verification);

/// Of a recording that was repeated: what it asked for is judged as far as it went.
void add_recorded_verification(RunReport& report, Result<verify::VerifyReport> verification);

/// Adds a failure for an output that was asked for and that only a verification gives.
void miss(RunReport& report, const std::string& what);
/// For a run whose pins must be judged: if they were not, the run has failed.
void require_verification(RunReport& report);

/// Draws the carved piece, if it was judged and a picture was asked for.
void add_picture(RunReport& report, const JobView& job, const verify::CarvedSurface& surface,
                 const std::string& picture_path);

/// Warns when the core had to leave out changes of its pins during this run.
void warn_of_lost_pins(const RunReport& report);

}  // namespace psicarve::cli
