// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::cycle {
namespace {

constexpr std::uint32_t kLayers = 4;
constexpr std::uint32_t kPoints = 60;

struct Way {
    const char* name;
    Joining joining;
    psicarve::Planner planner;
    double backlash_mm;
    Schedule schedule = Schedule::single;
};

struct Course {
    std::vector<Positions> order;  ///< which tips stepped together in the layers, and which way
    int lifts = 0;
    std::uint64_t ticks = 0;
    Positions end{};
};

class HeadLift : public ::testing::TestWithParam<Way> {
protected:
    static Profile profile() {
        Profile result = quick_profile();
        result.job.planner = GetParam().planner;
        result.job.lifts_on_hold = true;
        result.job.retract_mm = 1.5;
        result.r1.backlash_mm = result.r2.backlash_mm = GetParam().backlash_mm;
        if (GetParam().schedule == Schedule::two_timer) make_slow(result);
        return result;
    }
    /// What one pulse in 500 us allows.
    static void make_slow(Profile& profile) {
        profile.tick.period_us = 100.0;
        profile.tick.schedule = Schedule::two_timer;
        profile.psi.speed_deg_s = 112.5;
        profile.psi.accel_deg_s2 = 1125.0;
        for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
            axis->speed_mm_s = 5.0;
            axis->accel_mm_s2 = 50.0;
            axis->home_speed_mm_s = 4.0;
        }
    }
    /// A whole carving; seed 0: undisturbed, else with hold and resume at random instants, also while the
    /// heads are on their way.
    static Course carve(std::uint64_t seed) {
        MachineRig sut(profile());
        EXPECT_TRUE(sut.prepare(random_job(kLayers, kPoints, 31, GetParam().joining)));
        EXPECT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
        std::mt19937_64 random(seed);
        Course course;
        const std::uint64_t begin = sut.cycle->next_tick();
        std::uint64_t next = seed == 0 ? ~std::uint64_t{0} : begin + random() % 2000;
        Positions at = sut.positions();
        Positions left{};
        while (sut.cycle->state() != MachineState::finishing && sut.cycle->next_tick() < begin + 40'000'000) {
            const bool was_lifted = sut.cycle->are_heads_lifted();
            if (sut.cycle->next_tick() >= next) {
                next = sut.cycle->next_tick() + 1 + random() % 6000;
                const bool is_carving = sut.cycle->state() == MachineState::carving;
                (void)sut.ask(is_carving ? RequestKind::hold : RequestKind::resume);
            } else {
                sut.tick();
            }
            const bool is_lifted = sut.cycle->are_heads_lifted();
            if (!was_lifted && is_lifted) {
                ++course.lifts;
                left = sut.positions();
            }
            if (was_lifted && !is_lifted) {
                EXPECT_EQ(sut.positions(), left);
            }
            if (is_lifted) {
                EXPECT_NE(sut.cycle->pulses().levels() & bit_of(Signal::spindle), 0U);
            }
            // The path's last pulse may come in the very turn that ends with the lift's begin (two-timer). Of
            // links the core promises each axis' pulses, not which come together.
            const Positions now = sut.positions();
            if (now == at) continue;
            // A whole sample: not made at each tick.
            if (!was_lifted && sut.cycle->sample().points_done % kPoints != 0) {
                Positions way{};
                for (std::size_t k = 0; k < kAxisCount; ++k) way[k] = now[k] - at[k];
                course.order.push_back(way);
            }
            at = now;
        }
        course.ticks = sut.cycle->next_tick() - begin;
        course.end = sut.positions();
        for (std::size_t k = 0; k < kAxisCount; ++k)
            EXPECT_EQ(sut.machine->report().axes[k].stalls, 0U) << k << " seed " << seed;
        return course;
    }
};

TEST_P(HeadLift, LeavesEveryPulseOfThePathAsItWas) {
    const Course undisturbed = carve(0);
    EXPECT_EQ(undisturbed.lifts, 0);
    int lifts = 0;
    const std::uint64_t rounds = test::is_thorough() ? 4 : 1;
    for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
        const Course disturbed = carve(seed);
        lifts += disturbed.lifts;
        ASSERT_TRUE(disturbed.order == undisturbed.order) << "seed " << seed;
        EXPECT_EQ(disturbed.end, undisturbed.end) << "seed " << seed;
    }
    EXPECT_GT(lifts, static_cast<int>(3 * rounds));
}

