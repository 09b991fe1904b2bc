// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "rtcore/plan/program_step.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/program_status.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::supervisor {

/// Where programs of motion records come from, and who is told how they go. Either may be missing: then there
/// are no programs, or nobody is told. Both are called by the supervisor's thread alone.
struct ProgramAccess {
    /// The steps of the program that a command names, or why it cannot be run.
    /// Whoever gives them keeps the segment as long as the planner has the source.
    std::function<Result<std::shared_ptr<plan::StepSource>>(const std::shared_ptr<Segment>&,
                                                            std::uint64_t program)>
        open;
    /// Whenever the status is published.
    std::function<void(Segment&, const ProgramStatus&)> tell;
};

}  // namespace psicarve::supervisor
