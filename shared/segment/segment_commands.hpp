// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shared/segment/layout.hpp"

namespace psicarve {

/// A core that has just claimed the segment calls this: it refuses the commands that the core before it left
/// where the sender still waits, and frees the others. Commands being written stay.
void clear_commands_of_dead_core(SegmentHeader& header) noexcept;

}  // namespace psicarve
