// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <future>
#include <thread>

#include "rtcore/clock.hpp"
#include "rtcore/periodic.hpp"
#include "rtcore/supervisor/missed_ticks.hpp"
#include "rtcore/supervisor/run_loops.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::chrono::milliseconds kSupervisorWait{5};
constexpr std::chrono::microseconds kPlannerWait{500};

/// What the three threads share besides the rings.
struct Threads {
    std::atomic<bool> tick_must_end{false};
    std::atomic<bool> planner_must_end{false};
    std::atomic<bool> record_is_over{false};
    std::atomic<bool> record_may_begin{false};
    rtcore::PeriodicStats stats;
};

void run_planner(plan::Planner& planner, const Threads& threads) {
    while (!threads.planner_must_end.load()) {
        if (planner.wants_poll()) {
            planner.poll();
        } else {
            std::this_thread::sleep_for(kPlannerWait);
        }
    }
}

void run_ticks(CoreParts& parts, RecordDirector* record, Threads& threads) {
    rtcore::RealClock clock;
    const rtcore::PeriodicOptions options{
        .period_ns = parts.period_ns,
        .least_gap_ns = least_tick_gap_ns(parts.profile),
    };
    guard::GuardLink* const guard = parts.guard.get();
    if (guard != nullptr) guard->set_ticking(true);
    rtcore::run_periodic(clock, options, threads.stats, [&](const rtcore::PeriodicTick& tick) noexcept {
        if (tick.missed_before > 0) parts.cycle->advance_missed(tick.missed_before);
        if (record != nullptr) {
            const std::uint64_t next_tick = parts.cycle->next_tick();
            if (!record->has_begun() && threads.record_may_begin.load()) record->begin(next_tick);
            record->before_tick(next_tick, parts);
            if (record->is_over(next_tick)) threads.record_is_over.store(true);
        }
        parts.cycle->tick();
        if (guard != nullptr) guard->note_tick();
        return !threads.tick_must_end.load(std::memory_order_relaxed);
    });
    if (guard != nullptr) guard->set_ticking(false);
    parts.cycle->shut_down();
}

void move_traces(CoreParts& parts) {
    parts.traces.drain(*parts.trace_ring);
    for (const std::string& line : parts.traces.take_errors())
        std::fprintf(stderr, "psicarve-rtcore: %s\n", line.c_str());
}

LatenessFacts lateness_of(const rtcore::PeriodicReport& report) {
    LatenessFacts facts;
    facts.max_ns = report.max_lateness_ns;
    facts.histogram = report.lateness_histogram;
    return facts;
}

/// The supervisor's own loop. Returns the exit code.
int serve(CoreParts& parts, Supervisor& supervisor, const Directors& directors, EndRequest& end,
          RealtimeTreatment& treatment, Threads& threads) {
    MissedTicks missed{parts.profile.tick.missed_alarm_per_s};
    for (;;) {
        supervisor.set_lateness(lateness_of(threads.stats.report()));
        supervisor.set_realtime(treatment.facts());
        supervisor.poll();
        move_traces(parts);
        // A replay's tick is the only writer of the request ring; and at rest a missed tick harms nothing.
        const bool may_ask = directors.record == nullptr && !is_at_rest(supervisor.sample().state);
        if (missed.is_too_many(supervisor.sample().missed_ticks, std::chrono::steady_clock::now()) &&
            may_ask) {
            supervisor.request(cycle::RequestKind::fail,
                               static_cast<std::uint64_t>(AlarmCause::missed_ticks));
        }
        if (directors.job != nullptr) {
            const auto progress = directors.job->poll(supervisor);
            if (progress == JobDirector::Progress::alarm) return kExitAlarm;
            if (progress == JobDirector::Progress::done) return kExitDone;
        }
        if (directors.record != nullptr) {
            if (supervisor.sample().job_generation != 0) threads.record_may_begin.store(true);
            if (threads.record_is_over.load()) {
                return supervisor.sample().state == MachineState::alarm ? kExitAlarm : kExitDone;
            }
        }
        if (end.poll(supervisor) == EndRequest::Progress::may_end || supervisor.shutdown_requested())
            return kExitDone;
        parts.traces.flush();
        supervisor.wait(kSupervisorWait);
    }
}

}  // namespace

int run_on_real_clock(CoreParts& parts, Supervisor& supervisor, const Directors& directors, EndRequest& end,
                      RealtimeTreatment& treatment) {
    Threads threads;
    treatment.treat_memory_and_others();
    std::promise<bool> may_tick;
    std::thread base{[&] {
        const bool may = treatment.treat_this_thread();
        if (may) treatment.begin_counting();
        may_tick.set_value(may);
        if (may) run_ticks(parts, directors.record, threads);
    }};
    if (!may_tick.get_future().get()) {
        base.join();
        return kExitAlarm;
    }
    std::thread planner{[&] { run_planner(*parts.planner, threads); }};
    const int exit_code = serve(parts, supervisor, directors, end, treatment, threads);
    threads.tick_must_end.store(true);
    base.join();
    threads.planner_must_end.store(true);
    planner.join();
    treatment.write_lateness(threads.stats);
    move_traces(parts);
    parts.traces.finish(parts.cycle->next_tick());
    move_traces(parts);
    return exit_code;
}

}  // namespace psicarve::supervisor
