// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hmi/machine/core_process.hpp"
#include "hmi/machine/machine_link.hpp"

namespace psicarve::machine {

/// The result of a job's run on a core.
struct JobRun {
    CoreStatus before{};  ///< the core's status when the run began; zero when the core began with the run
    CoreStatus after{};   ///< the last status that was read
    /// The core accepted the start: its status is about this job.
    bool has_started = false;
    double wall_seconds = 0.0;
    std::optional<Error> failure;  ///< alarm, refusal, a stop, a dead core
};

/// Figures calculated from two statuses and a tick's length.
struct RunFigures {
    /// As the core counts them: since the start, without homing. Zero for a job that was not started.
    std::array<std::uint64_t, kAxisCount> pulses{};
    /// Machine time from leaving the first point to reaching the last; nothing when it was not reached.
    std::optional<double> carve_seconds;
    std::optional<double> reference_seconds;  ///< T_ref, as the core planned it
    double total_seconds = 0.0;  ///< machine time of the whole run, approach and retraction included
    std::uint64_t ticks = 0;
    std::uint64_t missed_ticks = 0;
    std::vector<AlarmRecord> alarms;  ///< oldest first; as many as the core remembers
    bool is_complete = false;         ///< every point reached, and retracted
};
RunFigures figures_of(const JobRun& run);

/// Homes if needed, publishes, starts, carves, and waits until the core is ready again. Sends nothing to a
/// core that is busy or in alarm: then the reason is the run's failure.
JobRun run_job(MachineLink& link, std::span<const std::byte> job_blob, const StatusWatch& watch);

/// Watches a core that replays by itself until it ends.
JobRun follow_replay(MachineLink& link, CoreProcess& core, const StatusWatch& watch);

}  // namespace psicarve::machine
