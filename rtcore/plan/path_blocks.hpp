// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/path_pieces.hpp"

namespace psicarve::plan {

/// A timed piece as the tick gets it: a block of a run, which `group_blocks` of the first one makes.
cycle::MotionBlock path_block(const MachineLimits& limits, const PathPiece& piece);

/// Notes in the run's first block which way axes with backlash go in it. A run has a stop wherever such an
/// axis turns round: in it each goes one way.
void note_gaps(const MachineLimits& limits, std::span<cycle::MotionBlock> run);

/// Marks the rapid ways of a run from which a brake may end in a way in the material (WayKind::to_feed). Such
/// a one follows the run without a rest, if `feed_follows`.
void note_feed_ahead(std::span<cycle::MotionBlock> run, bool feed_follows);

}  // namespace psicarve::plan
