// SPDX-License-Identifier: GPL-3.0-or-later
// Two judges of the same physics, written apart: the verifier's rule 3 and the simulated machine's motors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "hmi/verify/motor/train_follower.hpp"
#include "rtcore/sim/motor.hpp"
#include "tests/hmi/verify/exact_motion.hpp"

namespace psicarve {
namespace {

using verify::MotorLimits;
using verify::TrainEvent;

constexpr MotorLimits kMachines[]{{1e6, 48'000, 2'000}, {40'000, 4'000, 400}, {20'000, 2'000, 400}};

/// A motor with nothing to spare.
sim::Motor motor_of(const MotorLimits& limits) {
    return sim::Motor(
        {.speed_pps = limits.speed_pps, .accel_pps2 = limits.accel_pps2, .start_stop_pps = limits.jump_pps},
        0);
}

bool is_accepted(const std::vector<TrainEvent>& events, const MotorLimits& limits) {
    verify::TrainFollower rule(limits, 0);
    for (const TrainEvent& event : events) {
        if (!rule.take(event)) return false;
    }
    return events.empty() || rule.wait(events.back().time_ns + kNsPerS);
}

int stalls(const std::vector<TrainEvent>& events, const MotorLimits& limits) {
    sim::Motor motor = motor_of(limits);
    int count = 0;
    for (const TrainEvent& event : events) {
        const int sign = event.kind == TrainEvent::Kind::forward ? 1 : -1;
        count += motor.pulse(sign, event.time_ns) == sim::Motor::Outcome::fell_out_of_step ? 1 : 0;
    }
    return count + (motor.settle() ? 1 : 0);
}

/// Wanders between speeds with accelerations that are mostly all the motor has, now and then more.
class Wander {
public:
    Wander(const MotorLimits& limits, double most_ratio, std::uint32_t seed)
        : limits_(limits), most_ratio_(most_ratio), random_(seed) {}

    /// Speed after a step of time.
    double step(double time_s) {
        if (left_s_ <= 0.0) choose();
        left_s_ -= time_s;
        speed_pps_ = std::clamp(speed_pps_ + accel_pps2_ * time_s, -limits_.speed_pps, limits_.speed_pps);
        return speed_pps_;
    }

private:
    void choose() {
        std::uniform_real_distribution<double> part(0.0, 1.0);
        accel_pps2_ = limits_.accel_pps2 * most_ratio_ * (part(random_) < 0.5 ? -1.0 : 1.0);
        if (part(random_) < 0.2) accel_pps2_ = 0.0;
        left_s_ = limits_.speed_pps / limits_.accel_pps2 * part(random_);
    }

    MotorLimits limits_;
    double most_ratio_;
    std::mt19937 random_;
    double speed_pps_ = 0.0;
    double accel_pps2_ = 0.0;
    double left_s_ = 0.0;
};

std::vector<TrainEvent> wandering(const MotorLimits& limits, double most_ratio, std::uint32_t seed) {
    Wander wander(limits, most_ratio, seed);
    const double duration_s = 20.0 * limits.speed_pps / limits.accel_pps2;
    const verify::PulseMaker maker{.tick_ns = 10'000, .jitter_pulses = 0.3, .seed = seed};
    double position = 0.0;
    return verify::pulses_of(
        [&](double time_s) {
            if (time_s > 0.0)
                position += wander.step(seconds_from_ns(maker.tick_ns)) * seconds_from_ns(maker.tick_ns);
            return position;
        },
        duration_s, maker);
}

TEST(RuleAndMotor, WhatTheRuleAcceptsNeverStallsAMotorWithTheSameLimits) {
    int accepted = 0;
    for (const MotorLimits& limits : kMachines) {
        for (std::uint32_t seed = 1; seed <= 50; ++seed) {
            const double most_ratio = 0.8 + 0.008 * seed;  // up to 1.2
            const auto events = wandering(limits, most_ratio, seed);
            // It ends at speed: only the part before that is a motion that a motor can make.
            verify::TrainFollower rule(limits, 0);
            const bool is_good = std::all_of(events.begin(), events.end(),
                                             [&](const TrainEvent& event) { return rule.take(event); });
            if (!is_good) continue;
            ++accepted;
            sim::Motor motor = motor_of(limits);
            for (const TrainEvent& event : events) {
                const int sign = event.kind == TrainEvent::Kind::forward ? 1 : -1;
                ASSERT_EQ(motor.pulse(sign, event.time_ns), sim::Motor::Outcome::followed)
                    << "seed " << seed << ", " << limits.speed_pps << " pulses/s, at " << event.time_ns
                    << " ns";
            }
        }
    }
    EXPECT_GT(accepted, 60);
}

TEST(RuleAndMotor, RampsAtTheLimitsNeverStallAMotorWithTheSameLimits) {
    for (const MotorLimits& limits : kMachines) {
        for (std::uint32_t seed = 1; seed <= 20; ++seed) {
            const verify::RampMotion ramp{limits.jump_pps, limits.speed_pps, limits.accel_pps2};
            const auto events =
                verify::pulses_of(ramp, ramp.end_s() + 0.01,
                                  {.phase_pulses = 0.05 * seed - 0.5, .jitter_pulses = 0.3, .seed = seed});
            ASSERT_TRUE(is_accepted(events, limits));
            EXPECT_EQ(stalls(events, limits), 0) << limits.speed_pps << " pulses/s, seed " << seed;
        }
    }
}

TEST(RuleAndMotor, HalfAsMuchAccelerationAgainStallsTheMotorAndBreaksTheRule) {
    for (const MotorLimits& limits : kMachines) {
        for (std::uint32_t seed = 1; seed <= 20; ++seed) {
            const verify::RampMotion ramp{limits.jump_pps, limits.speed_pps, 1.5 * limits.accel_pps2};
            const auto events =
                verify::pulses_of(ramp, ramp.end_s() + 0.01,
                                  {.phase_pulses = 0.05 * seed - 0.5, .jitter_pulses = 0.3, .seed = seed});
            EXPECT_FALSE(is_accepted(events, limits));
            EXPECT_GE(stalls(events, limits), 1) << limits.speed_pps << " pulses/s, seed " << seed;
        }
    }
}

}  // namespace
}  // namespace psicarve
