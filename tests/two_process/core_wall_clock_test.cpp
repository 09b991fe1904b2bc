// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of the wall is set forth and back all the time: no burst, no gap, no lease that ends for it.
#include <cstdlib>

#include "shared/machine/jog_lease.hpp"
#include "tests/places.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

class CoreWallClock : public PortRig {
protected:
    void start_core_with_a_mad_clock() {
        {
            const fake_port::FakePortFile::Preload port{port_};
            const std::string both =
                std::string{std::getenv("LD_PRELOAD")} + ":" + in_build("tests/wall_clock_preload.so");
            setenv("LD_PRELOAD", both.c_str(), 1);
            core_ = std::make_unique<CoreProcess>(port_arguments(segment_name_), file("core.err"));
        }
        attach();
        ASSERT_TRUE(eventually([&] {
            core_pid_ = static_cast<pid_t>(segment_->core_pid().value_or(0));
            return core_pid_ != 0;
        })) << text_of(file("core.err"));
        const std::string maps = text_of("/proc/" + std::to_string(core_pid_) + "/maps");
        ASSERT_NE(maps.find("wall_clock_preload"), std::string::npos);
    }
};

TEST_F(CoreWallClock, SetForthAndBackChangesNoPulse) {
    home_where_it_stands();
    const std::vector<fake_port::Pulse> wanted = pulses_of_the_simulated_run(coarse_job(2));
    core_.reset();
    segment_.reset();
    ASSERT_TRUE(Segment::remove(segment_name_));
    start_core_with_a_mad_clock();
    home();
    ASSERT_EQ(publish(coarse_job(2)), "");
    start_carving();
    ASSERT_TRUE(
        eventually([&] { return status().job_end_tick != 0 || status().state == MachineState::alarm; }));
    EXPECT_EQ(status().state, MachineState::ready) << name_of(status().alarm_cause);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
    const auto writes = port_.writes();
    EXPECT_EQ(fake_port::pulses_with_spindle(fake_port::levels_of(writes, profile_)), wanted);
    // Nor did a tick come before its time, as it would if a deadline followed a step backwards.
    const double ran_s = static_cast<double>(writes.back().time_ns - writes.front().time_ns) * 1e-9;
    const CoreStatus end = load_words<CoreStatus>(segment_->header().status.words);
    EXPECT_LE(static_cast<double>(end.tick) * 1e-3, ran_s + 0.1);
    EXPECT_GE(static_cast<double>(end.tick) * 1e-3, ran_s - 1.0);
}

}  // namespace
}  // namespace psicarve::two_process
