// SPDX-License-Identifier: GPL-3.0-or-later
// A core that is kept from its processor for a while: what it missed is counted and gone.
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <array>
#include <ctime>

#include "tests/two_process/child_process.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

constexpr std::int64_t kPause_ms = 50;

std::int64_t now_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

class CoreStarved : public PortRig {
protected:
    /// A rotor that may coast for so long has lost no step.
    void set_coast_s(double coast_s) {
        for (LinearAxisProfile* axis : {&profile_.r1, &profile_.r2, &profile_.y}) {
            axis->start_stop_mm_s = 1.0 / coast_s / axis->pulses_per_mm;
        }
        profile_.psi.start_stop_deg_s = 360.0 / coast_s / static_cast<double>(profile_.psi.pulses_per_rev);
        write_profile();
    }
    void carve(const std::vector<std::string>& more = {}) {
        home_where_it_stands();
        const fake_port::FakePortFile::Preload preload{port_};
        std::vector<std::string> arguments = port_arguments(segment_name_);
        arguments.insert(arguments.end(), more.begin(), more.end());
        core_ = std::make_unique<CoreProcess>(arguments, file("core.err"));
        attach();
        ASSERT_TRUE(eventually([&] {
            core_pid_ = static_cast<pid_t>(segment_->core_pid().value_or(0));
            return core_pid_ != 0;
        })) << text_of(file("core.err"));
        home();
        for (const Axis axis : kAllAxes) offset_pulses_[index_of(axis)] = off_pulses(axis, status());
        ASSERT_EQ(publish(coarse_job(40)), "");
        start_carving();
        ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    }
    /// How far what the cable has counted is from what the core has.
    std::int64_t off_pulses(Axis axis, const CoreStatus& now) {
        return port_.state().axes[index_of(axis)].position_pulses.load() -
               now.position_pulses[index_of(axis)];
    }
    /// The core is stopped, and goes on.
    void pause(std::int64_t pause_ms) const {
        kill(core_pid_, SIGSTOP);
        std::this_thread::sleep_for(milliseconds{pause_ms});
        kill(core_pid_, SIGCONT);
    }
    /// The most pulses that one axis got in any time of this length.
    std::size_t most_pulses_within(std::uint64_t window_ns) const {
        const auto writes = port_.writes();
        const auto levels = fake_port::levels_of(writes, profile_);
        std::size_t most = 0;
        for (const Axis axis : kAllAxes) {
            std::vector<std::uint64_t> rose_ns;
            for (std::size_t i = 1; i < levels.size(); ++i) {
                if ((levels[i] & ~levels[i - 1] & bit_of(step_of(axis))) != 0)
                    rose_ns.push_back(writes[i].time_ns);
            }
            for (std::size_t first = 0, i = 0; i < rose_ns.size(); ++i) {
                while (rose_ns[i] - rose_ns[first] > window_ns) ++first;
                most = std::max(most, i - first + 1);
            }
        }
        return most;
    }
    /// No axis got more pulses in a pause's time than ticks can hold: a burst would have that many in one.
    void expect_no_burst() {
        constexpr std::uint64_t kWindow_ns = 10'000'000;
        // Two ticks of a millisecond make a pulse. A late tick and one in time may both fall into the window.
        EXPECT_LE(most_pulses_within(kWindow_ns), 10U / 2U + 2U);
    }
    void expect_whole_carving() {
        EXPECT_EQ(status().state, MachineState::carving) << name_of(status().alarm_cause);
        ASSERT_EQ(refusal_of(CommandKind::hold), "");
        ASSERT_TRUE(reaches(MachineState::held));
        const CoreStatus now = status();
        EXPECT_EQ(now.homed_mask, 0xF);
        for (const Axis axis : kAllAxes) {
            const std::int64_t off = off_pulses(axis, now) - offset_pulses_[index_of(axis)];
            EXPECT_EQ(axis == Axis::psi ? off % profile_.psi.pulses_per_rev : off, 0) << name_of(axis);
        }
    }
    /// When it was homed, where it stood.
    std::array<std::int64_t, kAxisCount> offset_pulses_{};
};

TEST_F(CoreStarved, StoppedForFiftyMillisecondsWhileCarvingItCountsThemAndMakesNoBurst) {
    set_coast_s(0.5);
    ASSERT_NO_FATAL_FAILURE(carve());
    for (int round = 0; round < 5; ++round) {
        const std::uint64_t missed = status().missed_ticks;
        pause(kPause_ms);
        // All but the tick in which it was stopped and the one in which it came back.
        ASSERT_TRUE(
            eventually([&] { return status().missed_ticks >= missed + std::uint64_t{kPause_ms} - 2; }));
        std::this_thread::sleep_for(milliseconds{30});
    }
    expect_whole_carving();
    expect_no_burst();
}

TEST_F(CoreStarved, StoppedLongerThanARotorCoastsItIsInAlarmAndMovesNoMore) {
    set_coast_s(0.1);
    ASSERT_NO_FATAL_FAILURE(carve());
    pause(200);
    ASSERT_TRUE(reaches(MachineState::alarm));
    EXPECT_EQ(status().alarm_cause, AlarmCause::tick_gap);
    EXPECT_NE(status().homed_mask, 0xF) << "what moved has lost its position";
    const std::uint64_t pulses = pulses_on_the_cable();
    std::this_thread::sleep_for(milliseconds{kPause_ms});
    EXPECT_EQ(pulses_on_the_cable(), pulses);
    expect_safe_registers_but_directions();
    expect_no_burst();
}

std::optional<int> last_allowed_cpu() {
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return std::nullopt;
    for (int cpu = CPU_SETSIZE - 1; cpu >= 0; --cpu) {
        if (CPU_ISSET(cpu, &allowed)) return cpu;
    }
    return std::nullopt;
}

/// Takes the processor from all threads below priority 20; false when that is not allowed.
bool hog(int cpu, std::int64_t time_ms) {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(cpu, &one);
    const sched_param above{.sched_priority = 20};
    if (sched_setaffinity(0, sizeof one, &one) != 0) return false;
    if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &above) != 0) return false;
    const std::int64_t end_ns = now_ns() + time_ms * 1'000'000;
    while (now_ns() < end_ns) {
    }
    return true;
}

TEST_F(CoreStarved, ABusyLoopOnItsProcessorIsCountedAndMakesNoBurst) {
    const auto cpu = last_allowed_cpu();
    ASSERT_TRUE(cpu);
    set_coast_s(0.5);
    ASSERT_NO_FATAL_FAILURE(carve({"--cpu", std::to_string(*cpu), "--priority", "10"}));
    for (int round = 0; round < 5; ++round) {
        const std::uint64_t missed = status().missed_ticks;
        test::ChildProcess busy{
            [&](const test::ChildProcess::Signal& /*began*/) { ::_exit(hog(*cpu, kPause_ms) ? 0 : 2); }};
        if (busy.exit_code() == 2) GTEST_SKIP() << "needs the right to SCHED_FIFO, to starve anybody";
        // The kernel may keep a part of the time for others (sched_rt_runtime_us).
        ASSERT_TRUE(
            eventually([&] { return status().missed_ticks >= missed + std::uint64_t{kPause_ms} / 2; }));
    }
    expect_whole_carving();
    expect_no_burst();
}

}  // namespace
}  // namespace psicarve::two_process
