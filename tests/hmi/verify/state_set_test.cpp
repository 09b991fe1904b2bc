// SPDX-License-Identifier: GPL-3.0-or-later
// What makes rule 3's sets of states cheap changes none of them: a look that spares a hull, a pause that
// spares what was before it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "hmi/verify/motor/motor_reach.hpp"
#include "hmi/verify/motor/state_set.hpp"
#include "hmi/verify/motor/train_event.hpp"

namespace psicarve::verify {
namespace {

using Side = ReachBoundary::Side;

class StateDice {
public:
    explicit StateDice(std::uint32_t seed) : random_(seed) {}
    double part() { return part_(random_); }
    double between(double low, double high) { return low + (high - low) * part(); }

private:
    std::mt19937 random_;
    std::uniform_real_distribution<double> part_{0.0, 1.0};
};

MotorLimits some_limits(StateDice& dice) {
    MotorLimits limits;
    limits.accel_pps2 = std::pow(10.0, dice.between(4.3, 6.0));
    limits.jump_pps = dice.between(0.1, 4.0) * std::sqrt(limits.accel_pps2);
    limits.speed_pps = dice.between(1.0, 20.0) * limits.jump_pps;
    return limits;
}

std::vector<double> numbers_of(const ReachBoundary& boundary) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        numbers.push_back(boundary.speed(i));
        numbers.push_back(boundary.reach(i));
    }
    return numbers;
}

/// All that can be seen of a reach.
std::vector<double> numbers_of(const MotorReach& reach) {
    std::vector<double> numbers{reach.slow().low, reach.slow().high, reach.is_running_only() ? 1.0 : 0.0};
    for (const bool is_upward : {true, false}) {
        for (const Side side : {Side::left, Side::right}) {
            const auto more = numbers_of(reach.running(is_upward).boundary(side));
            numbers.insert(numbers.end(), more.begin(), more.end());
        }
    }
    return numbers;
}

/// Leaves start-stop speed somewhere in a room and runs on, a little or long.
StateSet some_states(StateDice& dice, const MotorLimits& limits) {
    const double middle = dice.between(-1.5, 1.5);
    const double half = 0.5 * dice.part();
    StateSet set = StateSet::box({middle - half, middle + half}, {limits.jump_pps, limits.jump_pps});
    const double wall = dice.between(middle + half, 3.0);
    for (int i = static_cast<int>(dice.between(1.0, 5.0)); i > 0 && !set.is_empty(); --i) {
        set.run(limits.step_s() * dice.part(), limits.accel_pps2, limits.speed_pps);
        set.keep_below(wall);
        set.keep_speeds({limits.jump_pps, limits.speed_pps});
    }
    return set;
}

double reach_at(const ReachBoundary& boundary, double speed) {
    std::size_t i = 1;
    while (i < boundary.size() && boundary.speed(i) < speed) ++i;
    if (i >= boundary.size() || speed <= boundary.slowest())
        return boundary.reach(speed <= boundary.slowest() ? 0 : boundary.size() - 1);
    const double share = (speed - boundary.speed(i - 1)) / (boundary.speed(i) - boundary.speed(i - 1));
    return boundary.reach(i - 1) + share * (boundary.reach(i) - boundary.reach(i - 1));
}

/// By how much the hull of two boundaries reaches further than both, at the corners and half-way between
/// them.
double looseness(const ReachBoundary& hull, const ReachBoundary& a, const ReachBoundary& b) {
    std::vector<double> speeds;
    for (const ReachBoundary* boundary : {&a, &b}) {
        for (std::size_t i = 0; i < boundary->size(); ++i) speeds.push_back(boundary->speed(i));
    }
    std::ranges::sort(speeds);
    for (std::size_t i = speeds.size(); i-- > 1;) speeds.push_back(0.5 * (speeds[i - 1] + speeds[i]));
    double most = 0.0;
    for (const double speed : speeds) {
        double reached = -1e9;
        for (const ReachBoundary* boundary : {&a, &b}) {
            if (speed >= boundary->slowest() && speed <= boundary->fastest())
                reached = std::max(reached, reach_at(*boundary, speed));
        }
        most = std::max(most, reach_at(hull, speed) - reached);
    }
    return most;
}

