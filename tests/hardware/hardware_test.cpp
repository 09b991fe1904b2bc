// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "shared/record/snapshot_file.hpp"
#include "tests/hardware/lab.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::hardware {
namespace {

using fake_port::Pulse;
using std::chrono::seconds;

constexpr seconds kBootLimit{300};
constexpr seconds kRunLimit{600};
constexpr std::size_t kRuns = 7;
constexpr std::uint32_t kR2LimitBit = 0x80;
constexpr std::uint32_t kLines = 0x0f;  ///< of control: the driver keeps the interrupt's bit as it likes
constexpr std::uint64_t kSafeAfterDeath_ns = 100'000'000;
constexpr std::uint64_t kLeastSleep_s = 2;
constexpr std::uint64_t kLeastSleep_ns = kLeastSleep_s * 1'000'000'000;
constexpr std::size_t kMostPulsesAwake = 10;  ///< of four axes in 5 ms, a look's time: one in two ticks
constexpr std::uint64_t kLeastTimesSet = 50;
constexpr const char* kPpdev = "ppdev:/dev/parport0";
constexpr const char* kRawPort = "io:0x378";

class Hardware : public two_process::PortRig {
protected:
    void SetUp() override {
        const char* const skip = std::getenv("PSICARVE_SKIP_HARDWARE");
        if (skip != nullptr && std::string{skip} == "1") GTEST_SKIP() << "PSICARVE_SKIP_HARDWARE=1";
        save_job(coarse_job(2), "job.psi");
        // The same machine homed where it stands, for what comes after both kinds of port have looked for its
        // sensors.
        const Profile by_sensors = profile_;
        two_process::take_sensors_away(profile_);
        write_profile("unsensed.toml");
        save_job(coarse_job(60), "long.psi");
        profile_ = by_sensors;
        std::ofstream{file("safe")} << int{safe().data} << ' ' << (safe().control & kLines) << '\n';
        const std::string problem = lab_.prepare(
            file("."),
            {file("machine.toml"), file("unsensed.toml"), file("job.psi"), file("long.psi"), file("safe")});
        ASSERT_EQ(problem, "");
    }
    void save_job(const JobTable& table, const std::string& name) const {
        Snapshot snapshot;
        snapshot.job_blob = job_blob_from_table(table);
        ASSERT_TRUE(save_snapshot(snapshot, file(name)));
    }
    /// These status bits flip somewhere in the job that is about to begin: the count of pulses then.
    std::uint64_t flip_after(std::size_t pulses, std::uint32_t status_bits) {
        const std::uint64_t at = port_.state().pulse_count.load() + pulses;
        port_.state().flip_to.store(status_bits);
        port_.state().flip_at_pulse.store(at);
        return at;
    }
    void expect_safe_lines() {
        EXPECT_EQ(port_.state().data.load(), safe().data);
        EXPECT_EQ(port_.state().control.load() & kLines, safe().control & kLines);
    }
    /// The guest has killed the core on this port in the midst of its job, and waits until its lines are
    /// looked at.
    void expect_safe_after_death(const std::string& port) {
        ASSERT_TRUE(lab_.wait_for("LAB killed core's guard on " + port + " ended 137", kRunLimit))
            << lab_.console();
        expect_safe_lines();
        port_.state().status_flip.store(kEstopStatusBit);
        ASSERT_TRUE(lab_.wait_for("LAB port " + port + " was looked at", kRunLimit)) << lab_.console();
    }
    /// 0 where the console does not have the words.
    static std::uint64_t number_after(const std::string& console, const std::string& words) {
        const std::size_t at = console.find(words);
        std::uint64_t number = 0;
        if (at != std::string::npos) std::istringstream{console.substr(at + words.size())} >> number;
        return number;
    }
    /// By the guest's clock, from before the signal to the first look at the registers that finds them safe.
    /// A host that takes the guest's processor away shows in none of it.
    static void expect_soon_safe(const std::string& console, const std::string& port) {
        const std::uint64_t after_ns = number_after(console, "LAB safe on " + port + " after ");
        EXPECT_GT(after_ns, 0U) << console;
        EXPECT_LE(after_ns, kSafeAfterDeath_ns) << port;
        std::printf("%s: safe %.1f ms after the core was killed\n", port.c_str(),
                    static_cast<double>(after_ns) * 1e-6);
    }
    /// While the first run lasted.
    static void expect_no_alarm_by_the_clock(const std::string& console) {
        EXPECT_GE(number_after(console, "LAB clock was set "), kLeastTimesSet) << console;
        EXPECT_NE(console.find("LAB status alarms     0 since the core started"), std::string::npos)
            << console;
    }
    /// Finds the first write after the guest's sleep, and the last one of that run.
    void watch_sleep() {
        ASSERT_TRUE(lab_.wait_for("LAB falls asleep", kRunLimit)) << lab_.console();
        const std::uint64_t first = port_.state().write_count.load();
        ASSERT_TRUE(lab_.wait_for("LAB end of run on ppdev:/dev/parport0: alarm", kRunLimit))
            << lab_.console();
        const auto writes = port_.writes();
        // The port's longest pause is the sleep: nothing is written while the guest sleeps.
        std::uint64_t longest_ns = 0;
        for (std::size_t i = std::max<std::size_t>(first, 1); i < writes.size(); ++i) {
            const std::uint64_t pause_ns = writes[i].time_ns - writes[i - 1].time_ns;
            if (pause_ns > longest_ns) first_write_awake_ = i;
            longest_ns = std::max(longest_ns, pause_ns);
        }
        ASSERT_GT(longest_ns, kLeastSleep_ns) << lab_.console();
        ASSERT_TRUE(lab_.wait_for("LAB begin kill", kRunLimit)) << lab_.console();
        last_write_awake_ = port_.state().write_count.load();
        expect_safe_lines();
    }
    static void expect_slept(const std::string& console) {
        const std::size_t begin = console.find("LAB begin sleep");
        ASSERT_NE(begin, std::string::npos) << console;
        const std::string said = console.substr(begin, console.find("LAB begin kill") - begin);
        EXPECT_GE(number_after(said, "LAB slept "), kLeastSleep_s) << said;
        for (const char* line : {"LAB status state      in alarm (tick gap)", "LAB status homed      none",
                                 "LAB status drives on  none, spindle off"}) {
            EXPECT_NE(said.find(line), std::string::npos) << line << '\n' << said;
        }
    }
    /// The core makes up for no tick; a few more go on until its supervisor sees that the computer slept.
    void expect_no_burst_after_sleep(const std::vector<std::uint32_t>& levels) const {
        std::vector<Pulse> pulses;
        for (std::size_t i = first_write_awake_; i < last_write_awake_; ++i) {
            fake_port::add_pulses(levels[i - 1], levels[i], pulses);
        }
        EXPECT_LE(pulses.size(), kMostPulsesAwake);
        std::printf("%zu pulses after the computer slept\n", pulses.size());
    }
    /// On the real clock, driving a real port, with all of a root's rights at the start.
    static void expect_no_privileges(const std::string& console) {
        const std::string nothing =
            "CapInh=0000000000000000 CapPrm=0000000000000000 CapEff=0000000000000000 CapBnd=0000000000000000 "
            "CapAmb=0000000000000000 NoNewPrivs=1 ";
        int threads = 0;
        for (const char* process : {"LAB rights of core: ", "LAB rights of guard: "}) {
            std::size_t at = console.find(process);
            EXPECT_NE(at, std::string::npos) << console;
            for (; at != std::string::npos; at = console.find(process, at + 1), ++threads) {
                EXPECT_EQ(console.compare(at + std::string{process}.size(), nothing.size(), nothing), 0)
                    << console.substr(at, 200);
            }
        }
        const std::string carver = "1000\t1000\t1000\t1000";
        for (const char* whose :
             {"LAB Uid of core: ", "LAB Gid of core: ", "LAB Uid of guard: ", "LAB Gid of guard: "}) {
            std::size_t at = console.find(whose);
            EXPECT_NE(at, std::string::npos) << whose;
            for (; at != std::string::npos; at = console.find(whose, at + 1)) {
                EXPECT_EQ(console.compare(at + std::string{whose}.size(), carver.size(), carver), 0)
                    << console.substr(at, 60);
            }
        }
        EXPECT_GE(threads, 2 * 5)
            << "tick, planner, supervisor, estimator, and the guard, on two kinds of port";
        EXPECT_EQ(console.find(" stays: "), std::string::npos) << "limits took the place of all of them";
        for (const char* port : {kPpdev, kRawPort}) {
            const std::string words =
                std::string{"LAB tick after that on "} + port + ": priority 80, locked ";
            EXPECT_NE(console.find(words), std::string::npos) << console;
            EXPECT_EQ(console.find(words + "0 kB"), std::string::npos);
        }
    }
    Lab lab_;
    std::size_t first_write_awake_ = 0;
    std::size_t last_write_awake_ = 0;
};

// One boot for everything: it is what takes the time.
TEST_F(Hardware, ARealKernelsDriversBringExactlyTheJobsPulsesToThePins) {
    const std::vector<Pulse> wanted = pulses_of_the_simulated_run(coarse_job(2));
    ASSERT_GT(wanted.size(), 100U);
    lab_.boot(port_);
    ASSERT_TRUE(lab_.wait_for("LAB begin ppdev", kBootLimit)) << lab_.console();
    const std::size_t drivers_writes = port_.state().write_count.load();
    ASSERT_NO_FATAL_FAILURE(watch_sleep());
    ASSERT_NO_FATAL_FAILURE(expect_safe_after_death(kPpdev));
    port_.state().status_flip.store(0);
    ASSERT_NO_FATAL_FAILURE(expect_safe_after_death(kRawPort));
    // Somewhere in the long job: its pulses are many more than homing and approach take.
    const std::uint64_t estop_pulse = flip_after(wanted.size() * 2, kEstopStatusBit);
    port_.state().status_flip.store(0);
    ASSERT_TRUE(lab_.wait_for("LAB emergency stop is pressed", kRunLimit)) << lab_.console();
    // The axes of the tick that was under way.
    EXPECT_GE(port_.state().pulse_count.load(), estop_pulse);
    EXPECT_LT(port_.state().pulse_count.load() - estop_pulse, kAxisCount);
    const std::uint64_t limit_pulse = flip_after(wanted.size() * 2, kR2LimitBit);
    port_.state().status_flip.store(0);
    ASSERT_TRUE(lab_.wait_for("LAB begin refusals", kRunLimit)) << lab_.console();
    // A tick more: the limit's filter.
    EXPECT_GE(port_.state().pulse_count.load(), limit_pulse);
    EXPECT_LT(port_.state().pulse_count.load() - limit_pulse, 2 * kAxisCount);
    const std::size_t runs_writes = port_.state().write_count.load();
    EXPECT_TRUE(lab_.wait_for("LAB over", kRunLimit)) << lab_.console();
    EXPECT_TRUE(lab_.wait_for_end(seconds{60}));
    const std::string console = lab_.console();
    EXPECT_EQ(console.find("LAB failed"), std::string::npos) << console;
    EXPECT_NE(console.find("realtime 1 device /dev/parport0"), std::string::npos) << console;
    for (const char* said : {"psicarve-rtcore: /dev/parport0: can do SPP, EPP; plain register access",
                             "psicarve-rtcore: port at 0x378: claimed from the kernel's driver, can do SPP, "
                             "EPP; plain register access"}) {
        EXPECT_NE(console.find(said), std::string::npos) << said << '\n' << console;
    }
    EXPECT_NE(console.find("LAB end of run on ppdev:/dev/parport0: ready"), std::string::npos) << console;
    expect_no_alarm_by_the_clock(console.substr(0, console.find("LAB begin io")));
    EXPECT_NE(console.find("LAB end of run on io:0x378: ready"), std::string::npos) << console;
    EXPECT_NE(console.find("LAB end of run on ppdev:/dev/parport0: alarm"), std::string::npos) << console;
    EXPECT_NE(console.find("in alarm (emergency stop"), std::string::npos) << console;
    const std::size_t limited = console.find("LAB begin limit");
    EXPECT_NE(console.find("LAB end of run on ppdev:/dev/parport0: alarm", limited), std::string::npos)
        << console;
    EXPECT_NE(console.find("in alarm (limit of r2", limited), std::string::npos) << console;
    EXPECT_NE(console.find("LAB refusal psicarve-rtcore: --port io:0x2f8"), std::string::npos) << console;
    for (const char* second : {"LAB second ", "LAB third "}) {
        const std::size_t said = console.find(second);
        ASSERT_NE(said, std::string::npos) << console;
        EXPECT_NE(console.find("busy: psicarve-guard (pid ", said), std::string::npos) << console;
    }

    expect_no_privileges(console);
    expect_slept(console);
    for (const char* port : {kPpdev, kRawPort}) expect_soon_safe(console, port);

    const auto all_writes = port_.writes();
    ASSERT_LE(runs_writes, all_writes.size());
    const std::vector<fake_port::Write> writes(
        all_writes.begin() + static_cast<std::ptrdiff_t>(drivers_writes),
        all_writes.begin() + static_cast<std::ptrdiff_t>(runs_writes));
    expect_no_burst_after_sleep(fake_port::levels_of(all_writes, profile_));
    const auto runs = fake_port::runs_with_spindle(fake_port::levels_of(writes, profile_));
    ASSERT_EQ(runs.size(), 2 * kRuns) << console;
    // What the kernel's claiming does to the lines until our first write: docs/hardware.md.
    const std::vector<Pulse> claiming{{static_cast<std::uint8_t>(index_of(Axis::y)), false}};
    for (std::size_t run = 0; run < kRuns; ++run) EXPECT_EQ(runs[2 * run], claiming) << run;
    EXPECT_EQ(runs[1], wanted) << "through ppdev, the clock set forth and back";
    EXPECT_EQ(runs[3], wanted) << "through raw I/O";
    EXPECT_GT(runs[5].size(), 10U) << "until the computer slept";
    EXPECT_GT(runs[7].size(), 10U) << "until the core was killed on ppdev";
    EXPECT_GT(runs[9].size(), 10U) << "until it was killed on the raw port";
    EXPECT_LT(runs[11].size(), wanted.size() * 2) << "into the emergency stop";
    EXPECT_GT(runs[11].size(), 10U);
    EXPECT_LT(runs[13].size(), wanted.size() * 2) << "into the limit";
    EXPECT_GT(runs[13].size(), 10U);
    expect_safe_lines();
}

}  // namespace
}  // namespace psicarve::hardware
