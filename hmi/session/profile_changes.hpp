// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hmi/profile/profile_draft.hpp"
#include "hmi/session/snapshot_compare.hpp"

namespace psicarve::session {

/// The changes that saving would make in the draft's file: each key with the value there and the new one,
/// with its unit, in the order of the keys. Words and texts stand in quotes, as in the file.
std::vector<DifferenceRow> profile_changes(const profile::ProfileDraft& draft);

}  // namespace psicarve::session
