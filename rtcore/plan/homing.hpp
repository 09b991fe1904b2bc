// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/plan/machine_limits.hpp"

namespace psicarve::plan {

/// All four axes: R1, R2, then Y, then psi. A linear axis with a sensor:
///
///     seek at home speed      ------------->|=>      slows down behind the edge (v^2/2a)
///     leave at home speed        <==========|        until it clears
///     approach, start-stop       ---------->|        stops on the edge: this is home_position
///     leave, and a little more       <======|
///
/// psi turns positive at home speed until its index begins to trip, goes back before it, and comes again at
/// start-stop speed: it rests on home_position. home = none takes the present position.
/// Of `axes` (bit by axis) alone, in the same order.
std::vector<cycle::MotionBlock> homing_blocks(const MachineLimits& limits, std::uint32_t axes = 0b1111);

/// Y alone.
std::vector<cycle::MotionBlock> reset_height_blocks(const MachineLimits& limits);

/// One axis away from its sensor until that clears; only its drive is on.
std::vector<cycle::MotionBlock> back_off_blocks(const MachineLimits& limits, Axis axis);

}  // namespace psicarve::plan
