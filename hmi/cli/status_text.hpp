// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/machine/status.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {

/// "ready", or "in alarm (limit of r1)".
std::string state_text(const CoreStatus& status);

/// A block of lines for a person; positions in mm and degrees too when the machine's profile is known.
/// `pass`: the current one of a job that has several.
std::string status_text(const CoreStatus& status, const Profile* profile, const std::string& pass = {});

/// One line that changes only when something of interest to a person does.
std::string status_line(const CoreStatus& status, const std::string& pass = {});

}  // namespace psicarve::cli
