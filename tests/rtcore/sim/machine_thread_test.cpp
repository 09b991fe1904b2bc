// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/rtcore/sim/sim_rig.hpp"

namespace psicarve::sim {
namespace {

TEST(MachineThread, ReportMayBeReadWhileTheTickDrivesIt) {
    SimRig rig;
    rig.enable_all();
    rig.aim(Axis::psi, true);
    std::atomic<bool> done{false};
    std::thread tick([&] {
        rig.pulses(Axis::psi, 20'000);
        done = true;
    });
    std::int64_t last = -1'600;
    while (!done) {
        const std::int64_t position = rig.machine().report().axis(Axis::psi).position_pulses;
        EXPECT_GE(position, last);
        last = position;
    }
    tick.join();
    EXPECT_EQ(rig.machine().report().axis(Axis::psi).position_pulses, 18'400);
}

}  // namespace
}  // namespace psicarve::sim
