// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rtcore/cycle/arc_order.hpp"
#include "rtcore/cycle/motion_block.hpp"
#include "rtcore/cycle/point_by_point.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/program.hpp"

namespace psicarve::plan {

/// A move by point-by-point comparison: a line or an arc of two axes, one of which steps at a time. Steps of
/// one axis in a row are a block; all of them share one speed profile, in steps of either axis per second.
/// Where an axis turns round whose screw has backlash, a new one begins from rest.
class SteppedProgram final : public Program {
public:
    /// `seconds`: the least that it may take, by its length; 0: as fast as the machine can.
    SteppedProgram(const MachineLimits& limits, const cycle::MotionOrder& order, const Pulses4& from_pulses,
                   double seconds = 0.0);

    bool next(cycle::MotionBlock& block) override;
    /// Whether the block that next() gave is the last that moves.
    bool is_last() const noexcept { return blocks_left_ == 0 && group_ == groups_.size(); }
    /// In which an axis makes its last step, or 0. Before the first next().
    int last_direction(std::size_t axis) const noexcept { return last_[axis]; }

private:
    struct Run {
        std::size_t axis;  ///< of the plane: 0 or 1
        int direction;
        std::int64_t steps;
    };
    struct Group {
        std::uint32_t blocks;
        std::uint64_t steps;
    };

    static std::optional<Run> next_run(cycle::PointByPoint& way);
    void count_groups();
    GroupLimits line_speeds() const;
    GroupLimits arc_speeds() const;
    double end_steps() const;
    double length_pulses(bool is_arc) const;
    void keep_to(double speed_per_s);

    const MachineLimits* limits_;
    cycle::ArcInPlane plane_;
    cycle::PointByPoint way_;
    GroupLimits speeds_{};
    std::vector<Group> groups_;
    std::uint64_t steps_ = 0;
    std::array<int, kAxisCount> last_{};
    std::size_t group_ = 0;
    std::uint32_t blocks_left_ = 0;  ///< of the group at hand
    bool is_ended_ = false;
};

}  // namespace psicarve::plan
