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

/// Where programs of motion records come from, and who is told how they go. Each may be missing: then there
/// are no programs, or nothing is told. All are called by the supervisor's thread alone.
struct ProgramAccess {
    /// The steps of the program that a command names, or why it cannot be run.
    std::function<Result<std::shared_ptr<plan::StepSource>>(std::uint64_t program)> open;
    /// What became of that command. Where it is done, `serve` has been told by then of a program that runs.
    std::function<void(std::uint64_t program, bool is_done)> note_answer;
    /// Whenever the status is published, into this segment.
    std::function<void(const std::shared_ptr<Segment>& segment, const ProgramStatus& status)> serve;
};

}  // namespace psicarve::supervisor
