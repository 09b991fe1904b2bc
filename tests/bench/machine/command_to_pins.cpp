// SPDX-License-Identifier: GPL-3.0-or-later
// How long a command takes from the call that sends it until the pins of a port show its effect, and until it
// is answered; beside it, in turns, how long a process takes to wake by the segment's own event. Wanted at
// most: one tick, and 1.5 times the wake-up. Nine runs, each with a core of its own: of each the ratio of
// medians, in the end the median of the ratios. Ends with 1 when that is above 1, or when a core has not got
// SCHED_FIFO. The port is a preloaded library that notes when it was written; `period_us` and the number of
// runs may be given.
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "shared/computer/event.hpp"
#include "shared/computer/realtime_step.hpp"
#include "tests/bench/machine/core_on_fake_port.hpp"

namespace {

using namespace psicarve;
using bench::kPatience;
using bench::now_ns;
using bench::percentile;
using std::chrono::milliseconds;

constexpr int kRuns = 9;
constexpr int kRounds = 1000;
constexpr double kMostRatio = 1.0;
constexpr std::array kShares{0.5, 0.9, 0.99};

void pause_between(int round) {
    // Never in step with ticks or with the supervisor's own looks: nor by waking with the tick's own timer,
    // which an ordinary thread's would be put off to.
    prctl(PR_SET_TIMERSLACK, 1);
    std::this_thread::sleep_for(std::chrono::microseconds{2000 + round * 37 % 3000});
}

/// A process that does nothing but wake up.
class Sleeper {
public:
    Sleeper() {
        void* const memory =
            mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        shared_ = new (memory) Shared{};
        pid_ = fork();
        if (pid_ == 0) sleep_for_ever();
    }
    ~Sleeper() {
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
    Sleeper(const Sleeper&) = delete;
    Sleeper& operator=(const Sleeper&) = delete;

    double wake_us() {
        const std::uint64_t before = shared_->count.load();
        const std::int64_t begin_ns = now_ns();
        event_signal(shared_->event);
        while (shared_->count.load() == before) std::this_thread::sleep_for(std::chrono::microseconds{200});
        return static_cast<double>(shared_->woke_ns.load() - begin_ns) * 1e-3;
    }

private:
    struct Shared {
        EventWord event{};
        std::atomic<std::int64_t> woke_ns{0};
        std::atomic<std::uint64_t> count{0};
    };
    [[noreturn]] void sleep_for_ever() {
        // From the first on, however late this process begins. The count that a wake-up has seen is taken
        // before it is told: what comes next counts from there.
        for (std::uint32_t seen = 0;;) {
            if (!event_wait_past(shared_->event, seen, kPatience)) continue;
            shared_->woke_ns.store(now_ns());
            seen = event_count(shared_->event);
            shared_->count.fetch_add(1);
        }
    }
    Shared* shared_;
    pid_t pid_;
};

/// What the kernel says of a process's threads: real-time priority (0: none), and how many have it.
std::map<int, int, std::greater<>> threads_by_priority(pid_t pid) {
    std::map<int, int, std::greater<>> threads;
    std::error_code ignored;
    const std::string folder = "/proc/" + std::to_string(pid) + "/task";
    for (const auto& entry : std::filesystem::directory_iterator{folder, ignored}) {
        const pid_t thread = std::atoi(entry.path().filename().c_str());
        sched_param parameters{};
        const bool is_fifo = (sched_getscheduler(thread) & ~SCHED_RESET_ON_FORK) == SCHED_FIFO &&
                             sched_getparam(thread, &parameters) == 0;
        ++threads[is_fifo ? parameters.sched_priority : 0];
    }
    return threads;
}

/// The core on the fake port, homed.
class Bench {
public:
    Bench(const std::string& folder, double period_us) : core_(folder, period_us) {}

    bool begin() {
        if (!core_.attach() || !core_.send(CommandKind::home)) return false;
        for (int i = 0; i < 6000; ++i) {
            const MachineState state = core_.status().state;
            if (state == MachineState::ready) return true;
            if (state == MachineState::alarm) {
                std::fprintf(stderr, "command_to_pins: alarm: %s\n",
                             std::string{name_of(core_.status().alarm_cause)}.c_str());
                return false;
            }
            std::this_thread::sleep_for(milliseconds{10});
        }
        return false;
    }
    /// The spindle on, or off: what the pins show of it, after the call.
    double effect_us(bool on) {
        const std::uint64_t written = core_.write_count();
        const std::int64_t begin_ns = now_ns();
        if (!core_.send(CommandKind::spindle, on ? 1.0 : 0.0)) return -1.0;
        answered_us_ = static_cast<double>(now_ns() - begin_ns) * 1e-3;
        const std::int64_t seen_ns = core_.seen_on_wire_ns(spindle_, on, written);
        return seen_ns < 0 ? -1.0 : static_cast<double>(seen_ns - begin_ns) * 1e-3;
    }
    /// The tick's thread has the highest priority of the core's.
    std::map<int, int, std::greater<>> core_threads() const {
        return threads_by_priority(static_cast<pid_t>(core_.segment().core_pid().value_or(0)));
    }
    CoreStatus status() const { return core_.status(); }
    /// How long the last one's answer took.
    double answered_us() const { return answered_us_; }

private:
    bench::CoreOnFakePort core_;
    double answered_us_ = 0.0;
    static constexpr fake_port::Wire spindle_{fake_port::Register::control, 2, 0};  // pin 16
};

struct Run {
    std::vector<double> effects_us;
    std::vector<double> wakes_us;
    std::vector<double> answers_us;
    std::map<int, int, std::greater<>> threads;
    double missed_ratio = 0.0;  ///< of the ticks that were due

