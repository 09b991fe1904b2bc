// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace psicarve::machine {

/// A segment name that nobody else uses: for a core of this process alone.
std::string private_segment_name();

/// Removes the private segments that killed processes left behind.
void remove_stale_private_segments();

}  // namespace psicarve::machine
