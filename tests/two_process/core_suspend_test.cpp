// SPDX-License-Identifier: GPL-3.0-or-later
// The computer sleeps while the machine works: no time passes for any program, but drives and port were
// without power meanwhile.
#include <cstdlib>

#include "tests/places.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

class CoreSuspend : public PortRig {
protected:
    CoreSuspend() { home_where_it_stands(); }
    void start_core_that_may_sleep() {
        {
            const fake_port::FakePortFile::Preload port{port_};
            const std::string both =
                std::string{std::getenv("LD_PRELOAD")} + ":" + in_build("tests/wall_clock_preload.so");
            setenv("LD_PRELOAD", both.c_str(), 1);
            setenv("PSICARVE_SUSPENDED", file("slept").c_str(), 1);
            core_ = std::make_unique<CoreProcess>(port_arguments(segment_name_), file("core.err"));
            unsetenv("PSICARVE_SUSPENDED");
        }
        attach();
        ASSERT_TRUE(eventually([&] {
            core_pid_ = static_cast<pid_t>(segment_->core_pid().value_or(0));
            return core_pid_ != 0;
        })) << text_of(file("core.err"));
    }
    /// Core and guard stand still, an hour goes by outside, and firmware leaves the port as it likes.
    void sleep_and_wake() {
        kill(core_->pid(), SIGSTOP);
        kill(core_pid_, SIGSTOP);
        port_.state().data.store(0xff);
        port_.state().control.store(0x04);  // the spindle's bit, and the inverted ones of Y's enable and step
        std::ofstream{file("slept")} << "an hour";
        kill(core_pid_, SIGCONT);
        kill(core_->pid(), SIGCONT);
    }
    void expect_alarm_and_a_safe_port() {
        ASSERT_TRUE(reaches(MachineState::alarm));
        EXPECT_EQ(status().alarm_cause, AlarmCause::tick_gap) << name_of(status().alarm_cause);
        EXPECT_EQ(status().homed_mask, 0) << "drives had no power: whoever stood there stands anywhere";
        ASSERT_TRUE(eventually([&] {
            return port_.state().control.load() == safe().control &&
                   (port_.state().data.load() & 0x3b) == (safe().data & 0x3b);
        })) << "steps, enables, spindle";
        const std::uint64_t pulses = pulses_on_the_cable();
        std::this_thread::sleep_for(milliseconds{50});
        EXPECT_EQ(pulses_on_the_cable(), pulses);
    }
};

TEST_F(CoreSuspend, WhileItCarvesIsAnAlarmWithoutPulsesAndNothingIsHomedAnyMore) {
    start_core_that_may_sleep();
    home();
    ASSERT_EQ(publish(coarse_job(40)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] { return status().points_done > 3; }));
    sleep_and_wake();
    expect_alarm_and_a_safe_port();
    ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    EXPECT_EQ(status().state, MachineState::off);
    EXPECT_NE(refusal_of(CommandKind::start), "") << "not before it is homed";
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
}

TEST_F(CoreSuspend, BeforeHomingThePortIsWrittenAnewThoughNothingWasToChange) {
    start_core_that_may_sleep();
    ASSERT_TRUE(eventually([&] { return status().tick > 10; }));
    sleep_and_wake();
    expect_alarm_and_a_safe_port();
}

TEST_F(CoreSuspend, AtRestIsAnAlarmToo) {
    start_core_that_may_sleep();
    home();
    sleep_and_wake();
    expect_alarm_and_a_safe_port();
    ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    EXPECT_EQ(status().state, MachineState::off);
}

}  // namespace
}  // namespace psicarve::two_process
