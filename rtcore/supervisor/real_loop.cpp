// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <future>
#include <thread>

#include "rtcore/process/handler_stack.hpp"
#include "rtcore/realtime/missed_ticks.hpp"
#include "rtcore/supervisor/outlets.hpp"
#include "rtcore/supervisor/run_loops.hpp"
#include "rtcore/supervisor/tick_threads.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::chrono::milliseconds kSupervisorWait{5};
constexpr std::chrono::microseconds kPlannerWait{500};
/// While an answer is due from the tick, which wakes no thread; in so many rounds it comes, or the tick is
/// late.
constexpr std::chrono::microseconds kLeastAnswerWait{100};
constexpr int kAnswerRounds = 50;

void run_planner(plan::Planner& planner, const std::atomic<bool>& must_end) {
    const rtcore::HandlerStack handler_stack;
    while (!must_end.load()) {
        if (planner.wants_poll()) {
            planner.poll();
            if (planner.is_waiting()) std::this_thread::sleep_for(kPlannerWait);
        } else {
            std::this_thread::sleep_for(kPlannerWait);
        }
    }
}

/// Of both timers, where there are two.
LatenessFacts lateness_of(const TickThreads& threads) {
    const rtcore::PeriodicReport ticks = threads.stats.report();
    const rtcore::PeriodicReport interpolation = threads.interpolation_stats.report();
    LatenessFacts facts;
    facts.max_ns = std::max(ticks.max_lateness_ns, interpolation.max_lateness_ns);
    for (std::size_t bin = 0; bin < facts.histogram.size(); ++bin) {
        facts.histogram[bin] = ticks.lateness_histogram[bin] + interpolation.lateness_histogram[bin];
    }
    return facts;
}

/// The supervisor's own loop. Returns the exit code.
int serve(CoreParts& parts, Supervisor& supervisor, const Directors& directors, EndRequest& end,
          RealtimeSetup& setup, TickThreads& threads) {
    MissedTicks missed{parts.profile.tick.missed_alarm_per_s};
    const std::chrono::nanoseconds answer_wait =
        std::max<std::chrono::nanoseconds>(kLeastAnswerWait, std::chrono::nanoseconds{parts.period_ns});
    int answer_rounds = 0;
    for (;;) {
        supervisor.note_round();
        if (supervisor.poll()) answer_rounds = kAnswerRounds;
        supervisor.set_lateness(lateness_of(threads));
        supervisor.set_realtime(setup.facts());
        move_traces(parts);
        // At rest a missed tick harms nothing.
        const bool moves = !is_at_rest(supervisor.sample().state);
        if (missed.is_too_many(supervisor.sample().missed_ticks, moves, std::chrono::steady_clock::now())) {
            supervisor.fail(cycle::failure_bits(AlarmCause::missed_ticks));
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
        const bool is_prompt = answer_rounds > 0 && supervisor.awaits_answer();
        if (is_prompt) --answer_rounds;
        supervisor.wait(is_prompt ? answer_wait : std::chrono::nanoseconds{kSupervisorWait});
    }
}

}  // namespace

int run_on_real_clock(CoreParts& parts, Supervisor& supervisor, const Directors& directors, EndRequest& end,
                      RealtimeSetup& setup) {
    TickThreads threads;
    const bool has_two_timers = parts.profile.tick.schedule == Schedule::two_timer;
    setup.touch_memory();
    std::promise<bool> may_tick;
    const rtcore::HandlerStack handler_stack;
    std::thread base{[&] {
        const rtcore::HandlerStack own_handler_stack;
        const bool may = setup.treat_this_thread();
        if (may) setup.begin_counting();
        may_tick.set_value(may);
        if (may) run_ticks(parts, directors.record, threads);
    }};
    if (!may_tick.get_future().get()) {
        base.join();
        return kExitAlarm;
    }
    std::thread interpolation;
    if (has_two_timers) {
        interpolation = std::thread{[&] {
            const rtcore::HandlerStack own_handler_stack;
            setup.treat_interpolation_thread();
            run_interpolation(parts, threads);
        }};
    }
    std::atomic<bool> planner_must_end{false};
    std::thread planner{[&] { run_planner(*parts.planner, planner_must_end); }};
    supervisor.listen_for_stops();
    const int exit_code = serve(parts, supervisor, directors, end, setup, threads);
    threads.must_end.store(true);
    base.join();
    if (interpolation.joinable()) interpolation.join();
    planner_must_end.store(true);
    planner.join();
    setup.write_lateness(threads.stats, threads.interpolation_stats);
    finish_traces_in_time(parts);
    return exit_code;
}

}  // namespace psicarve::supervisor
