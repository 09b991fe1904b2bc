// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "rtcore/realtime/realtime_setup.hpp"
#include "rtcore/supervisor/core_parts.hpp"
#include "rtcore/supervisor/end_request.hpp"
#include "rtcore/supervisor/replay.hpp"
#include "rtcore/supervisor/supervisor.hpp"

namespace psicarve::supervisor {

/// What a run does besides serving commands. At most one of them.
struct Directors {
    JobDirector* job = nullptr;
    RecordDirector* record = nullptr;
    /// On the virtual clock: makes the program of `record` ready, once its writer is there; false: it is not.
    /// Empty: `record` is of a job, or of moves, and waits for the job.
    std::function<bool()> open_program;
};

/// One thread does everything in turn, as fast as it goes; only traces and words are written by others. Time
/// stands still while the machine is at rest (docs/decisions 0002) and while a trace's reader is behind.
/// Returns the exit code.
int run_on_virtual_clock(CoreParts& parts, Supervisor& supervisor, const Directors& directors,
                         EndRequest& end);

/// Three threads: tick, planner, and this one for the segment; what may block others do. Returns the exit
/// code.
int run_on_real_clock(CoreParts& parts, Supervisor& supervisor, const Directors& directors, EndRequest& end,
                      RealtimeSetup& setup);

}  // namespace psicarve::supervisor
