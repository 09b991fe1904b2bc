// SPDX-License-Identifier: GPL-3.0-or-later
// Schedule two-timer against schedule single: the same pulses in the same order, at other times.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

constexpr std::int64_t kTick_ns = 100'000;
constexpr std::int64_t kIo_ns = 500'000;
constexpr std::uint64_t kIoTicks = 5;

/// As the original: 2 000 pulses a second at most.
Profile slow_profile(Schedule schedule, psicarve::Planner planner = psicarve::Planner::angle) {
    Profile profile = quick_profile();
    profile.tick.period_us = 100.0;
    profile.tick.schedule = schedule;
    profile.job.planner = planner;
    profile.psi.speed_deg_s = 112.5;
    profile.psi.accel_deg_s2 = 1125.0;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->speed_mm_s = 5.0;
        axis->accel_mm_s2 = 50.0;
        axis->home_speed_mm_s = 4.0;
    }
    return profile;
}

/// Holds, resumes and overrides after these many pulses went out.
struct Disturbances {
    std::vector<std::size_t> after;
    std::size_t stop_after = 0;  ///< 0: never
};

Disturbances disturbances(std::uint64_t seed, std::size_t pulses) {
    std::mt19937_64 random(seed);
    Disturbances result;
    for (int i = 0; i < 8; ++i) result.after.push_back(1 + random() % pulses);
    std::ranges::sort(result.after);
    return result;
}

struct Carved {
    std::vector<std::uint32_t> order;
    std::vector<PortWrite> writes;
    Positions end{};
    Positions true_end{};
};

Carved carved(const Profile& profile, const JobTable& job, const Disturbances& disturb = {}) {
    MachineRig rig(profile);
    Carved result;
    EXPECT_TRUE(rig.prepare(job));
    rig.port->writes.clear();
    EXPECT_EQ(rig.ask(RequestKind::start_interpolation), Refusal::none);
    std::uint64_t percent = 20;
    for (const std::size_t after : disturb.after) {
        rig.run_while([&] {
            return rig.cycle->state() == MachineState::carving && rig.port->writes.size() / 2 < after;
        });
        if (rig.ask(RequestKind::hold) != Refusal::none) break;
        EXPECT_TRUE(rig.run_until(MachineState::held));
        EXPECT_FALSE(rig.cycle->pulses().is_gate_shut());
        EXPECT_EQ(rig.ask(RequestKind::override, 0, percent), Refusal::none);
        percent = percent == 180 ? 20 : percent + 40;
        EXPECT_EQ(rig.ask(RequestKind::resume), Refusal::none);
    }
    if (disturb.stop_after > 0) {
        rig.run_while([&] { return rig.port->writes.size() / 2 < disturb.stop_after; });
        rig.stop();
        rig.run_while([&] { return rig.io->plan_requests.size() == 0; });
    } else {
        EXPECT_TRUE(rig.run_until(MachineState::finishing));
    }
    result.writes = rig.port->writes;
    result.order = order_of(result.writes);
    EXPECT_TRUE(rig.run_until(MachineState::ready));
    result.end = rig.positions();
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        result.true_end[k] = rig.machine->position_pulses(kAllAxes[k]);
    }
    return result;
}

/// Whether `sut` has the pulses of `single` in the same order. In moves, where each axis goes by itself,
/// those that fall into one period go out together.
::testing::AssertionResult is_same_order(const std::vector<std::uint32_t>& sut,
                                         const std::vector<std::uint32_t>& single, bool has_moves) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < sut.size(); ++i) {
        std::uint32_t axes = 0;
        do {
            if (next == single.size() || (axes & single[next]) != 0) break;
            axes |= single[next++];
        } while (has_moves && axes != sut[i]);
        if (axes == sut[i]) continue;
        return ::testing::AssertionFailure() << "at " << i << ": " << sut[i] << " instead of " << axes;
    }
    return ::testing::AssertionSuccess();
}

class TwoTimer : public ::testing::TestWithParam<std::tuple<psicarve::Planner, Joining>> {
protected:
    Profile profile(Schedule schedule) const { return slow_profile(schedule, std::get<0>(GetParam())); }
    /// From layer to layer the other planner moves.
    bool has_moves() const { return GetParam() == std::tuple{psicarve::Planner::angle, Joining::continuous}; }
    JobTable job(std::uint64_t seed) const { return random_job(3, 60, seed, std::get<1>(GetParam())); }
};

