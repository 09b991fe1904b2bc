// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "hmi/machine/machine_link.hpp"
#include "shared/machine/status.hpp"
#include "shared/segment/segment_program.hpp"

namespace psicarve::cli {

/// A machine and its program, seen together.
struct ProgramSight {
    CoreStatus machine{};
    ProgramReport program{};
};

/// Whether a living process is writing a program.
bool has_living_writer(const Segment& segment);

/// Looks again, a few times, until what holds is told of the way at hand. `look_again` takes its time;
/// nothing: there is no writer that would tell.
ProgramSight told_sight(ProgramSight sight, const std::function<std::optional<ProgramSight>()>& look_again);
/// The status that wakes us wakes who tells what holds, too: gives it a moment to do so.
Result<ProgramSight> told_sight(machine::MachineLink& link);

}  // namespace psicarve::cli
