// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/realtime/realtime_setup.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <span>
#include <string>

#include "rtcore/process/words.hpp"
#include "rtcore/realtime/clock.hpp"
#include "shared/file/atomic_file.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::chrono::milliseconds kReadingInterval{500};

}  // namespace

RealtimeSetup::RealtimeSetup(const RealtimeOptions& options) : wish_(options), cpu_(options.cpu) {
    if (!cpu_ && !options.takes_any_cpu) cpu_ = rtcore::isolated_cpu();
    steps_ = rtcore::set_up_process_memory();
    steps_.push_back(awake_.hold());
    // Before the core's threads start, so that none of them ever runs there.
    if (cpu_) rtcore::keep_off_cpu(*cpu_);
}

void RealtimeSetup::touch_memory() {
    steps_.push_back(rtcore::touch_heap());
}

bool RealtimeSetup::treat_this_thread() {
    thread_ = gettid();
    // The kernel's page with the time cannot be locked: the first reading brings it in.
    (void)rtcore::RealClock{}.now_ns();
    for (rtcore::SetupStep& step : rtcore::set_up_realtime_thread(wish_.priority, cpu_)) {
        steps_.push_back(std::move(step));
    }
    facts_.asked = rtcore::steps_asked(steps_);
    facts_.done = rtcore::steps_done(steps_);
    const auto is_done = [&](RealtimeStep step) { return (facts_.done & bit_of(step)) != 0; };
    if (cpu_ && is_done(RealtimeStep::tick_cpu)) facts_.tick_cpu = *cpu_;
    if (is_done(RealtimeStep::scheduling)) facts_.tick_priority = static_cast<std::uint32_t>(wish_.priority);
    for (const std::string& line : rtcore::report_of(steps_)) {
        std::fprintf(stderr, "psicarve-rtcore: %s\n", line.c_str());
    }
    if (!rtcore::has_realtime_kernel()) {
        std::fprintf(stderr,
                     "psicarve-rtcore: the kernel is not PREEMPT_RT: it keeps the tick waiting, at times for "
                     "milliseconds; %s\n",
                     std::string{kKernelRemedy}.c_str());
    }
    // A processor that was asked for by name and cannot be had is a mistake of the user.
    const bool has_no_cpu = wish_.cpu && !is_done(RealtimeStep::tick_cpu);
    const bool may_tick = !wish_.is_needed || (facts_.has_rights() && !has_no_cpu);
    if (!may_tick) {
        std::fprintf(
            stderr,
            "psicarve-rtcore: a real machine is not driven without these; --allow-no-realtime drives it "
            "all the same\n");
    }
    return may_tick;
}

// The first thread has found out and reported what the system grants. This only reads what was decided.
void RealtimeSetup::treat_interpolation_thread() const {
    static_cast<void>(rtcore::set_up_realtime_thread(std::max(1, wish_.priority - 1), cpu_));
}

void RealtimeSetup::begin_counting() {
    // The first reading makes page faults of its own, which the second does not repeat.
    (void)rtcore::counts_of_thread(thread_);
    before_ = rtcore::counts_of_thread(thread_).value_or(rtcore::ThreadCounts{});
}

void RealtimeSetup::write_lateness(const rtcore::PeriodicStats& stats,
                                   const rtcore::PeriodicStats& interpolation_stats) const {
    if (wish_.lateness_path.empty()) return;
    std::string text = "late_us,ticks\n";
    for (std::size_t late_us = 0; late_us < rtcore::kFineBins; ++late_us) {
        const std::uint64_t ticks = stats.ticks_at_us(late_us) + interpolation_stats.ticks_at_us(late_us);
        if (ticks > 0) text += std::to_string(late_us) + "," + std::to_string(ticks) + "\n";
    }
    const auto written = write_file_atomically(wish_.lateness_path, std::as_bytes(std::span{text}));
    if (!written) rtcore::try_to_say(written.error().message);
}

RealtimeFacts RealtimeSetup::facts() {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_reading_) return facts_;
    next_reading_ = now + kReadingInterval;
    if (const auto counts = rtcore::counts_of_thread(thread_)) facts_.tick_counts = counts->since(before_);
    return facts_;
}

}  // namespace psicarve::supervisor
