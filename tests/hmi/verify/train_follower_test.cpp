// SPDX-License-Identifier: GPL-3.0-or-later
// Rule 3 on the pulses of one axis: what a motor can follow, and what it cannot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "hmi/verify/motor/train_demand.hpp"
#include "hmi/verify/motor/train_follower.hpp"
#include "shared/profile/profile.hpp"
#include "tests/hmi/verify/exact_motion.hpp"
#include "tests/places.hpp"

namespace psicarve::verify {
namespace {

constexpr double kTail_s = 0.05;

struct Case {
    const char* name;
    MotorLimits limits;
    std::int64_t tick_ns;
};
void PrintTo(const Case& value, std::ostream* out) {
    *out << value.name;
}

MotorLimits limits_of(const Profile& profile, Axis axis) {
    const AxisMotion motion = axis_motion(profile, axis);
    return {motion.accel_pps2, motion.speed_pps, motion.start_stop_pps};
}

Case case_of(const char* name, const char* file, Axis axis, std::int64_t tick_ns) {
    const Profile profile = file == nullptr ? Profile{} : load_profile(example(file)).value();
    return {name, limits_of(profile, axis), tick_ns};
}

Case fine() {
    return case_of("fine", "fine.toml", Axis::r1, 10'000);
}

/// The index of the event after which no motion is left.
std::optional<std::size_t> first_offence(const std::vector<TrainEvent>& events, const MotorLimits& limits) {
    TrainFollower sut(limits, 0);
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (!sut.take(events[i])) return i;
    }
    if (events.empty() || sut.wait(events.back().time_ns + round_to_pulse(kTail_s * 1e9))) return {};
    return events.size();
}

/// The same, everything worked out after each pulse.
std::optional<std::size_t> first_offence_the_long_way(const std::vector<TrainEvent>& events,
                                                      const MotorLimits& limits) {
    MotorReach reach(limits);
    std::int64_t count = 0;
    std::int64_t now_ns = 0;
    reach.start_anywhere(room_at(0));
    for (std::size_t i = 0; i < events.size(); ++i) {
        reach.run(seconds_from_ns(events[i].time_ns - std::exchange(now_ns, events[i].time_ns)),
                  room_at(count));
        const std::int64_t next = events[i].count_after(count);
        reach.cut(room_between(std::exchange(count, next), next));
        if (reach.is_empty()) return i;
    }
    reach.run(kTail_s, room_at(count));
    return reach.is_empty() ? std::optional(events.size()) : std::nullopt;
}

class TrainFollowerTest : public testing::TestWithParam<Case> {
protected:
    MotorLimits limits_ = GetParam().limits;

