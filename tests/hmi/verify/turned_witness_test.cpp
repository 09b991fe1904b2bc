// SPDX-License-Identifier: GPL-3.0-or-later
// Rule 3's shortcuts on trains that stay at the edge of what is possible: the verdicts of the long way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "hmi/verify/motor/train_follower.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/verify/exact_motion.hpp"

namespace psicarve::verify {
namespace {

using Train = std::vector<TrainEvent>;

std::optional<std::size_t> by_shortcuts(const Train& train, const MotorLimits& limits) {
    TrainFollower sut(limits, 0);
    for (std::size_t i = 0; i < train.size(); ++i) {
        if (!sut.take(train[i])) return i;
    }
    return {};
}

std::optional<std::size_t> the_long_way(const Train& train, const MotorLimits& limits) {
    MotorReach reach(limits);
    std::int64_t count = 0;
    std::int64_t now_ns = 0;
    reach.start_anywhere(room_at(0));
    for (std::size_t i = 0; i < train.size(); ++i) {
        if (train[i].time_ns > now_ns)
            reach.run(seconds_from_ns(train[i].time_ns - std::exchange(now_ns, train[i].time_ns)),
                      room_at(count));
        if (train[i].kind == TrainEvent::Kind::joint) {
            reach.jump();
        } else {
            const std::int64_t next = train[i].count_after(count);
            reach.cut(room_between(std::exchange(count, next), next));
        }
        if (reach.is_empty()) return i;
    }
    return {};
}

class Dice {
public:
    explicit Dice(std::uint32_t seed) : random_(seed) {}
    double part() { return part_(random_); }
    std::uint32_t number() { return static_cast<std::uint32_t>(random_()); }

private:
    std::mt19937 random_;
    std::uniform_real_distribution<double> part_{0.0, 1.0};
};

/// Up a ramp and along, then joints while the axis stands, then slowly back: a fast motion may pass the
/// room's edge between them, and is none any more.
Train joints_at_the_edge(MotorLimits& limits, std::uint32_t seed) {
    Dice dice(seed);
    limits.accel_pps2 = std::pow(10.0, 4.3 + 1.7 * dice.part());
    limits.speed_pps = 40'000.0;
    limits.jump_pps = 300.0 + 2'500.0 * dice.part();
    Train train;
    double time_ns = 0.0;
    const auto add = [&](double after_s, TrainEvent::Kind kind) {
        time_ns += 1e9 * after_s;
        train.push_back({static_cast<std::int64_t>(time_ns), kind});
    };
    const double through_pps = std::sqrt(limits.jump_pps * limits.jump_pps + 6.0 * limits.accel_pps2);
    const double top_pps = through_pps * (0.8 + 0.9 * dice.part());
    for (double pps = limits.jump_pps; pps < top_pps; pps = std::sqrt(pps * pps + 1.8 * limits.accel_pps2))
        add(1.0 / pps, TrainEvent::Kind::forward);
    for (auto i = 5 + dice.number() % 30; i > 0; --i) add(1.0 / top_pps, TrainEvent::Kind::forward);
    const auto pause_s = [&](double most_s) {
        return dice.part() < 0.5 ? limits.step_s() * dice.part() : most_s * dice.part();
    };
    for (auto i = 1 + dice.number() % 4; i > 0; --i) add(pause_s(3.0 / top_pps), TrainEvent::Kind::joint);
    const double back_pps = limits.jump_pps * (0.5 + 0.8 * dice.part());
    add(pause_s(2.0 / limits.jump_pps), TrainEvent::Kind::backward);
    for (int i = 0; i < 8; ++i)
        add(1.0 / back_pps, dice.part() < 0.7 ? TrainEvent::Kind::backward : TrainEvent::Kind::forward);
    return train;
}

TEST(TurnedWitness, BeginsInsideTheRoomAlsoBehindJoints) {
    int offences = 0;
    for (std::uint32_t seed = 0; seed < 4000; ++seed) {
        MotorLimits limits;
        const Train train = joints_at_the_edge(limits, seed);
        const auto offence = the_long_way(train, limits);
        offences += offence ? 1 : 0;
        ASSERT_EQ(by_shortcuts(train, limits), offence) << "seed " << seed;
    }
    EXPECT_GT(offences, 0);
}

/// Long stretches around start-stop speed and long ramps at nearly all the acceleration there is, while the
/// pulses come up to 0.95 of one early or late.
Train long_ramps_at_the_edge(MotorLimits& limits, std::uint32_t seed, Range hurry) {
    constexpr double kStep_s = 1e-5;
    constexpr double kDuration_s = 1.5;
    constexpr double kMostOff_pulses = 0.95;
    Dice dice(seed * 7919);
    limits = {1e6, 48'048.0, 2'000.0};
    if (dice.part() < 0.7) {
        const double part = dice.part();
        limits.jump_pps = 100.0 + part * dice.part() * 4'000.0;
    }
    limits.accel_pps2 = std::pow(10.0, 4.5 + 1.8 * dice.part());
    const double accel_pps2 = (hurry.low + (hurry.high - hurry.low) * dice.part()) * limits.accel_pps2;
    std::vector<double> positions{0.0};
    double position = 0.0;
    double speed_pps = 0.0;
    double wanted_pps = 0.0;
    double wanted_until_s = 0.0;
    double off = 0.0;
    double wanted_off = 0.0;
    double off_until_s = 0.0;
    double off_per_s = 0.0;
    while (static_cast<double>(positions.size()) * kStep_s < kDuration_s) {
        const double now_s = static_cast<double>(positions.size()) * kStep_s;
        if (now_s >= wanted_until_s) {
            const double kind = dice.part();
            if (kind < 0.5) {
                wanted_pps = limits.jump_pps * (0.9 + 0.2 * dice.part()) * (dice.part() < 0.8 ? 1.0 : -1.0);
                const double part = dice.part();
                wanted_until_s = now_s + 0.3 * part * dice.part();
            } else if (kind < 0.6) {
                wanted_pps = 0.0;
                wanted_until_s = now_s + 0.05 * dice.part();
            } else {
                wanted_pps = 45'000.0 * dice.part();
                const double ramp_s = (wanted_pps - limits.jump_pps) / accel_pps2;
                wanted_until_s = now_s + std::max(0.01, ramp_s * (0.2 + dice.part()));
            }
        }
        const bool is_slow = std::abs(speed_pps) <= limits.jump_pps;
        if (is_slow && std::abs(wanted_pps) <= limits.jump_pps)
            speed_pps = wanted_pps;
        else if (std::abs(speed_pps) < limits.jump_pps)
            speed_pps = std::copysign(limits.jump_pps, wanted_pps);
        else
            speed_pps += std::clamp(wanted_pps - speed_pps, -accel_pps2 * kStep_s, accel_pps2 * kStep_s);
        if (now_s >= off_until_s) {
            wanted_off = (2.0 * dice.part() - 1.0) * kMostOff_pulses;
            if (dice.part() < 0.4) wanted_off = std::copysign(kMostOff_pulses, wanted_off);
            const double part = dice.part();
            off_until_s = now_s + 0.002 + 0.1 * part * dice.part();
            off_per_s = std::abs(wanted_off - off) / (off_until_s - now_s) * (1.0 + 5.0 * dice.part());
        }
        off += std::clamp(wanted_off - off, -off_per_s * kStep_s, off_per_s * kStep_s);
        position += speed_pps * kStep_s;
        positions.push_back(position + off);
    }
    const Motion motion = [&positions](double time_s) {
        const auto step = static_cast<std::size_t>(time_s / kStep_s);
        return positions[std::min(step, positions.size() - 1)];
    };
    return pulses_of(motion, kDuration_s, {.seed = seed});
}

TEST(TurnedWitness, ForgetsNothingThatALongRampNeeds) {
    int offences = 0;
    int trains = 0;
    for (const Range hurry : {Range{0.985, 1.0}, Range{1.0, 1.02}}) {
        for (std::uint32_t seed = 1; seed <= 60; ++seed, ++trains) {
            MotorLimits limits;
            const Train train = long_ramps_at_the_edge(limits, seed, hurry);
            const auto offence = the_long_way(train, limits);
            offences += offence ? 1 : 0;
            EXPECT_EQ(by_shortcuts(train, limits), offence) << "seed " << seed << " from " << hurry.low;
        }
    }
    EXPECT_GT(offences, 0);
    EXPECT_LT(offences, trains);
}

}  // namespace
}  // namespace psicarve::verify
