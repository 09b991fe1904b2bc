// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/plan/machine_limits.hpp"

namespace psicarve::plan {

/// A jog or a move: all axes of the order to their targets, in a straight line from rest to rest, as fast as
/// each can; a jog no faster than its speed. psi goes the short way to where a move sends it. Outputs stay
/// as they are.
std::vector<cycle::MotionBlock> move_blocks(const MachineLimits& limits, const cycle::MotionOrder& order,
                                            const Pulses4& from_pulses);

}  // namespace psicarve::plan
