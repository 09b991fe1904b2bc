// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "rtcore/plan/angle_planner.hpp"
#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/table_program.hpp"
#include "shared/job/job.hpp"

namespace psicarve::plan {

/// A whole table by the angle rule, with links between its layers.
class CarveProgram final : public TableProgram {
public:
    CarveProgram(const MachineLimits& limits, std::shared_ptr<const JobView> job, LayerSpan layers = {});

private:
    void make_layers() override;
    void add_link_to_layer();
    void make_lines();
    void add_lines();

    Pulses4 at_pulses_;  ///< where the blocks made so far end
    std::vector<TableLine> lines_;
};

}  // namespace psicarve::plan
