// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/base/result.hpp"

namespace psicarve {

/// Takes a file away whose content must not be believed any more, so that no power cut brings it back: its
/// name is removed and its folder synced, or, where that fails, it is emptied in place and synced. Success
/// where there is none. Else "FILE: cannot be taken away: why", and whoever reads it may still find it.
Result<void> withdraw_file(const std::string& path);

}  // namespace psicarve
