// SPDX-License-Identifier: GPL-3.0-or-later
// The real core's tick asks nothing of the kernel but its sleep: the kernel itself says so.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/mman.h>
#include <sys/syscall.h>

#include <cstdio>
#include <cstdlib>
#include <map>

#include "shared/computer/realtime_step.hpp"
#include "tests/places.hpp"
#include "tests/system_calls/tick_calls.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

using system_calls::TickCalls;

class CoreTickCalls : public PortRig {
protected:
    CoreTickCalls() {
        profile_.tick.period_us = 100.0;
        home_by_one_sensor();
        const int descriptor = open(file("calls").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        EXPECT_EQ(ftruncate(descriptor, sizeof(TickCalls)), 0);
        void* const address =
            mmap(nullptr, sizeof(TickCalls), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
        close(descriptor);
        EXPECT_NE(address, MAP_FAILED);
        calls_ = static_cast<TickCalls*>(address);
    }
    ~CoreTickCalls() override { munmap(calls_, sizeof(TickCalls)); }

    void start_watched_core(const std::vector<std::string>& arguments) {
        {
            const fake_port::FakePortFile::Preload port{port_};
            const std::string both =
                std::string{std::getenv("LD_PRELOAD")} + ":" + in_build("tests/tick_calls_preload.so");
            setenv("LD_PRELOAD", both.c_str(), 1);
            setenv(system_calls::kCallsVariable, file("calls").c_str(), 1);
            core_ = std::make_unique<CoreProcess>(arguments, file("core.err"));
            unsetenv(system_calls::kCallsVariable);
        }
        attach();
        ASSERT_TRUE(eventually([&] {
            core_pid_ = static_cast<pid_t>(segment_->core_pid().value_or(0));
            return core_pid_ != 0;
        })) << text_of(file("core.err"));
    }
    std::vector<std::string> traced_port_arguments() const {
        std::vector<std::string> arguments = port_arguments(segment_name_);
        arguments.insert(arguments.end(), {"--trace", file("pins.trace")});
        return arguments;
    }
    std::vector<std::string> traced_simulator_arguments() const {
        return {"--segment", segment_name_,        "--clock",    "real",   "--trace", file("pins.vcd"),
                "--profile", file("machine.toml"), "--capacity", "100x20", "--port",  "sim"};
    }
    void jog_until_its_lease_is_over() {
        Command jog{};
        jog.kind = CommandKind::jog_on;
        jog.axis = static_cast<std::uint32_t>(Axis::psi);
        jog.value = 1.0;
        jog.lease_token = 5;
        jog.lease_ms = 200;
        ASSERT_EQ(refusal_of(jog), "");
        ASSERT_TRUE(reaches(MachineState::ready));
        ASSERT_EQ(status().move_end, MoveEnd::lease_gone);
    }
    /// Whatever a tick may have to do.
    void work_through_a_day() {
        home();
        jog_until_its_lease_is_over();
        ASSERT_EQ(publish(coarse_job(40)), "");
        start_carving();
        ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
        ASSERT_EQ(refusal_of(CommandKind::override, 150.0), "");
        ASSERT_EQ(refusal_of(CommandKind::hold), "");
        ASSERT_TRUE(reaches(MachineState::held));
        ASSERT_EQ(refusal_of(CommandKind::resume), "");
        ASSERT_TRUE(eventually([&] { return status().tick > ticks_wanted(); }));
        request_emergency_stop(*segment_);
        ASSERT_TRUE(reaches(MachineState::alarm));
        ASSERT_EQ(status().alarm_cause, AlarmCause::emergency_stop);
        ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
        ASSERT_EQ(refusal_of(CommandKind::home), "");
    }
    /// These run on the real clock, so the suite takes little more than the work lasts; PSICARVE_LONG=1: a
    /// million, in two minutes.
    static std::uint64_t ticks_wanted() { return test::is_long_run() ? 1'000'000 : 22'000; }
    /// Calls by their numbers, without those that a tick may make.
    std::map<std::size_t, std::uint64_t> calls_but(const std::vector<long>& allowed) const {
        std::map<std::size_t, std::uint64_t> found;
        for (std::size_t number = 0; number < system_calls::kMostNumbers; ++number) {
            const std::uint64_t count = calls_->by_number[number].load();
            const bool is_allowed = std::ranges::find(allowed, static_cast<long>(number)) != allowed.end();
            if (count > 0 && !is_allowed) found[number] = count;
        }
        return found;
    }
    void expect_one_sleep_a_tick_and_nothing_else(const CoreStatus& before) const {
        const std::uint64_t ticks = before.tick - before.missed_ticks;
        const std::uint64_t sleeps = calls_->by_number[SYS_clock_nanosleep].load();
        EXPECT_GE(sleeps, ticks) << "each tick was seen";
        EXPECT_GT(ticks, 20'000U);
        std::printf("%llu ticks, %llu more missed: %llu sleeps\n", static_cast<unsigned long long>(ticks),
                    static_cast<unsigned long long>(before.missed_ticks),
                    static_cast<unsigned long long>(sleeps));
    }

    TickCalls* calls_ = nullptr;
};

TEST_F(CoreTickCalls, OnAPortNothingButItsSleepAndThePort) {
    start_watched_core(traced_port_arguments());
    work_through_a_day();
    ASSERT_EQ(calls_->threads_watched.load(), 1U);
    ASSERT_EQ(calls_->threads_unwatched.load(), 0U);
    expect_one_sleep_a_tick_and_nothing_else(status());
    // The port's accesses end in the preloaded library and never come to the kernel.
    EXPECT_THAT(calls_but({SYS_clock_nanosleep}), ::testing::IsEmpty());
    EXPECT_GT(pulses_on_the_cable(), 300U);
}

TEST_F(CoreTickCalls, OnTheSimulatorNothingButItsSleep) {
    start_watched_core(traced_simulator_arguments());
    work_through_a_day();
    ASSERT_EQ(calls_->threads_watched.load(), 1U);
    expect_one_sleep_a_tick_and_nothing_else(status());
    EXPECT_THAT(calls_but({SYS_clock_nanosleep}), ::testing::IsEmpty());
}

// Without a watcher here, since that has pages of its own.
TEST_F(CoreTickCalls, OnTheSimulatorNoPageFault) {
    if (test::kIsSanitized) GTEST_SKIP() << "a sanitizer's memory is not locked";
    // The kernel may move a page that lies in memory, and a thread that touches it then faults by no doing of
    // its own: a few at a time. What the tick itself does would be there in each of these runs.
    constexpr int kMostRuns = 3;
    CoreStatus end{};
    for (int runs = 1; runs <= kMostRuns; ++runs) {
        core_ = std::make_unique<CoreProcess>(traced_simulator_arguments(), file("core.err"));
        attach();
        ASSERT_TRUE(eventually([&] { return segment_->core_pid().has_value(); }));
        ASSERT_NO_FATAL_FAILURE(work_through_a_day());
        // The core reads the kernel's counts twice a second.
        const std::uint64_t tick = status().tick;
        ASSERT_TRUE(eventually([&] { return status().tick > tick + 10'000; }));
        end = status();
        EXPECT_GT(end.tick - end.missed_ticks, 20'000U);
        EXPECT_EQ(end.tick_major_faults, 0U);
        if (end.tick_minor_faults == 0) break;
        ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
        ASSERT_EQ(core_->wait_for_exit(), 0);
    }
    EXPECT_EQ(end.tick_minor_faults, 0U);
    // Where it may not be locked, it only happened to be there.
    const bool is_locked = (end.realtime_done & bit_of(RealtimeStep::lock_memory)) != 0;
    std::printf("memory %s\n", is_locked ? "locked" : "not locked: this user may not");
}

// The one schedule that may lock.
TEST_F(CoreTickCalls, WithTwoTimersTheLockThatTheyShareBesides) {
    profile_.tick.schedule = Schedule::two_timer;
    write_profile();
    start_watched_core(traced_port_arguments());
    work_through_a_day();
    ASSERT_EQ(calls_->threads_watched.load(), 2U);
    EXPECT_THAT(calls_but({SYS_clock_nanosleep, SYS_futex}), ::testing::IsEmpty());
}

}  // namespace
}  // namespace psicarve::two_process