TEST(StateSetTest, IsJoinedWhereTheHullIsTightAndNowhereElse) {
    constexpr double kTolerance_pulses = 2e-3;
    constexpr double kUndecided_pulses = 1e-9;
    std::size_t joined = 0;
    std::size_t kept_apart = 0;
    StateDice dice(5);
    for (int round = 0; round < 40'000; ++round) {
        const MotorLimits limits = some_limits(dice);
        const StateSet other = some_states(dice, limits);
        StateSet sut = some_states(dice, limits);
        if (other.is_empty()) continue;
        if (dice.part() < 0.5) {  // alike, but for some more time
            sut = other;
            sut.run(0.2 * limits.step_s() * dice.part() * dice.part(), limits.accel_pps2, limits.speed_pps);
            sut.keep_speeds({limits.jump_pps, limits.speed_pps});
        }
        if (sut.is_empty()) continue;
        StateSet hull = sut;
        hull.join(other);
        double loose = 0.0;
        for (const Side side : {Side::left, Side::right})
            loose = std::max(loose, looseness(hull.boundary(side), sut.boundary(side), other.boundary(side)));
        if (std::abs(loose - kTolerance_pulses) < kUndecided_pulses) continue;
        const bool is_tight = loose < kTolerance_pulses;
        (is_tight ? joined : kept_apart) += 1;
        const StateSet before = sut;
        ASSERT_EQ(sut.try_join(other, kTolerance_pulses), is_tight) << "round " << round << ", " << loose;
        for (const Side side : {Side::left, Side::right})
            ASSERT_EQ(numbers_of(sut.boundary(side)), numbers_of((is_tight ? hull : before).boundary(side)));
    }
    EXPECT_GT(joined, 1000U);
    EXPECT_GT(kept_apart, 1000U);
}

// A run too short to change a speed leaves two corners at the slowest one.
TEST(StateSetTest, IsJoinedAfterARunThatIsAllButNone) {
    const StateSet inside = StateSet::box({-1.0, 1.0}, {1000.0, 2000.0});
    for (const bool is_first : {true, false}) {
        StateSet other = StateSet::box({-1.5, 1.0}, {1000.0, 2000.0});
        other.run(2e-19, 32'000.0, 1e5);
        StateSet joined = inside;
        joined.keep_speeds({1000.0, 1e5});
        EXPECT_TRUE(is_first ? joined.try_join(other, 2e-3) : other.try_join(joined, 2e-3));
    }
}

// Two motors of which all is known that can be, and next to nothing: behind the pause both are the same, to
// the last bit, and remain so whatever comes.
TEST(SettledReach, KnowsNothingOfWhatWasBefore) {
    StateDice dice(9);
    std::size_t promised = 0;
    for (int round = 0; round < 4'000; ++round) {
        const MotorLimits limits = some_limits(dice);
        const Range room = room_at(static_cast<std::int64_t>(dice.between(-1'000.0, 1'000.0)));
        const double low = dice.between(room.low, room.high - 0.5);
        const Range slow{low, dice.between(low + 0.5, room.high)};
        MotorReach narrow(limits);
        narrow.start_slow(slow);
        MotorReach wide(limits);
        wide.start_anywhere(room);
        const double settled_s = narrow.surely_settled_after_s(slow, room);
        if (std::isinf(settled_s)) continue;
        ++promised;
        narrow.run(settled_s, room);
        wide.run(settled_s, room);
        ASSERT_EQ(numbers_of(narrow), numbers_of(wide)) << "round " << round;
        std::int64_t count = static_cast<std::int64_t>(std::lround(0.5 * (room.low + room.high)));
        for (int i = 0; i < 8; ++i) {
            const std::int64_t next = count + (dice.part() < 0.7 ? 1 : -1);
            const double time_s = dice.part() * 2.0 / limits.jump_pps;
            for (MotorReach* reach : {&narrow, &wide}) {
                if (i > 0) reach->run(time_s, room_at(count));
                reach->cut(room_between(count, next));
            }
            count = next;
            ASSERT_EQ(numbers_of(narrow), numbers_of(wide)) << "round " << round << ", pulse " << i;
        }
    }
    EXPECT_GT(promised, 2'000U);
}

TEST(SettledReach, IsNotPromisedWhereLittleIsKnownOrStepsLeadOutOfTheRoom) {
    const Range room = room_at(0);
    const MotorReach sut({1e6, 48'000.0, 2'000.0});
    EXPECT_TRUE(std::isfinite(sut.surely_settled_after_s({-0.5, 0.5}, room)));
    EXPECT_TRUE(std::isinf(sut.surely_settled_after_s({0.0, 0.3}, room)));
    EXPECT_TRUE(std::isinf(sut.surely_settled_after_s(Range::none(), room)));
    EXPECT_TRUE(std::isinf(MotorReach({1e6, 48'000.0, 50.0}).surely_settled_after_s({-0.5, 0.5}, room)));
}

}  // namespace
}  // namespace psicarve::verify
