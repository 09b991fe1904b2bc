// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/plan/machine_limits.hpp"

namespace psicarve::plan {

using SpeedCaps = std::array<double, kAxisCount>;  ///< [pulses/s] by axis; 0: the axis' own limit

/// Builds what is not a table: moves, outputs, dwells.
class BlockList {
public:
    explicit BlockList(const MachineLimits& limits) : limits_(&limits) {}

    /// A straight move with a linear speed profile; nothing when it has no way to go.
    void move(const Pulses4& delta_pulses, const SpeedCaps& caps = {});
    /// One axis until its sensor does as asked, at most `way_pulses` (signed) far.
    void seek(Axis axis, cycle::Until until, std::int64_t way_pulses, double speed_pps);
    /// The block added last latches its axis' position at the sensor's edge.
    void latch(std::int64_t position_pulses);
    /// One axis, its own sensor ignored.
    void homing_move(Axis axis, std::int64_t way_pulses, double speed_pps);
    void define(Axis axis, std::int64_t position_pulses);
    void outputs(std::uint8_t enable_mask, cycle::Spindle spindle);
    void dwell(std::int64_t ticks);
    /// The end of what has been added so far is a point of the job.
    void reach(std::uint32_t layer, std::uint32_t point);
    void end();

    std::vector<cycle::MotionBlock>& blocks() { return blocks_; }

private:
    cycle::MotionBlock& add_motion(const Pulses4& delta_pulses, const SpeedCaps& caps);

    const MachineLimits* limits_;
    std::vector<cycle::MotionBlock> blocks_;
};

inline constexpr std::uint8_t kAllDrives = 0xF;

}  // namespace psicarve::plan
