// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "shared/base/result.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::supervisor {

/// Publishes the job of a record, so that the core and all other processes find it. A publisher takes the
/// segment's mutex, and a core takes no lock from the segment: so a process of its own does it. Call it
/// before other threads start. Errors: those of publish_job(), timed_out where another process holds the
/// mutex; machine_refused when that process cannot be started, or is killed.
Result<void> publish_recorded_job(Segment& segment, std::span<const std::byte> job_blob);

}  // namespace psicarve::supervisor
