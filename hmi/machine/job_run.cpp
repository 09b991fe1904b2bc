// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/job_run.hpp"

#include <algorithm>
#include <chrono>

#include "shared/base/units.hpp"

namespace psicarve::machine {
namespace {

using S = MachineState;
using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kFollowPoll{50};
constexpr int kJobRunExitAlarm = 4;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

Result<void> require_idle(const CoreStatus& status) {
    if (status.state == S::off || status.state == S::ready) return {};
    if (status.state == S::alarm || status.state == S::backing_off) {
        const Error alarm = alarm_error(status);
        return Error{alarm.code, alarm.message + "; then: psicarve reset-alarm"};
    }
    return Error{ErrorCode::machine_refused, "the machine is busy (state '" +
                                                 std::string{name_of(status.state)} +
                                                 "'); wait until it is ready, or stop it: psicarve stop"};
}

Result<void> carve(MachineLink& link, std::span<const std::byte> job_blob, const StatusWatch& watch,
                   JobRun& run) {
    if (const auto idle = require_idle(run.before); !idle) return idle;
    if (const auto published = link.publish(job_blob); !published) return published.error();
    if (run.before.state == S::off) {
        if (const auto sent = link.send(CommandKind::home); !sent) return sent;
        if (const auto homed = link.wait_for_state({S::ready}, watch); !homed) return homed.error();
    }
    if (const auto sent = link.send(CommandKind::start); !sent) return sent;
    run.has_started = true;
    if (const auto there = link.wait_for_state({S::waiting}, watch); !there) return there.error();
    if (const auto sent = link.send(CommandKind::start_interpolation); !sent) return sent;
    if (const auto done = link.wait_for_state({S::ready}, watch); !done) return done.error();
    return {};
}

}  // namespace

RunFigures figures_of(const JobRun& run) {
    const CoreStatus& after = run.after;
    const auto seconds = [&after](std::uint64_t from_tick, std::uint64_t to_tick) {
        if (to_tick <= from_tick) return 0.0;
        return seconds_from_ns(static_cast<std::int64_t>(to_tick - from_tick) * after.period_ns);
    };
    RunFigures figures;
    figures.ticks = after.tick - run.before.tick;
    figures.missed_ticks = after.missed_ticks - run.before.missed_ticks;
    const std::uint64_t oldest = after.alarm_count > kAlarmHistory ? after.alarm_count - kAlarmHistory : 0;
    for (std::uint64_t i = std::max(oldest, run.before.alarm_count); i < after.alarm_count; ++i) {
        figures.alarms.push_back(after.alarms[i % kAlarmHistory]);
    }
    if (!run.has_started) return figures;  // the rest belongs to the job before
    std::copy(std::begin(after.emitted_pulses), std::end(after.emitted_pulses), figures.pulses.begin());
    const bool is_last_reached = after.points_total > 0 && after.points_done == after.points_total;
    if (is_last_reached && after.carve_first_tick != 0) {
        figures.carve_seconds = seconds(after.carve_first_tick, after.carve_last_tick);
    }
    if (after.reference_seconds >= 0.0) figures.reference_seconds = after.reference_seconds;
    // A job that did not come to its end took as long as it ran.
    const std::uint64_t end_tick = after.job_end_tick != 0 ? after.job_end_tick : after.tick;
    figures.total_seconds = seconds(after.job_start_tick, end_tick);
    figures.is_complete = is_last_reached && after.job_end_tick != 0;
    return figures;
}

JobRun run_job(MachineLink& link, std::span<const std::byte> job_blob, const StatusWatch& watch) {
    JobRun run;
    const auto begin = Clock::now();
    const auto before = link.status();
    if (!before) {
        run.failure = before.error();
        return run;
    }
    run.before = *before;
    run.after = *before;
    const auto carved = carve(link, job_blob, watch, run);
    run.wall_seconds = seconds_since(begin);
    run.after = link.last_status().value_or(run.after);
    if (!carved) {
        run.failure = carved.error();
    } else if (!figures_of(run).is_complete) {
        run.failure =
            Error{ErrorCode::machine_refused, "the job ended before its last point: somebody stopped it"};
    }
    return run;
}

JobRun follow_replay(MachineLink& link, CoreProcess& core, const StatusWatch& watch) {
    JobRun run;
    run.has_started = true;  // a private core does nothing else
    const auto begin = Clock::now();
    std::optional<int> exit_code;
    while (!(exit_code = core.wait_exit(kFollowPoll))) {
        const auto status = link.last_status();
        if (!status || !watch || run.failure) continue;
        if (const auto go_on = watch(*status); !go_on) {
            run.failure = go_on.error();
            core.terminate();
        }
    }
    run.wall_seconds = seconds_since(begin);
    run.after = link.last_status().value_or(run.after);
    if (run.failure || *exit_code == 0) return run;
    if (*exit_code == kJobRunExitAlarm && run.after.alarm_count > 0) {
        run.failure = alarm_error(run.after);
        return run;
    }
    const std::string said = core.messages();
    run.failure = Error{
        *exit_code == kJobRunExitAlarm ? ErrorCode::machine_refused : ErrorCode::no_core,
        "the core ended with exit code " + std::to_string(*exit_code) + (said.empty() ? "" : ": " + said)};
    return run;
}

}  // namespace psicarve::machine