    double wanted_us(double share, double period_us) const {
        return period_us + 1.5 * percentile(wakes_us, share);
    }
    double ratio(double share, double period_us) const {
        return percentile(effects_us, share) / wanted_us(share, period_us);
    }
    bool is_realtime() const { return !threads.empty() && threads.begin()->first == kTickPriority; }
};

/// The measurement of a core that works in this folder. The core has ended when it returns.
std::optional<Run> measured_in(const std::string& folder, double period_us) {
    Bench bench{folder, period_us};
    if (!bench.begin()) {
        std::fprintf(stderr, "command_to_pins: %s\n", two_process::text_of(folder + "/core.err").c_str());
        return std::nullopt;
    }
    Run run;
    run.threads = bench.core_threads();
    const CoreStatus before = bench.status();
    Sleeper sleeper;
    for (int round = 0; round < kRounds; ++round) {
        pause_between(round);
        run.wakes_us.push_back(sleeper.wake_us());
        pause_between(round);
        const double effect_us = bench.effect_us(round % 2 == 0);
        if (effect_us < 0.0) return std::nullopt;
        run.effects_us.push_back(effect_us);
        run.answers_us.push_back(bench.answered_us());
    }
    const CoreStatus after = bench.status();
    run.missed_ratio = static_cast<double>(after.missed_ticks - before.missed_ticks) /
                       static_cast<double>(std::max<std::uint64_t>(after.tick - before.tick, 1));
    return run;
}

std::optional<Run> measured(double period_us) {
    std::string folder = std::filesystem::temp_directory_path() / "psicarve-bench-XXXXXX";
    if (mkdtemp(folder.data()) == nullptr) return std::nullopt;
    auto run = measured_in(folder, period_us);
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
    return run;
}

void print(const Run& run, double period_us) {
    std::string threads;
    for (const auto& [priority, count] : run.threads) {
        threads += (threads.empty() ? "" : ", ") + std::to_string(count) + " of ";
        threads += priority > 0 ? "SCHED_FIFO " + std::to_string(priority) : "no real-time policy";
    }
    double load = 0.0;
    (void)getloadavg(&load, 1);
    std::printf("threads of the core: %s; %.1f %% of the ticks missed; load %.1f\n", threads.c_str(),
                100.0 * run.missed_ratio, load);
    for (const double share : kShares) {
        std::printf("  p%.0f: effect %.1f us, wake-up %.1f us, wanted %.1f us: %.2f of it; answer %.1f us\n",
                    100.0 * share, percentile(run.effects_us, share), percentile(run.wakes_us, share),
                    run.wanted_us(share, period_us), run.ratio(share, period_us),
                    percentile(run.answers_us, share));
    }
    std::fflush(stdout);
}

int measure(double period_us, int count) {
    std::printf("command to pins, tick of %.0f us, %d runs of %d rounds in turns with wake-ups\n", period_us,
                count, kRounds);
    int verdict = 0;
    std::vector<Run> runs;
    while (static_cast<int>(runs.size()) < count) {
        auto run = measured(period_us);
        if (!run) return 1;
        print(*run, period_us);
        runs.push_back(std::move(*run));
    }
    for (const double share : kShares) {
        std::vector<double> ratios;
        for (const Run& run : runs) ratios.push_back(run.ratio(share, period_us));
        std::printf("p%.0f: median ratio %.2f of %d runs, %.2f to %.2f\n", 100.0 * share,
                    percentile(ratios, 0.5), count, percentile(ratios, 0.0), percentile(ratios, 1.0));
        if (share != kShares.front()) continue;
        std::printf("     wanted at most %.1f\n", kMostRatio);
        if (percentile(ratios, 0.5) > kMostRatio) verdict = 1;
    }
    if (!std::all_of(runs.begin(), runs.end(), [](const Run& run) { return run.is_realtime(); })) {
        std::printf("NOT REAL TIME: %s\n", std::string{remedy_of(RealtimeStep::scheduling)}.c_str());
        verdict = 1;
    }
    return verdict;
}

}  // namespace

int main(int count, char** words) {
    const double period_us = count > 1 ? std::atof(words[1]) : 50.0;
    return measure(period_us, count > 2 ? std::max(1, std::atoi(words[2])) : kRuns);
}
