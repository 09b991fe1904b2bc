// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/plan/block_list.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "shared/job/job.hpp"

namespace psicarve::plan {

/// Whole turns that the count is off, so that the way left is at most half a turn.
std::int64_t turns_to_drop(std::int64_t from_pulses, std::int64_t to_pulses, std::int64_t pulses_per_rev);

/// The machine's limits with the blank that the job was made for: what its own profile says stands there.
MachineLimits limits_for(MachineLimits limits, const JobView& job);

/// From anywhere to the point that is carved as a layer's `step`-th: heads out to the table's largest radius
/// and the clearance, psi the short way, Y, spindle up to speed, heads in at plunge speed. Whole turns of psi
/// are dropped from the count, so that this point's angle in the table is the count; the index compares
/// modulo a turn.
std::vector<cycle::MotionBlock> approach_blocks(const MachineLimits& limits, const JobView& job,
                                                const Pulses4& from_pulses, std::uint32_t layer = 0,
                                                std::uint32_t step = 0);
/// Of a dry run: likewise, but the heads stay outside and the spindle stays off.
std::vector<cycle::MotionBlock> dry_approach_blocks(const MachineLimits& limits, const JobView& job,
                                                    const Pulses4& from_pulses, std::uint32_t layer = 0,
                                                    std::uint32_t step = 0);

/// From the end of a pass to the first point of the layer that the next one begins with: heads out to where
/// they clear whatever of the blank may stand, Y, heads in at plunge speed. The spindle stays as it is.
void add_way_between_passes(BlockList& list, const MachineLimits& limits, const JobView& job,
                            const Pulses4& from_pulses, std::uint32_t layer);

/// Heads out by the retraction, as far as travel goes; spindle off.
std::vector<cycle::MotionBlock> finish_blocks(const MachineLimits& limits, const Pulses4& from_pulses);

/// Between two layers, never deeper than both neighbours ask: axes that move outwards, then Y and psi, then
/// those that move inwards. Ends in the point (layer, point).
void add_link(BlockList& list, const MachineLimits& limits, const Pulses4& from_pulses,
              const Pulses4& to_pulses, std::uint32_t layer, std::uint32_t point);

}  // namespace psicarve::plan