    RampMotion ramp(double accel_ratio, double top_ratio = 0.95) const {
        return {.jump_pps = limits_.jump_pps,
                .top_pps = top_ratio * limits_.speed_pps,
                .accel_pps2 = accel_ratio * limits_.accel_pps2};
    }
    std::vector<TrainEvent> pulses(const RampMotion& motion, PulseMaker maker) const {
        maker.tick_ns = GetParam().tick_ns;
        return pulses_of(motion, motion.end_s() + 0.01, maker);
    }
};

INSTANTIATE_TEST_SUITE_P(EachMachine, TrainFollowerTest,
                         testing::Values(case_of("fine head", "fine.toml", Axis::r1, 10'000),
                                         case_of("fine table", "fine.toml", Axis::psi, 10'000),
                                         case_of("default", nullptr, Axis::r1, 50'000),
                                         case_of("original in two-timer ticks", "original.toml", Axis::r1,
                                                 500'000)),
                         [](const auto& case_info) { return "n" + std::to_string(case_info.index); });

TEST_P(TrainFollowerTest, AcceptsRampsAtExactlyTheLimitsWhateverThePhase) {
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        const double phase = 0.05 * seed - 0.5;
        for (const double jitter : {0.0, 0.2}) {
            const auto events =
                pulses(ramp(1.0, 1.0), {.phase_pulses = phase, .jitter_pulses = jitter, .seed = seed});
            EXPECT_EQ(first_offence(events, limits_), std::nullopt)
                << "phase " << phase << ", jitter " << jitter;
        }
    }
}

TEST_P(TrainFollowerTest, RefusesRampsThatAskForAFifthMore) {
    RampMotion motion = ramp(1.2);
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        const auto events = pulses(motion, {.phase_pulses = 0.2 * seed - 0.6, .seed = seed});
        EXPECT_NE(first_offence(events, limits_), std::nullopt) << "seed " << seed;
    }
}

TEST_P(TrainFollowerTest, AcceptsAnythingBelowStartStopSpeed) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> more(1.0, 3.0);
    std::vector<TrainEvent> events;
    std::int64_t time_ns = 0;
    for (int i = 0; i < 3'000; ++i) {
        time_ns += round_to_pulse(more(random) * 1e9 / limits_.jump_pps);
        events.push_back(
            {time_ns, random() % 2 == 0 ? TrainEvent::Kind::forward : TrainEvent::Kind::backward});
    }
    EXPECT_EQ(first_offence(events, limits_), std::nullopt);
}

TEST_P(TrainFollowerTest, MayReverseAtStartStopSpeedAndNoFaster) {
    const auto to_and_fro = [](double speed_pps) {
        const double turn_s = 0.3;
        return pulses_of([=](double time_s) { return speed_pps * std::fabs(turn_s - time_s); }, 2.0 * turn_s,
                         {.tick_ns = GetParam().tick_ns});
    };
    EXPECT_EQ(first_offence(to_and_fro(limits_.jump_pps), limits_), std::nullopt);
    // The free way of 3 pulses is worth sqrt(6a) of speed on each side.
    const double too_fast_pps = limits_.jump_pps + 1.1 * std::sqrt(6.0 * limits_.accel_pps2);
    if (too_fast_pps < limits_.speed_pps) {
        EXPECT_NE(first_offence(to_and_fro(too_fast_pps), limits_), std::nullopt);
    }
}

// Slow enough that ramps are long beside the 3 pulses of free way: what is lost of the time in which it turns
// would not be made up for.
TEST(TrainFollower, AcceptsRampsAtExactlyTheLimitsThatTurnBackAtOnce) {
    const double top_pps = 20'000.0;
    for (const double accel_pps2 : {3e5, 474'288.0, 8e5}) {
        for (const double jump_pps : {300.0, 1'064.0, 2'500.0}) {
            const RampMotion ramp{.jump_pps = jump_pps, .top_pps = top_pps, .accel_pps2 = accel_pps2};
            const double turn_s = ramp.end_s();
            const Motion there_and_back = [&](double time_s) {
                return time_s < turn_s ? ramp(time_s) : ramp(2.0 * turn_s - time_s);
            };
            for (std::uint32_t seed = 1; seed <= 10; ++seed) {
                const auto events =
                    pulses_of(there_and_back, 2.0 * turn_s, {.phase_pulses = 0.1 * seed - 0.5, .seed = seed});
                const MotorLimits limits{1.001 * accel_pps2, 48'000.0, jump_pps};
                ASSERT_EQ(first_offence(events, limits), std::nullopt)
                    << accel_pps2 << " pulses/s2, from " << jump_pps << " pulses/s, seed " << seed;
                ASSERT_EQ(first_offence_the_long_way(events, limits), std::nullopt);
            }
        }
    }
}

TEST_P(TrainFollowerTest, ShortcutsChangeNoVerdict) {
    for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> part(0.0, 1.0);
        const double top_pps = limits_.speed_pps * part(random) * part(random);
        const double hurry = 0.8 + 0.6 * part(random);
        const double omega = hurry * limits_.accel_pps2 / (top_pps + limits_.jump_pps);
        const double swing = top_pps / omega;
        const Motion motion = [=](double time_s) {
            return swing * std::sin(omega * time_s) + 0.3 * swing * std::sin(0.37 * omega * time_s);
        };
        const auto events =
            pulses_of(motion, 1.0, {.tick_ns = GetParam().tick_ns, .jitter_pulses = 0.2, .seed = seed});
        EXPECT_EQ(first_offence(events, limits_), first_offence_the_long_way(events, limits_))
            << "seed " << seed;
    }
}

/// Speeds around start-stop, now and then far above it, one after the other at nearly all the acceleration
/// that there is, or a little more: every millisecond another one of the short ways to follow it ends.
Motion restless_motion(const MotorLimits& limits, std::uint32_t seed, double duration_s) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const double accel_pps2 = (0.85 + 0.5 * part(random)) * limits.accel_pps2;
    constexpr double kStep_s = 1e-5;
    std::vector<double> positions{0.0};
    double speed_pps = 0.0;
    double wanted_pps = 0.0;
    double until_s = 0.0;
    while (static_cast<double>(positions.size()) * kStep_s < duration_s) {
        const double now_s = static_cast<double>(positions.size()) * kStep_s;
        if (now_s >= until_s) {
            const double most_pps = (part(random) < 0.2 ? 4.0 : 1.6) * limits.jump_pps;
            wanted_pps = std::min(most_pps, limits.speed_pps) * (2.0 * part(random) - 1.0);
            until_s = now_s + 0.003 + 0.06 * part(random);
        }
        const double change_pps = accel_pps2 * kStep_s;
        speed_pps += std::clamp(wanted_pps - speed_pps, -change_pps, change_pps);
        positions.push_back(positions.back() + speed_pps * kStep_s);
    }
    return [positions](double time_s) {
        const auto step = static_cast<std::size_t>(time_s / kStep_s);
        return positions[std::min(step, positions.size() - 1)];
    };
}

TEST_P(TrainFollowerTest, ShortcutsChangeNoVerdictAroundStartStopSpeed) {
    int offences = 0;
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        const auto events = pulses_of(restless_motion(limits_, seed, 1.0), 1.0,
                                      {.tick_ns = GetParam().tick_ns, .jitter_pulses = 0.2, .seed = seed});
        const auto offence = first_offence_the_long_way(events, limits_);
        offences += offence ? 1 : 0;
        EXPECT_EQ(first_offence(events, limits_), offence) << "seed " << seed;
    }
    EXPECT_GT(offences, 0);
    EXPECT_LT(offences, 40);
}

// The case that the rule is for: 4000 pulses/mm, 10 us ticks. Ramps of 46 ms.
TEST(TrainFollower, CatchesTenPercentTooMuchAccelerationOnTheFineProfile) {
    const Case machine = fine();
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        const RampMotion motion{
            .jump_pps = 2'000, .top_pps = 47'000, .accel_pps2 = 1.1 * machine.limits.accel_pps2};
        const auto events =
            pulses_of(motion, motion.end_s() + 0.01,
                      {.phase_pulses = 0.05 * seed - 0.5, .jitter_pulses = 0.45, .seed = seed});
        const auto offence = first_offence(events, machine.limits);
        ASSERT_NE(offence, std::nullopt) << "seed " << seed;
        EXPECT_LT(seconds_from_ns(events[*offence].time_ns), motion.start_s + motion.ramp_s());
        const double needed = demand_of(events, machine.limits).needed / machine.limits.accel_pps2;
        EXPECT_GT(needed, 1.08) << "seed " << seed;
        EXPECT_LE(needed, 1.1005) << "seed " << seed;
    }
}

TEST(TrainFollower, CatchesOnePercentTooMuchAccelerationOnALongRamp) {
    const Case machine = fine();
    for (const double ratio : {1.0, 1.01}) {
        const RampMotion motion{
            .jump_pps = 2'000, .top_pps = 47'000, .accel_pps2 = ratio * machine.limits.accel_pps2};
        const auto events = pulses_of(motion, motion.end_s() + 0.01, {.jitter_pulses = 0.45, .seed = 3});
        EXPECT_EQ(first_offence(events, machine.limits).has_value(), ratio > 1.0);
    }
}

TEST(TrainFollower, CatchesOnePercentTooMuchSpeed) {
    for (const Case& machine : {fine(), case_of("default", nullptr, Axis::psi, 50'000)}) {
        RampMotion motion{.jump_pps = machine.limits.jump_pps,
                          .top_pps = 1.01 * machine.limits.speed_pps,
                          .accel_pps2 = 0.9 * machine.limits.accel_pps2};
        motion.cruise_s = 300.0 / (0.01 * machine.limits.speed_pps);  // gains three hundred pulses
        const auto events = pulses_of(motion, motion.end_s() + 0.01, {.tick_ns = machine.tick_ns});
        ASSERT_NE(first_offence(events, machine.limits), std::nullopt) << machine.name;
        const TrainDemand demand = demand_of(events, machine.limits);
        EXPECT_TRUE(demand.is_speed) << machine.name;
        EXPECT_NEAR(demand.needed / machine.limits.speed_pps, 1.01, 0.001) << machine.name;
    }
}

TEST(TrainFollower, StartsFromRestWithAJumpOfTheStartStopSpeedAndTheRoomThatThereIs) {
    const MotorLimits limits = fine().limits;
    const auto from_rest = [](double speed_pps) {
        return pulses_of([=](double time_s) { return time_s < 0.02 ? 0.0 : speed_pps * (time_s - 0.02); },
                         0.05, {});
    };
    const auto is_followed = [&](const std::vector<TrainEvent>& events) {
        TrainFollower sut(limits, 0);
        return std::all_of(events.begin(), events.end(),
                           [&](const TrainEvent& event) { return sut.take(event); });
    };
    EXPECT_TRUE(is_followed(from_rest(limits.jump_pps)));
    // Up to the first edge it may come from 1.5 pulses behind to 1.5 ahead of the old count, jumping and then
    // speeding up: v^2 = j^2 + 6a. From there, a pulse ahead of a steady train, it may fall back two pulses
    // while it catches up with the train's speed: 4a more.
    const double most_pps = std::sqrt(limits.jump_pps * limits.jump_pps + 6.0 * limits.accel_pps2) +
                            std::sqrt(4.0 * limits.accel_pps2);
    EXPECT_TRUE(is_followed(from_rest(0.98 * most_pps)));
    EXPECT_FALSE(is_followed(from_rest(1.02 * most_pps)));
}

TEST(TrainFollower, JumpsAtJointsWhereThereAreAny) {
    const MotorLimits limits = fine().limits;
    const double low_pps = 20'000.0;
    const double high_pps = low_pps + 2.0 * limits.jump_pps + 2'000.0;
    const Motion bent = [=](double time_s) {
        const double joint_s = 0.05;
        return time_s < joint_s ? low_pps * time_s : low_pps * joint_s + high_pps * (time_s - joint_s);
    };
    auto events = pulses_of(bent, 0.1, {});
    const auto judged = [&] {
        TrainFollower sut(limits, 0);
        return std::all_of(events.begin(), events.end(),
                           [&](const TrainEvent& event) { return sut.take(event); });
    };
    EXPECT_FALSE(judged());
    const auto joint = std::find_if(events.begin(), events.end(),
                                    [](const TrainEvent& event) { return event.time_ns >= 50'000'000; });
    events.insert(joint, {50'000'000, TrainEvent::Kind::joint});
    EXPECT_TRUE(judged());
}

TEST(TrainFollower, GoesOnAfterAnOffence) {
    const Case machine = fine();
    const RampMotion wild{.jump_pps = 2'000, .top_pps = 40'000, .accel_pps2 = 3e6};
    const auto events = pulses_of(wild, wild.end_s() + 0.5, {});
    TrainFollower sut(machine.limits, 0);
    int offences = 0;
    for (const TrainEvent& event : events) offences += sut.take(event) ? 0 : 1;
    EXPECT_GT(offences, 2);
    const RampMotion calm{.jump_pps = 2'000, .top_pps = 40'000, .accel_pps2 = 1e6, .start_s = 0.0};
    for (TrainEvent event : pulses_of(calm, calm.end_s(), {})) {
        event.time_ns += 1'000'000'000;
        ASSERT_TRUE(sut.take(event));
    }
}

/// The least acceleration that three moments ask for: p(t1) is at most so far from the straight line between
/// p(t0) and p(t2) as (t1 - t0) (t2 - t1) a / 2. Knows nothing of sets.
double needed_by_three_moments(const std::vector<TrainEvent>& events) {
    double most = 0.0;
    for (std::size_t reach = 8; 2 * reach < events.size(); reach += reach / 4) {
        for (std::size_t i = reach; i + reach < events.size(); i += 3) {
            const auto at = [&](std::size_t n) {
                return seconds_from_ns(events[n].time_ns - events[i].time_ns);
            };
            const double before_s = -at(i - reach);
            const double after_s = at(i + reach);
            // Counts are i - reach + 1, i + 1, i + reach + 1 after these pulses; each has a pulse either way.
            const double line = static_cast<double>(reach) * (after_s - before_s) / (before_s + after_s);
            const double bend = std::max(0.0, std::fabs(line) - 2.02);
            most = std::max(most, 2.0 * bend / (before_s * after_s));
        }
    }
    return most;
}

TEST(TrainFollower, DemandLiesBetweenWhatThreeMomentsProveAndWhatTheMotionHad) {
    MotorLimits limits = fine().limits;
    limits.jump_pps = 1.0;
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> part(0.0, 1.0);
        const double accel_pps2 = (1.0 + 2.0 * part(random)) * limits.accel_pps2;
        const double omega = accel_pps2 / 20'000.0 * (1.0 + part(random));
        const double swing = accel_pps2 / (omega * omega);
        const Motion motion = [=](double time_s) {
            return 25'000.0 * time_s - swing * std::cos(omega * time_s);
        };
        const auto events = pulses_of(motion, 0.06, {.jitter_pulses = 0.3, .seed = seed});
        const double needed = demand_of(events, limits).needed;
        EXPECT_LE(needed, std::max(limits.accel_pps2, accel_pps2) * 1.001) << "seed " << seed;
        EXPECT_GE(needed, std::min(needed_by_three_moments(events), accel_pps2) * 0.999) << "seed " << seed;
    }
}

}  // namespace
}  // namespace psicarve::verify
