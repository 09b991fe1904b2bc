// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/cli/run_report.hpp"
#include "hmi/verify/verifier.hpp"
#include "shared/base/result.hpp"
#include "shared/job/job.hpp"

namespace psicarve::cli {

// What the pins of a run came to, into its report.

/// A job that was not carved to its end is neither right nor wrong. Its pins were counted all the same.
void add_verification(RunReport& report, Result<verify::VerifyReport> verification);

/// What was asked for and only a verification could give.
void miss(RunReport& report, const std::string& what);
/// Nobody has kept the pins of this run from being judged: where they were not, it has failed.
void require_verification(RunReport& report);

/// The carved piece, if it was judged and a picture was asked for.
void add_picture(RunReport& report, const JobView& job, const verify::CarvedSurface& surface,
                 const std::string& picture_path);

/// Says so when the core had to leave out changes of its pins during this run.
void warn_of_lost_pins(const RunReport& report);

}  // namespace psicarve::cli
