// SPDX-License-Identifier: GPL-3.0-or-later
// How long an emergency stop takes until the pins of a port show it, under a flood of commands and without
// one, in turns: drives that home, and are to be off. The flood are two processes that keep the segment's
// command slots full of requests that the core refuses, each sent anew as soon as it is answered. Wanted at
// most: twice as long under the flood, by the medians; ends with 1 above that, or where the flood was none.
// The port is a preloaded library that notes when it was written; the number of rounds may be given.
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "shared/segment/layout.hpp"
#include "tests/bench/machine/core_on_fake_port.hpp"

namespace {

using namespace psicarve;
using std::chrono::milliseconds;

constexpr int kRounds = 200;
constexpr double kMostRatio = 2.0;
constexpr double kPeriod_us = 50.0;
constexpr std::size_t kClients = 2;
/// Together they want more slots than there are, but for those that the bench itself needs.
constexpr std::size_t kSendersOfClient = kCommandSlots / kClients - 1;
constexpr fake_port::Wire kEnable{fake_port::Register::data, 4, 0};  // pin 6: R1 and psi

using Count = std::atomic<std::uint64_t>;

/// Also where the bench itself is killed nothing stays behind.
[[noreturn]] void send_for_ever(const std::string& segment_name, Count& answered, pid_t bench) {
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != bench) std::_Exit(1);
    auto segment = Segment::attach(segment_name);
    if (!segment) std::_Exit(1);
    std::vector<std::thread> senders;
    for (std::size_t i = 0; i < kSendersOfClient; ++i) {
        senders.emplace_back([&] {
            Command command{};
            command.kind = static_cast<CommandKind>(999);
            for (;;) {
                (void)send_command(*segment, command, bench::kPatience);
                ++answered;
            }
        });
    }
    for (;;) pause();
}

/// Clients of the segment, until it goes.
class Flood {
public:
    explicit Flood(const std::string& segment_name)
        : answered_(new (mmap(nullptr, sizeof(Count), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1,
                              0)) Count{0}) {
        const pid_t bench = getpid();
        for (pid_t& client : clients_) {
            client = fork();
            if (client == 0) send_for_ever(segment_name, *answered_, bench);
        }
    }
    ~Flood() {
        for (const pid_t client : clients_) {
            kill(client, SIGKILL);
            waitpid(client, nullptr, 0);
        }
        munmap(answered_, sizeof(Count));
    }
    Flood(const Flood&) = delete;
    Flood& operator=(const Flood&) = delete;

    std::uint64_t answered() const { return answered_->load(); }

private:
    Count* answered_;  ///< by all clients
    std::array<pid_t, kClients> clients_{};
};

bool becomes(bench::CoreOnFakePort& core, bool is_alarm) {
    for (int i = 0; i < 5000; ++i) {
        if ((core.status().state == MachineState::alarm) == is_alarm) return true;
        std::this_thread::sleep_for(milliseconds{1});
    }
    return false;
}

/// A core that homes, and an emergency stop: from the request to the drives' pin. Negative: it was not seen.
double stop_us(bench::CoreOnFakePort& core, int round) {
    const std::uint64_t before = core.write_count();
    if (!core.send_until_done(CommandKind::home) || core.seen_on_wire_ns(kEnable, true, before) < 0)
        return -1.0;
    std::this_thread::sleep_for(std::chrono::microseconds{5000 + round * 37 % 3000});
    const std::uint64_t written = core.write_count();
    const std::int64_t begin_ns = bench::now_ns();
    request_emergency_stop(core.segment());
    const std::int64_t seen_ns = core.seen_on_wire_ns(kEnable, false, written);
    if (seen_ns < 0 || !becomes(core, true)) return -1.0;
    core.stand();
    if (!core.send_until_done(CommandKind::reset_alarm) || !becomes(core, false)) return -1.0;
    return static_cast<double>(seen_ns - begin_ns) * 1e-3;
}

struct Rounds {
    std::vector<double> quiet_us;
    std::vector<double> flooded_us;
    std::vector<double> commands_per_s;  ///< of the floods
};

bool add_round(bench::CoreOnFakePort& core, Rounds& rounds) {
    const int round = static_cast<int>(rounds.quiet_us.size());
    rounds.quiet_us.push_back(stop_us(core, round));
    const Flood flood{core.name()};
    std::this_thread::sleep_for(milliseconds{50});
    const std::uint64_t answered = flood.answered();
    const std::int64_t begin_ns = bench::now_ns();
    rounds.flooded_us.push_back(stop_us(core, round));
    rounds.commands_per_s.push_back(static_cast<double>(flood.answered() - answered) /
                                    (static_cast<double>(bench::now_ns() - begin_ns) * 1e-9));
    return rounds.quiet_us.back() >= 0.0 && rounds.flooded_us.back() >= 0.0;
}

int verdict_of(const Rounds& rounds) {
    for (const double share : {0.5, 0.9, 0.99}) {
        const double quiet_us = bench::percentile(rounds.quiet_us, share);
        const double flooded_us = bench::percentile(rounds.flooded_us, share);
        std::printf("p%.0f: %.1f us without, %.1f us under the flood: %.2f times\n", 100.0 * share, quiet_us,
                    flooded_us, flooded_us / quiet_us);
    }
    const double ratio = bench::percentile(rounds.flooded_us, 0.5) / bench::percentile(rounds.quiet_us, 0.5);
    const double least_per_s = bench::percentile(rounds.commands_per_s, 0.0);
    std::printf("flood: %.0f commands answered a second (median), at least %.0f; wanted at most %.1f times\n",
                bench::percentile(rounds.commands_per_s, 0.5), least_per_s, kMostRatio);
    return ratio <= kMostRatio && least_per_s > 0.0 ? 0 : 1;
}

int measure_in(const std::string& folder, int count) {
    bench::CoreOnFakePort core{folder, kPeriod_us};
    if (!core.attach()) {
        std::fprintf(stderr, "flood_to_pins: %s\n", two_process::text_of(folder + "/core.err").c_str());
        return 1;
    }
    std::printf("emergency stop to pins, tick of %.0f us, %d rounds in turns without and under a flood\n",
                kPeriod_us, count);
    Rounds rounds;
    for (int round = 0; round < count; ++round) {
        if (add_round(core, rounds)) continue;
        std::fprintf(stderr, "flood_to_pins: an emergency stop was not seen\n");
        return 1;
    }
    return verdict_of(rounds);
}

}  // namespace

int main(int count, char** words) {
    std::string folder = std::filesystem::temp_directory_path() / "psicarve-bench-XXXXXX";
    if (mkdtemp(folder.data()) == nullptr) return 1;
    const int code = measure_in(folder, count > 1 ? std::max(1, std::atoi(words[1])) : kRounds);
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
    return code;
}
