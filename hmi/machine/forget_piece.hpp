// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shared/result.hpp"

namespace psicarve::machine {

/// Nobody goes on with the unfinished piece of this segment any more: what segment and disk know of it goes,
/// and stays away after a power cut. Where there is a core, it does so, and is waited for; it refuses while a
/// job runs. Without one it is done here, if the files are the user's. `folder`: where cores keep it; empty:
/// where they do by themselves. bad_input: there is none, or it cannot be taken away. May wait for a disk.
Result<void> forget_piece(const std::string& segment_name, const std::string& group,
                          const std::string& folder);

}  // namespace psicarve::machine
