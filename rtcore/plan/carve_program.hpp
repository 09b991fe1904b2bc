// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "rtcore/plan/angle_planner.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/program.hpp"
#include "shared/job.hpp"

namespace psicarve::plan {

/// A whole table, layer after layer, from its first point (where the machine stands) to its last; links in
/// between. Makes one layer's blocks at a time.
class CarveProgram final : public Program {
public:
    CarveProgram(const MachineLimits& limits, std::shared_ptr<const JobView> job,
                 std::uint32_t first_layer = 0);

    bool next(cycle::MotionBlock& block) override;
    PlannedSoFar planned() const override { return planned_; }

private:
    void make_layer();
    void make_lines();
    void add_lines();
    Pulses4 point_at(std::uint32_t step) const;

    MachineLimits limits_;
    std::shared_ptr<const JobView> job_;
    std::uint32_t first_layer_;  ///< the machine stands at its first point
    std::uint32_t layer_;        ///< the next one to make
    Pulses4 at_pulses_{};        ///< where the blocks made so far end
    std::vector<TableLine> lines_;
    std::vector<cycle::MotionBlock> blocks_;
    std::size_t next_ = 0;
    bool is_ended_ = false;
    PlannedSoFar planned_;
};

}  // namespace psicarve::plan
