// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/axis_unit.hpp"

#include <gtest/gtest.h>

#include "rtcore/sim/sim_config.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::sim {
namespace {

// The default profile's driver: 5 us setup, 5 us hold, 10 us high, 10 us low.
constexpr std::int64_t kSetup_ns = 5'000;
constexpr std::int64_t kHold_ns = 5'000;
constexpr std::int64_t kHigh_ns = 10'000;
constexpr std::int64_t kLow_ns = 10'000;
constexpr std::int64_t kRest_ns = 5'000'000;

class AxisUnitTest : public testing::TestWithParam<Axis> {
protected:
    AxisUnitTest() {
        sut_.set_enabled(true);
        sut_.set_direction(true, 0);
        now_ns_ = kRest_ns;
    }
    void good_pulse() {
        sut_.step_rises(now_ns_);
        sut_.step_falls(now_ns_ += kHigh_ns);
        now_ns_ += kRest_ns;
    }
    std::int64_t moved() const { return sut_.position_pulses() - config_.start_pulses; }

    SimConfig whole_ = sim_config_from_profile(Profile{});
    AxisConfig config_ = whole_.axis(GetParam());
    AxisUnit sut_{config_, whole_.timing};
    std::int64_t now_ns_ = 0;
};

INSTANTIATE_TEST_SUITE_P(EachAxis, AxisUnitTest, testing::ValuesIn(kAllAxes),
                         [](const auto& named) { return std::string{name_of(named.param)}; });

TEST_P(AxisUnitTest, TakesPulsesAtExactlyTheDriversTimes) {
    sut_.set_direction(false, now_ns_);
    now_ns_ += kSetup_ns;
    sut_.step_rises(now_ns_);
    sut_.step_falls(now_ns_ += kHigh_ns);
    sut_.step_rises(now_ns_ += kLow_ns);
    sut_.set_direction(true, now_ns_ + kHold_ns);
    sut_.step_falls(now_ns_ + kHigh_ns);
    EXPECT_EQ(moved(), -2);
    EXPECT_EQ(sut_.report().timing_lost(), 0U);
    EXPECT_EQ(sut_.report().pulses_taken, 2U);
}

TEST_P(AxisUnitTest, LosesExactlyThePulseThatComesTooSoonAfterItsDirection) {
    good_pulse();
    sut_.set_direction(false, now_ns_);
    now_ns_ += kSetup_ns - 1;
    good_pulse();
    EXPECT_EQ(moved(), 1);
    good_pulse();
    EXPECT_EQ(moved(), 0);
    EXPECT_EQ(sut_.report().lost_dir_setup, 1U);
    EXPECT_EQ(sut_.report().timing_lost(), 1U);
    EXPECT_EQ(sut_.report().pulses_taken, 2U);
}

TEST_P(AxisUnitTest, LosesExactlyThePulseWhoseDirectionIsNotHeld) {
    good_pulse();
    sut_.step_rises(now_ns_);
    EXPECT_EQ(moved(), 2);
    sut_.set_direction(false, now_ns_ + kHold_ns - 1);
    EXPECT_EQ(moved(), 1);
    sut_.step_falls(now_ns_ += kHigh_ns);
    now_ns_ += kRest_ns;
    good_pulse();
    EXPECT_EQ(moved(), 0);
    EXPECT_EQ(sut_.report().lost_dir_hold, 1U);
    EXPECT_EQ(sut_.report().timing_lost(), 1U);
}

TEST_P(AxisUnitTest, LosesExactlyThePulseThatIsTooShort) {
    sut_.step_rises(now_ns_);
    sut_.step_falls(now_ns_ += kHigh_ns - 1);
    now_ns_ += kRest_ns;
    EXPECT_EQ(moved(), 0);
    good_pulse();
    EXPECT_EQ(moved(), 1);
    EXPECT_EQ(sut_.report().lost_step_high, 1U);
    EXPECT_EQ(sut_.report().timing_lost(), 1U);
}

TEST_P(AxisUnitTest, LosesExactlyThePulseThatFollowsTooSoon) {
    sut_.step_rises(now_ns_);
    sut_.step_falls(now_ns_ += kHigh_ns);
    now_ns_ += kLow_ns - 1;
    good_pulse();
    EXPECT_EQ(moved(), 1);
    good_pulse();
    EXPECT_EQ(moved(), 2);
    EXPECT_EQ(sut_.report().lost_step_low, 1U);
    EXPECT_EQ(sut_.report().timing_lost(), 1U);
}

TEST_P(AxisUnitTest, CountsAPulseWithTwoFaultsOnce) {
    sut_.set_direction(false, now_ns_);
    sut_.step_rises(now_ns_);
    sut_.step_falls(now_ns_ + 1);
    EXPECT_EQ(sut_.report().timing_lost(), 1U);
    EXPECT_EQ(moved(), 0);
}

TEST_P(AxisUnitTest, IgnoresPulsesWhileDisabled) {
    sut_.set_enabled(false);
    for (int i = 0; i < 3; ++i) good_pulse();
    sut_.set_enabled(true);
    good_pulse();
    EXPECT_EQ(moved(), 1);
    EXPECT_EQ(sut_.report().pulses_ignored, 3U);
    EXPECT_EQ(sut_.report().pulses_taken, 1U);
}

TEST_P(AxisUnitTest, CrossesItsBacklashBeforeTheLoadTurnsBack) {
    config_.backlash_pulses = 3;
    sut_ = AxisUnit(config_, whole_.timing);
    sut_.set_enabled(true);
    sut_.set_direction(true, now_ns_);
    now_ns_ += kRest_ns;
    for (int i = 0; i < 4; ++i) good_pulse();
    EXPECT_EQ(moved(), 4);
    sut_.set_direction(false, now_ns_);
    now_ns_ += kRest_ns;
    for (int i = 0; i < 3; ++i) good_pulse();
    EXPECT_EQ(moved(), 4);
    for (int i = 0; i < 2; ++i) good_pulse();
    EXPECT_EQ(moved(), 2);
    EXPECT_EQ(sut_.report().motor_pulses - config_.start_pulses, -1);
}

class LinearAxisTest : public AxisUnitTest {};
INSTANTIATE_TEST_SUITE_P(EachAxis, LinearAxisTest, testing::Values(Axis::r1, Axis::r2, Axis::y),
                         [](const auto& named) { return std::string{name_of(named.param)}; });

TEST_P(LinearAxisTest, StopsDeadAtItsMechanicalEnds) {
    config_.start_pulses = config_.high_end_pulses - 2;
    sut_ = AxisUnit(config_, whole_.timing);
    sut_.set_enabled(true);
    sut_.set_direction(true, now_ns_);
    now_ns_ += kRest_ns;
    for (int i = 0; i < 5; ++i) good_pulse();
    EXPECT_EQ(sut_.position_pulses(), config_.high_end_pulses);
    EXPECT_EQ(sut_.report().crashes, 1U);
    EXPECT_EQ(sut_.report().pulses_lost_at_stop, 3U);
    sut_.set_direction(false, now_ns_);
    now_ns_ += kRest_ns;
    good_pulse();
    EXPECT_EQ(sut_.position_pulses(), config_.high_end_pulses - 1);

    config_.start_pulses = config_.low_end_pulses;
    sut_ = AxisUnit(config_, whole_.timing);
    sut_.set_enabled(true);
    sut_.set_direction(false, now_ns_);
    now_ns_ += kRest_ns;
    good_pulse();
    EXPECT_EQ(sut_.position_pulses(), config_.low_end_pulses);
    EXPECT_EQ(sut_.report().crashes, 1U);
}

}  // namespace
}  // namespace psicarve::sim
