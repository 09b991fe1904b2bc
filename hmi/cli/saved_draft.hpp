// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/cli/command_set.hpp"
#include "hmi/profile/profile_draft.hpp"
#include "shared/base/result.hpp"

namespace psicarve::cli {

/// Writes a draft's changes into its file, whose old state becomes the backup, and reports it: returns the
/// exit code. Writes nothing when nothing changed.
Result<int> save_draft(profile::ProfileDraft& draft, const CommonOptions& common);

}  // namespace psicarve::cli
