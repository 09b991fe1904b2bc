// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/motor.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "rtcore/sim/sim_config.hpp"
#include "shared/profile/profile.hpp"
#include "tests/places.hpp"
#include "tests/rtcore/sim/pulse_train.hpp"

namespace psicarve::sim {
namespace {

constexpr std::uint32_t kSeeds = 20;
constexpr double kDdaJitter_pulses = 0.5;

struct Case {
    const char* name;
    double pulses_per_mm;
    double speed_mm_s;
    double accel_mm_s2;
    double start_stop_mm_s;
    std::int64_t tick_ns;
};
void PrintTo(const Case& value, std::ostream* out) {
    *out << value.name;
}

Profile profile_of(const Case& value) {
    Profile profile;
    profile.r1.pulses_per_mm = value.pulses_per_mm;
    profile.r1.speed_mm_s = value.speed_mm_s;
    profile.r1.accel_mm_s2 = value.accel_mm_s2;
    profile.r1.start_stop_mm_s = value.start_stop_mm_s;
    return profile;
}

struct Ride {
    int pulses = 0;
    int lost = 0;
    int stalls = 0;
    std::int64_t end = 0;
};

Ride ride(Motor& motor, const std::vector<std::int64_t>& times, int sign = 1) {
    Ride result;
    for (const std::int64_t time_ns : times) {
        const Motor::Outcome outcome = motor.pulse(sign, time_ns);
        ++result.pulses;
        result.lost += outcome == Motor::Outcome::lost ? 1 : 0;
        result.stalls += outcome == Motor::Outcome::fell_out_of_step ? 1 : 0;
    }
    result.stalls += motor.settle() ? 1 : 0;
    result.end = motor.position_pulses();
    return result;
}

class MotorTest : public testing::TestWithParam<Case> {
protected:
    AxisMotion limits_ = axis_motion(profile_of(GetParam()), Axis::r1);
    MotorConfig config_ = sim_config_from_profile(profile_of(GetParam())).axis(Axis::r1).motor;
    std::int64_t tick_ns_ = GetParam().tick_ns;
};

INSTANTIATE_TEST_SUITE_P(EachMachine, MotorTest,
                         testing::Values(Case{"default at 50 us", 400, 10, 100, 1, 50'000},
                                         Case{"default at 10 us", 400, 10, 100, 1, 10'000},
                                         Case{"8 kHz at 50 us", 400, 20, 200, 2, 50'000},
                                         Case{"fine at 10 us", 4000, 12, 500, 5, 10'000},
                                         Case{"sluggish at 50 us", 400, 2.5, 12, 0.25, 50'000},
                                         Case{"two-timer", 400, 2.25, 22, 0.22, 500'000}),
                         [](const auto& case_info) { return "n" + std::to_string(case_info.index); });

TEST_P(MotorTest, NeverStallsAtTheProfilesOwnLimits) {
    for (const double length : {3.0, 20.0, 50.0, 200.0, 1000.0, 10'000.0}) {
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
            const Trapezoid move{limits_.start_stop_pps, limits_.speed_pps, limits_.accel_pps2, length};
            Motor sut(config_, 0);
            const Ride there = ride(sut, pulse_times(move, tick_ns_, kDdaJitter_pulses, seed));
            ASSERT_EQ(there.stalls, 0) << length << " pulses, seed " << seed;
            ASSERT_EQ(there.end, there.pulses);
        }
    }
}

TEST_P(MotorTest, NeverStallsWhenItTurnsAtStartStopSpeed) {
    const Trapezoid move{limits_.start_stop_pps, limits_.speed_pps, limits_.accel_pps2, 500.0};
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        Motor sut(config_, 0);
        std::int64_t begin_ns = 0;
        for (int turn = 0; turn < 6; ++turn) {
            const auto times = pulse_times(move, tick_ns_, kDdaJitter_pulses, seed + 100U, begin_ns);
            for (const std::int64_t time_ns : times) {
                ASSERT_EQ(sut.pulse(turn % 2 == 0 ? 1 : -1, time_ns), Motor::Outcome::followed)
                    << "turn " << turn << ", seed " << seed;
            }
            begin_ns = times.back() + 2 * tick_ns_;
        }
        EXPECT_FALSE(sut.settle());
        EXPECT_EQ(sut.position_pulses(), 0);
    }
}

TEST_P(MotorTest, StallsWhenAskedForThirtyPercentTooMuchSpeed) {
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const Trapezoid move{limits_.start_stop_pps, 1.3 * config_.speed_pps, limits_.accel_pps2, 40'000.0};
        Motor sut(config_, 0);
        const Ride there = ride(sut, pulse_times(move, 1'000, kDdaJitter_pulses, seed));
        ASSERT_GE(there.stalls, 1) << "seed " << seed;
        ASSERT_LT(there.end, there.pulses);
    }
}

TEST_P(MotorTest, StallsWhenAskedForThirtyPercentTooMuchAcceleration) {
    // A motor that is fast enough for the ramp to last until the lag is there.
    config_.speed_pps = 20.0 * config_.start_stop_pps;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        const Trapezoid move{limits_.start_stop_pps, config_.speed_pps, 1.3 * config_.accel_pps2, 40'000.0};
        Motor sut(config_, 0);
        const Ride there = ride(sut, pulse_times(move, 1'000, kDdaJitter_pulses, seed));
        ASSERT_GE(there.stalls, 1) << "seed " << seed;
        ASSERT_LT(there.end, there.pulses);
    }
}

TEST_P(MotorTest, StallsWhenStartedAtTopSpeed) {
    config_.speed_pps = 20.0 * config_.start_stop_pps;
    const Trapezoid move{config_.speed_pps, config_.speed_pps, 1.0, 40'000.0};
    Motor sut(config_, 0);
    EXPECT_GE(ride(sut, pulse_times(move, 1'000, 0.0, 1)).stalls, 1);
}

TEST(Motor, NoAxisOfAnExampleStallsAtItsProfilesLimits) {
    for (const char* const name : {"original.toml", "fine.toml"}) {
        const Profile profile = load_profile(example(name)).value();
        const SimConfig machine = sim_config_from_profile(profile);
        for (const Axis axis : kAllAxes) {
            const AxisMotion limits = axis_motion(profile, axis);
            for (const double length : {30.0, 300.0, 3'000.0, 30'000.0}) {
                const Trapezoid move{limits.start_stop_pps, limits.speed_pps, limits.accel_pps2, length};
                const auto times = pulse_times(move, tick_period_ns(profile), kDdaJitter_pulses, 1);
                Motor sut(machine.axis(axis).motor, 0);
                const Ride there = ride(sut, times);
                EXPECT_EQ(there.stalls, 0) << name << ' ' << name_of(axis) << ", " << length << " pulses";
                EXPECT_EQ(there.end, there.pulses);
            }
        }
    }
}

Motor default_motor() {
    return Motor(sim_config_from_profile(Profile{}).axis(Axis::r1).motor, 0);
}

TEST(Motor, PullsInAgainOnceTheDemandIsSlow) {
    Motor sut = default_motor();
    std::int64_t time_ns = 0;
    int lost = 0;
    for (int i = 0; i < 400; ++i) {
        lost += sut.pulse(1, time_ns += 150'000) == Motor::Outcome::lost ? 1 : 0;
    }
    EXPECT_GT(lost, 300);
    const std::int64_t stuck = sut.position_pulses();
    for (int i = 0; i < 30; ++i) sut.pulse(1, time_ns += 4'000'000);
    EXPECT_GT(sut.position_pulses(), stuck + 20);
    const std::int64_t running = sut.position_pulses();
    for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(sut.pulse(1, time_ns += 4'000'000), Motor::Outcome::followed);
    }
    EXPECT_EQ(sut.position_pulses(), running + 10);
}

// A ramp of 2000 pulses/s2 ends at about 60 pulses/s; then a pulse a second, with a start-stop speed hardly
// above.
TEST(Motor, RestsBetweenTheLastPulseOfARampAndSlowOnes) {
    Motor sut({.speed_pps = 520.0, .accel_pps2 = 3000.0, .start_stop_pps = 1.3, .slip_pulses = 16.0}, 0);
    std::int64_t time_ns = 51'000'000;
    int stalls = 0;
    const auto pulse_after = [&](std::int64_t gap_ns) {
        time_ns += gap_ns;
        stalls += sut.pulse(1, time_ns) == Motor::Outcome::followed ? 0 : 1;
    };
    for (const std::int64_t gap_ms : {0, 13, 10, 8, 8, 6, 6, 6, 6, 7, 8, 9, 10, 15})
        pulse_after(gap_ms * 1'000'000);
    for (int i = 0; i < 20; ++i) pulse_after(1'000'000'000);
    EXPECT_EQ(stalls, 0);
    EXPECT_EQ(sut.position_pulses(), 34);
}

// As seen on the pins of a long carving: a few pulses up to 600 a second and down again, then a pause of 45
// ms.
TEST(Motor, RestsInAPauseThatFollowsAShortMove) {
    Motor sut({.speed_pps = 5200.0, .accel_pps2 = 60'000.0, .start_stop_pps = 520.0, .slip_pulses = 16.0}, 0);
    std::int64_t time_ns = 0;
    int stalls = 0;
    for (const std::int64_t gap_us :
         {0, 2300, 1900, 1700, 1650, 1900, 2400, 45'400, 1900, 3200, 1400, 1250}) {
        time_ns += gap_us * 1000;
        stalls += sut.pulse(1, time_ns) == Motor::Outcome::followed ? 0 : 1;
    }
    EXPECT_EQ(stalls, 0);
    EXPECT_EQ(sut.position_pulses(), 12);
}

TEST(Motor, RunsPastItsCountWhenPulsesEndAtFullSpeed) {
    const Trapezoid move{400, 4000, 40'000, 2000.0};
    std::vector<std::int64_t> times = pulse_times(move, 50'000, 0.0, 1);
    times.resize(1000);
    Motor sut = default_motor();
    const Ride there = ride(sut, times);
    EXPECT_EQ(there.stalls, 1);
    // v^2/2a at the motor's own deceleration: 4 000^2 / 120 000 = 133 pulses, less what start-stop saves.
    EXPECT_NEAR(static_cast<double>(there.end), 1000.0 + 131.0, 8.0);
}

TEST(Motor, FollowsAnySlowPulseHoweverIrregular) {
    std::mt19937 random(7);
    std::uniform_int_distribution<std::int64_t> gap_ns(2'600'000, 90'000'000);
    Motor sut = default_motor();
    std::int64_t time_ns = 0;
    std::int64_t expected = 0;
    for (int i = 0; i < 5000; ++i) {
        const int sign = random() % 2 == 0 ? 1 : -1;
        expected += sign;
        ASSERT_EQ(sut.pulse(sign, time_ns += gap_ns(random)), Motor::Outcome::followed) << i;
    }
    EXPECT_EQ(sut.position_pulses(), expected);
}

}  // namespace
}  // namespace psicarve::sim
