// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace psicarve::machine {

/// A unique segment name: for a core of this process alone.
std::string private_segment_name();

/// Removes the private segments that killed processes left behind.
void remove_stale_private_segments();

}  // namespace psicarve::machine
