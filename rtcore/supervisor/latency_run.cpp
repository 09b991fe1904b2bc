// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/latency_run.hpp"

#include <signal.h>

#include <atomic>
#include <cstdio>
#include <ctime>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include "rtcore/realtime/clock.hpp"
#include "rtcore/realtime/periodic.hpp"
#include "rtcore/realtime/realtime_setup.hpp"
#include "rtcore/supervisor/end_request.hpp"
#include "shared/base/units.hpp"

namespace psicarve::supervisor {
namespace {

/// Blocks both, so that they wait to be asked for; threads started from here on leave them to us as well.
sigset_t held_signals() {
    sigset_t held;
    sigemptyset(&held);
    sigaddset(&held, SIGINT);
    sigaddset(&held, SIGTERM);
    sigprocmask(SIG_BLOCK, &held, nullptr);
    return held;
}

std::string counts_json(const rtcore::PeriodicReport& report) {
    return "\"ticks\": " + std::to_string(report.ticks_run) +
           ", \"missed\": " + std::to_string(report.ticks_missed) +
           ", \"max_ns\": " + std::to_string(report.max_lateness_ns);
}

std::string steps_json(std::uint32_t steps) {
    std::string text;
    for (const RealtimeStep step : kAllRealtimeSteps) {
        if ((steps & bit_of(step)) == 0) continue;
        text += (text.empty() ? "\"" : ", \"") + std::string{name_of(step)} + "\"";
    }
    return "[" + text + "]";
}

/// [[microseconds, ticks], ...] without those that are empty; the last bin also holds what came later still.
std::string histogram_json(const rtcore::PeriodicStats& stats) {
    std::string text;
    for (std::size_t late_us = 0; late_us < rtcore::kFineBins; ++late_us) {
        const std::uint64_t ticks = stats.ticks_at_us(late_us);
        if (ticks == 0) continue;
        text += (text.empty() ? "[" : ", [") + std::to_string(late_us) + ", " + std::to_string(ticks) + "]";
    }
    return "[" + text + "]";
}

void print_result(const rtcore::PeriodicStats& stats, const RealtimeFacts& facts) {
    std::printf(
        "{\"result\": true, %s, \"minor_faults\": %llu, \"major_faults\": %llu, \"sleeps\": %llu, "
        "\"preemptions\": %llu, \"cpu\": %d, \"priority\": %u, \"done\": %s, \"refused\": %s, "
        "\"histogram_us\": %s}\n",
        counts_json(stats.report()).c_str(), static_cast<unsigned long long>(facts.tick_counts.minor_faults),
        static_cast<unsigned long long>(facts.tick_counts.major_faults),
        static_cast<unsigned long long>(facts.tick_counts.sleeps),
        static_cast<unsigned long long>(facts.tick_counts.preemptions), facts.tick_cpu, facts.tick_priority,
        steps_json(facts.done).c_str(), steps_json(facts.asked & ~facts.done).c_str(),
        histogram_json(stats).c_str());
    std::fflush(stdout);
}

}  // namespace

int run_latency_measurement(const CoreOptions& options) {
    const sigset_t held = held_signals();
    RealtimeOptions wish;
    wish.cpu = options.cpu;
    wish.takes_any_cpu = options.takes_any_cpu;
    wish.priority = options.priority;
    RealtimeSetup setup{wish};
    const auto stats = std::make_unique<rtcore::PeriodicStats>();
    setup.touch_memory();
    std::atomic<bool> must_end{false};
    std::promise<void> is_treated;
    std::thread base{[&] {
        setup.treat_this_thread();
        setup.begin_counting();
        is_treated.set_value();
        rtcore::RealClock clock;
        rtcore::run_periodic(clock, {.period_ns = std::int64_t{options.measure_period_us} * kNsPerUs}, *stats,
                             [&](const rtcore::PeriodicTick&) noexcept { return !must_end.load(); });
    }};
    is_treated.get_future().wait();
    const auto tell = [&](std::uint32_t seconds) {
        std::printf("{\"seconds\": %u, %s}\n", seconds, counts_json(stats->report()).c_str());
        std::fflush(stdout);
    };
    // From here on a signal ends it in order: its starter may know.
    tell(0);
    const timespec second{1, 0};
    for (std::uint32_t n = 1; n <= options.measure_seconds; ++n) {
        const bool is_told_to_end = sigtimedwait(&held, nullptr, &second) > 0;
        if (is_told_to_end) break;
        tell(n);
    }
    // Read from here, while it still ticks: reading is no part of what is measured.
    const RealtimeFacts facts = setup.facts();
    must_end.store(true);
    base.join();
    print_result(*stats, facts);
    return kExitDone;
}

}  // namespace psicarve::supervisor