TEST_P(HeadLift, TakesBothHeadsOutByTheRetractionAndKeepsTheSpindleOn) {
    MachineRig sut(profile());
    ASSERT_TRUE(sut.prepare(random_job(kLayers, kPoints, 32, GetParam().joining)));
    ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
    sut.run(3000);
    ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
    ASSERT_TRUE(sut.run_while([&] { return !sut.cycle->are_heads_lifted(); }));
    const Positions on_path = sut.positions();
    ASSERT_TRUE(sut.run_until(MachineState::held));
    for (const std::size_t k : {0U, 1U}) {
        const AxisMotion motion = axis_motion(sut.profile, static_cast<Axis>(k));
        EXPECT_EQ(sut.positions()[k],
                  std::min(on_path[k] + static_cast<std::int64_t>(1.5 * motion.pulses_per_unit),
                           motion.travel_max_pulses));
    }
    EXPECT_EQ(sut.positions()[2], on_path[2]);
    EXPECT_EQ(sut.positions()[3], on_path[3]);
    EXPECT_NE(sut.cycle->sample().signals & bit_of(Signal::spindle), 0U);
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    ASSERT_TRUE(sut.run_while([&] { return sut.cycle->are_heads_lifted(); }));
    EXPECT_EQ(sut.positions(), on_path);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
}

TEST_P(HeadLift, AStopWithTheHeadsOutEndsTheJobInOrder) {
    for (const std::uint64_t ticks : {0U, 300U, 900U, 40'000U}) {
        MachineRig sut(profile());
        ASSERT_TRUE(sut.prepare(random_job(kLayers, kPoints, 33, GetParam().joining)));
        ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
        sut.run(3000);
        ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
        ASSERT_TRUE(sut.run_while([&] { return !sut.cycle->are_heads_lifted(); }));
        sut.run(ticks);
        sut.stop();
        ASSERT_TRUE(sut.run_until(MachineState::ready)) << ticks;
        EXPECT_EQ(sut.cycle->sample().homed_mask, 0xF);
        EXPECT_EQ(sut.cycle->sample().signals & bit_of(Signal::spindle), 0U);
        EXPECT_FALSE(sut.cycle->are_heads_lifted());
        for (std::size_t k = 0; k < kAxisCount; ++k) EXPECT_EQ(sut.machine->report().axes[k].stalls, 0U);
    }
}

TEST_P(HeadLift, AnEmergencyStopOnTheWayEndsIt) {
    MachineRig sut(profile());
    ASSERT_TRUE(sut.prepare(random_job(kLayers, kPoints, 34, GetParam().joining)));
    ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
    sut.run(3000);
    ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
    ASSERT_TRUE(sut.run_while([&] { return !sut.cycle->are_heads_lifted(); }));
    sut.run(600);
    sut.emergency_stop();
    sut.tick();
    EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
    EXPECT_FALSE(sut.cycle->are_heads_lifted());
    EXPECT_EQ(sut.cycle->sample().homed_mask & 0b11U, 0U) << "both heads moved";
    const Positions at = sut.positions();
    sut.run(1000);
    EXPECT_EQ(sut.positions(), at);
}

INSTANTIATE_TEST_SUITE_P(
    All, HeadLift,
    ::testing::Values(
        Way{"continuousByAngle", Joining::continuous, psicarve::Planner::angle, 0.0},
        Way{"zigzagAhead", Joining::zigzag, psicarve::Planner::lookahead, 0.0},
        Way{"spiralAhead", Joining::spiral, psicarve::Planner::lookahead, 0.0},
        Way{"continuousAheadWithBacklash", Joining::continuous, psicarve::Planner::lookahead, 0.05},
        Way{"continuousByAngleWithBacklash", Joining::continuous, psicarve::Planner::angle, 0.05},
        Way{"continuousByAngleTwoTimers", Joining::continuous, psicarve::Planner::angle, 0.0,
            Schedule::two_timer},
        Way{"zigzagAheadWithBacklashTwoTimers", Joining::zigzag, psicarve::Planner::lookahead, 0.05,
            Schedule::two_timer}),
    [](const auto& way) { return std::string{way.param.name}; });

}  // namespace
}  // namespace psicarve::cycle
