// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rtcore/realtime/periodic.hpp"
#include "rtcore/realtime/rt_setup.hpp"
#include "rtcore/realtime/thread_counts.hpp"

namespace psicarve::supervisor {

struct RealtimeOptions {
    std::optional<int> cpu;      ///< of the tick; nothing: see takes_any_cpu
    bool takes_any_cpu = false;  ///< false: an isolated one, when there is one
    int priority = kTickPriority;
    std::string lateness_path;  ///< empty: not written
    bool is_needed = false;     ///< real hardware: the core refuses to run without what keeps the tick in
                                ///< time
};

/// What the core shows of it in the segment; zero on the virtual clock.
struct RealtimeFacts {
    std::uint32_t asked = 0;  ///< bit by RealtimeStep
    std::uint32_t done = 0;
    std::int32_t tick_cpu = -1;  ///< -1: any
    std::uint32_t tick_priority = 0;
    rtcore::ThreadCounts tick_counts;  ///< since the first tick

    bool has_rights() const noexcept { return (done & kNeededRealtimeSteps) == kNeededRealtimeSteps; }
};

/// Takes the steps that make the tick come in time, in their order, and keeps their results. Made before the
/// core's parts, which are large; lives until the end.
class RealtimeSetup {
public:
    explicit RealtimeSetup(const RealtimeOptions& options);

    /// Call it once all that the tick touches has been made, before threads start.
    void touch_memory();
    /// Call it in the thread that will tick. Reports all steps on standard error. False: the thread must not
    /// tick.
    bool treat_this_thread();
    /// Schedule two-timer: call it in the thread that interpolates, once the other ticks. Sets it below the
    /// tick, beside its processor.
    void treat_interpolation_thread() const;
    /// The last call before the first tick.
    void begin_counting();

    /// Any thread, once treat_this_thread() has returned. Reads the kernel's counts only now and then.
    RealtimeFacts facts();
    /// Call it after the last tick: writes the file asked for. Schedule two-timer: of both threads.
    void write_lateness(const rtcore::PeriodicStats& stats,
                        const rtcore::PeriodicStats& interpolation_stats) const;

private:
    RealtimeOptions wish_;
    std::optional<int> cpu_;
    rtcore::WakeLatencyHold awake_;
    std::vector<rtcore::SetupStep> steps_;
    pid_t thread_ = 0;
    rtcore::ThreadCounts before_;
    RealtimeFacts facts_;
    std::chrono::steady_clock::time_point next_reading_{};
};

}  // namespace psicarve::supervisor
