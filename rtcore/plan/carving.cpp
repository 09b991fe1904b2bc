// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/carving.hpp"

#include <utility>

#include "rtcore/plan/carve_program.hpp"
#include "rtcore/plan/lookahead_program.hpp"

namespace psicarve::plan {

std::unique_ptr<Program> carving_of(const MachineLimits& limits, std::shared_ptr<const JobView> job,
                                    LayerSpan layers) {
    if (limits.planner == psicarve::Planner::lookahead) {
        return std::make_unique<LookaheadProgram>(limits, std::move(job), layers);
    }
    return std::make_unique<CarveProgram>(limits, std::move(job), layers);
}

}  // namespace psicarve::plan
