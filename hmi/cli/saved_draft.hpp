// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cli/command_set.hpp"
#include "hmi/profile/profile_draft.hpp"
#include "shared/base/result.hpp"

namespace psicarve::cli {

/// Writes what a draft changes into its file, whose old state becomes the backup, and reports it: the exit
/// code. Nothing changed: nothing is written.
Result<int> save_draft(profile::ProfileDraft& draft, const CommonOptions& common);

}  // namespace psicarve::cli
