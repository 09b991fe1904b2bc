// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/pulse_stage.hpp"

#include <gtest/gtest.h>

#include "rtcore/plan/cycle_config_from_profile.hpp"

namespace psicarve::cycle {
namespace {

constexpr std::uint32_t kR1 = 0b0001;
constexpr std::int64_t kSetup_ticks = 5;

CycleConfig config_with_setup() {
    CycleConfig config = plan::cycle_config_from_profile(Profile{});
    config.dir_setup_ticks = kSetup_ticks;
    return config;
}

TEST(PulseStage, ADriveThatWasJustSwitchedOnIsGivenItsSetupTime) {
    PulseStage sut{config_with_setup()};
    sut.begin_tick(100);
    sut.set_enables(0xF, 100);
    EXPECT_FALSE(sut.may_step(kR1, 100));
    EXPECT_FALSE(sut.may_step(kR1, 100 + kSetup_ticks - 1));
    EXPECT_TRUE(sut.may_step(kR1, 100 + kSetup_ticks));
}

TEST(PulseStage, ADirectionThatTurnedIsGivenItsSetupTimeAndNoOtherAxisWaits) {
    PulseStage sut{config_with_setup()};
    sut.set_enables(0xF, 0);
    sut.begin_tick(100);
    ASSERT_TRUE(sut.may_step(kR1, 100));
    sut.want_directions({1, 0, 0, 0}, 100);
    EXPECT_FALSE(sut.may_step(kR1, 100 + kSetup_ticks - 1));
    EXPECT_TRUE(sut.may_step(kR1, 100 + kSetup_ticks));
    EXPECT_TRUE(sut.may_step(kR1 << 1U, 100));
}

}  // namespace
}  // namespace psicarve::cycle