TEST_P(TwoTimer, MakesThePulsesOfTheOtherScheduleInTheSameOrder) {
    for (const std::uint64_t seed : {21U, 22U, 23U}) {
        const Carved single = carved(profile(Schedule::single), job(seed));
        const Carved sut = carved(profile(Schedule::two_timer), job(seed));
        ASSERT_GT(sut.order.size(), 1000U);
        EXPECT_TRUE(is_same_order(sut.order, single.order, has_moves())) << "seed " << seed;
        EXPECT_EQ(sut.end, single.end);
        EXPECT_EQ(sut.true_end, sut.end);
    }
}

TEST_P(TwoTimer, KeepsTheOrderThroughHoldsResumesAndOverrides) {
    const Carved single = carved(profile(Schedule::single), job(31));
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Carved sut =
            carved(profile(Schedule::two_timer), job(31), disturbances(seed, single.order.size()));
        ASSERT_TRUE(is_same_order(sut.order, single.order, has_moves())) << "seed " << seed;
        EXPECT_EQ(sut.end, single.end);
        EXPECT_EQ(sut.true_end, sut.end);
    }
}

TEST_P(TwoTimer, StopsOnTheSameWay) {
    const Carved single = carved(profile(Schedule::single), job(41));
    std::mt19937_64 random(5);
    for (int round = 0; round < 6; ++round) {
        Disturbances stop;
        stop.stop_after = 1 + random() % (single.order.size() / 2);
        const Carved sut = carved(profile(Schedule::two_timer), job(41), stop);
        ASSERT_LT(sut.order.size(), single.order.size());
        EXPECT_TRUE(is_same_order(sut.order, single.order, has_moves()));
        EXPECT_EQ(sut.true_end, sut.end);
    }
}

TEST_P(TwoTimer, PutsPulsesOutAtItsOwnTimesOnly) {
    const Carved sut = carved(profile(Schedule::two_timer), job(51));
    SignalWord before = sut.writes.front().levels;
    for (std::size_t i = 1; i < sut.writes.size(); ++i) {
        const PortWrite& write = sut.writes[i];
        const SignalWord rising = write.levels & ~before;
        const SignalWord other = (write.levels ^ before) & ~kStepMask;
        const bool is_turn = rising != 0 || other != 0;
        ASSERT_EQ(write.time_ns % kIo_ns, is_turn ? 0 : kTick_ns);
        before = write.levels;
    }
}

INSTANTIATE_TEST_SUITE_P(
    OfBothPlanners, TwoTimer,
    ::testing::Combine(::testing::Values(psicarve::Planner::angle, psicarve::Planner::lookahead),
                       ::testing::Values(Joining::continuous, Joining::zigzag, Joining::spiral)),
    [](const auto& named) {
        return std::string{name_of(std::get<1>(named.param))} +
               (std::get<0>(named.param) == psicarve::Planner::angle ? "_by_angle" : "_ahead");
    });

TEST(TwoTimerPulses, WithinATickComeInTheSameOrderToo) {
    Profile profile = slow_profile(Schedule::two_timer);
    const Carved over_ticks = carved(profile, random_job(2, 60, 61));
    profile.port.pulses = PulseForm::within_tick;
    const Carved sut = carved(profile, random_job(2, 60, 61));
    EXPECT_EQ(sut.order, over_ticks.order);
    EXPECT_EQ(sut.true_end, sut.end);
}

TEST(TwoTimerPulses, AreNeitherLostNorDoubledWhereAxesHaveBacklash) {
    Profile profile = slow_profile(Schedule::two_timer, psicarve::Planner::lookahead);
    profile.r1.backlash_mm = 0.02;
    profile.r2.backlash_mm = 0.03;
    profile.psi.backlash_deg = 0.3;
    const Carved sut = carved(profile, random_job(2, 40, 71));
    EXPECT_EQ(sut.true_end, sut.end);
}

