// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "rtcore/cycle/motion_block.hpp"

namespace psicarve::plan {

/// A run of path segments that was planned to come along at speed begins at rest instead: its speeds are held
/// down until what every axis has left of its acceleration has caught up with them. Nothing but speeds
/// changes. The lower of two timings asks of no axis more than one of them does, since all limits are linear
/// in the speeds' squares.
void speed_up_from_rest(std::span<cycle::MotionBlock> run);

/// Likewise a run that was planned to go on at speed ends at rest instead.
void slow_down_to_rest(std::span<cycle::MotionBlock> run);

/// What a segment takes at 100 %.
double path_seconds(const cycle::PathTiming& timing);

}  // namespace psicarve::plan
