// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shared/segment/layout.hpp"

namespace psicarve {

/// For a core that has just claimed the segment: what the core before it left behind is answered as refused
/// where its sender still waits, and freed where it does not. Commands being written stay.
void clear_commands_of_dead_core(SegmentHeader& header) noexcept;

}  // namespace psicarve