TEST(TwoTimerGate, LetsNoIterationInBeforeTheLastOneIsOut) {
    CycleConfig config;
    config.io_ticks = 5;
    PulseStage sut(config);
    ASSERT_TRUE(sut.may_step(0b0011, 1));
    sut.step(0b0011, 1);
    EXPECT_EQ(sut.levels() & kStepMask, 0U);
    EXPECT_EQ(sut.positions(), Positions{});
    EXPECT_FALSE(sut.may_step(0b0100, 2));
    EXPECT_TRUE(sut.may_step_apart(0b0100, 2));
    EXPECT_FALSE(sut.may_step_apart(0b0001, 2));
    ASSERT_TRUE(sut.open_gate(5));
    EXPECT_EQ(sut.levels() & kStepMask, 0b0011U);
    EXPECT_TRUE(sut.may_step(0b0100, 6));
    EXPECT_FALSE(sut.open_gate(10));
}

TEST(TwoTimerGate, DoesNotTurnADirectionBeforeThePulseThatWaits) {
    CycleConfig config;
    config.io_ticks = 5;
    PulseStage sut(config);
    sut.step(0b0001, 1);
    sut.want_directions({1, 0, 0, 0}, 2);
    EXPECT_FALSE(sut.may_step(0b0001, 3));
    sut.begin_tick(5);
    EXPECT_FALSE(sut.is_positive(0));
    ASSERT_TRUE(sut.open_gate(5));
    EXPECT_EQ(sut.positions()[0], -1);
    sut.begin_tick(10);
    EXPECT_TRUE(sut.is_positive(0));
    ASSERT_TRUE(sut.may_step(0b0001, 11));
    sut.step(0b0001, 11);
    // Set up at 10, so out a period later at the soonest.
    EXPECT_FALSE(sut.open_gate(10));
    ASSERT_TRUE(sut.open_gate(15));
    EXPECT_EQ(sut.positions()[0], 0);
}

/// Carving for so many ticks, with a limit that counts at once.
void carve_for(MachineRig& rig, std::uint64_t rounds) {
    ASSERT_TRUE(rig.prepare(random_job(2, 60, 81)));
    ASSERT_EQ(rig.ask(RequestKind::start_interpolation), Refusal::none);
    rig.run(rounds);
    ASSERT_EQ(rig.cycle->state(), MachineState::carving);
    rig.port->writes.clear();
}

TEST(TwoTimerLimit, EndsThePulsesWithinOnePeriodOfInputs) {
    Profile profile = slow_profile(Schedule::two_timer);
    profile.port.input_filter_us = 0.0;
    std::mt19937_64 random(11);
    for (int round = 0; round < 10; ++round) {
        MachineRig sut(profile);
        ASSERT_NO_FATAL_FAILURE(carve_for(sut, 200 + random() % 3000));
        const std::uint64_t tripped_tick = sut.cycle->next_tick();
        sut.machine->hold_input(Signal::r2_limit, true);
        sut.run(100);
        EXPECT_EQ(sut.cycle->state(), MachineState::alarm);
        EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::limit);
        for (const PortWrite& write : sut.port->writes) {
            EXPECT_LT(write.tick, tripped_tick + kIoTicks);
            EXPECT_EQ(write.levels & (kStepMask | kEnableMask | bit_of(Signal::spindle)), 0U);
        }
        ASSERT_EQ(sut.port->writes.size(), 1U);
        EXPECT_EQ(sut.positions()[0], sut.machine->position_pulses(Axis::r1));
    }
}

TEST(TwoTimerGap, LongerThanARotorCoastsIsAnAlarmInEitherThread) {
    for (const bool in_interpolation : {false, true}) {
        MachineRig sut(slow_profile(Schedule::two_timer));
        ASSERT_NO_FATAL_FAILURE(carve_for(sut, 500));
        if (in_interpolation) {
            sut.cycle->advance_missed_interpolation(5);
        } else {
            sut.cycle->advance_missed(1);
        }
        sut.tick();
        EXPECT_EQ(sut.cycle->state(), MachineState::carving) << "a short gap is only counted";
        in_interpolation ? sut.cycle->advance_missed_interpolation(60) : sut.cycle->advance_missed(12);
        sut.tick();
        EXPECT_EQ(sut.cycle->sample().alarm_cause, AlarmCause::tick_gap);
        EXPECT_EQ(sut.port->writes.back().levels & (kStepMask | kEnableMask), 0U);
    }
}

}  // namespace
}  // namespace psicarve::cycle
