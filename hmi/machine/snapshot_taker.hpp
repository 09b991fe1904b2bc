// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "hmi/machine/machine_link.hpp"
#include "shared/record/snapshot_file.hpp"

namespace psicarve::machine {

/// Copies job, status and flight recorder out of the segment, with a living core or without. Holds the mutex
/// while it copies the job, and waits for it no longer than `limit`.
Result<Snapshot> take_snapshot(MachineLink& link, std::chrono::milliseconds limit);

}  // namespace psicarve::machine
