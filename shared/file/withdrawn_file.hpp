// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/base/result.hpp"

namespace psicarve {

/// Removes a file whose content is no longer valid, so that no power cut brings it back: unlinks it and syncs
/// its folder, or, where that fails, empties it in place and syncs it. Success where there is none. Else
/// "FILE: cannot be taken away: why", and a reader may still find it.
Result<void> withdraw_file(const std::string& path);

}  // namespace psicarve
