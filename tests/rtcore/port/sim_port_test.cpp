// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/sim_port.hpp"

#include <gtest/gtest.h>

#include "rtcore/sim/machine.hpp"
#include "rtcore/sim/sim_config.hpp"
#include "shared/profile/pin_map.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::port {
namespace {

constexpr std::int64_t kTick_ns = 50'000;

class SimPortTest : public testing::Test {
protected:
    static sim::SimConfig config() {
        sim::SimConfig config = sim::sim_config_from_profile(Profile{});
        config.axis(Axis::r1).start_pulses = config.axis(Axis::r1).sensor.edge_pulses - 2;
        return config;
    }
    sim::Machine machine_{config()};
    SimPort sut_{PinMap::from_profile(Profile{}).value(), machine_};
};

TEST_F(SimPortTest, PulsesMoveTheMachineAndItsSensorComesBack) {
    constexpr SignalWord kReady = bit_of(Signal::r1_enable) | bit_of(Signal::r1_dir);
    std::int64_t time_ns = 0;
    sut_.write_outputs(kReady, time_ns);
    EXPECT_EQ(sut_.read_inputs(time_ns), 0U);
    for (int pulse = 0; pulse < 2; ++pulse) {
        sut_.write_outputs(kReady | bit_of(Signal::r1_step), time_ns += 50 * kTick_ns);
        sut_.write_outputs(kReady, time_ns += kTick_ns);
    }
    EXPECT_EQ(sut_.read_inputs(time_ns), bit_of(Signal::r1_limit));
    EXPECT_EQ(machine_.position_pulses(Axis::r1), 24'001) << "one past the home position";
    EXPECT_TRUE(sut_.is_healthy());
}

TEST_F(SimPortTest, IgnoresInputBitsAmongTheOutputs) {
    sut_.write_outputs(kInputMask, 0);
    EXPECT_EQ(sut_.read_inputs(kTick_ns), 0U);
    EXPECT_EQ(machine_.report().spindle_starts, 0U);
}

}  // namespace
}  // namespace psicarve::port
