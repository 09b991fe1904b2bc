// SPDX-License-Identifier: GPL-3.0-or-later
// Programs with lines and arcs by point-by-point comparison, on the whole core.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <set>
#include <vector>

#include "tests/motion/random_operator.hpp"
#include "tests/rtcore/cycle/program_rig.hpp"

namespace psicarve::cycle {
namespace {

using plan::test::Script;

constexpr std::size_t kSteppedY = index_of(Axis::y);

/// Lines, arcs both ways, a whole circle, a rounded way before and behind them.
Script mixed_steps(const Positions& from) {
    Script script{from};
    script.spindle(true).way({-200, 30, 50, 60}, 0.01, 0.05).stepped_line({-100, 0, 0, 70}, 0.1);
    script.stepped_arc({-100, 0, 0, 100}, {-100, 0}, true).stepped_arc({0, 0, 0, 0}, {60, 80}, false);
    script.dwell(0.01).stepped_line({0, 0, 0, -40}).stepped_line({30, 0, 0, 0}, 0.1);
    script.stepped_arc({150, 0, 0, -50}, {100, 50}, true, 0.5);
    script.way({20, 0, 40, 10}, 0.01).way({10, 20, 40, 0}, 0.01).spindle(false).end();
    return script;
}

/// Its pulses in their order, while somebody does what he likes.
std::vector<std::uint32_t> stepped_order(const Profile& profile, bool is_single,
                                         const std::function<void(ProgramRig&)>& disturb) {
    ProgramRig sut{profile};
    const Script script = mixed_steps(sut.positions());
    sut.give(script.steps);
    EXPECT_EQ(sut.start(is_single), Refusal::none);
    EXPECT_TRUE(sut.run_while([&] {
        disturb(sut);
        return sut.cycle->state() != MachineState::ready && sut.cycle->state() != MachineState::alarm;
    }));
    EXPECT_EQ(sut.cycle->state(), MachineState::ready);
    EXPECT_EQ(sut.positions(), script.at());
    EXPECT_EQ(sut.program().line, script.steps.size());
    EXPECT_EQ(sut.program().starvations, 0U);
    const sim::SimReport report = sut.machine->report();
    for (const Axis axis : kAllAxes) EXPECT_EQ(report.axis(axis).stalls, 0U) << name_of(axis);
    return order_of(sut.port->writes);
}

TEST(SteppedProgram, KeepsTheOrderOfItsPulsesHoweverItIsHeldAndOverridden) {
    const auto resume = [](ProgramRig& rig) {
        if (rig.cycle->state() == MachineState::held) rig.ask(RequestKind::resume);
    };
    // Block by block its rounded ways end at rest.
    const std::array plain{stepped_order(program_profile(), false, resume),
                           stepped_order(program_profile(), true, resume)};
    ASSERT_GT(plain[0].size(), 1'500U);
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        motion::Operator hand{seed, 3'000, motion::Operator::Of::programs};
        int holds = 0;
        const auto disturbed = stepped_order(program_profile(), seed % 2 == 0, [&](ProgramRig& rig) {
            if (rig.cycle->state() == MachineState::held) ++holds;
            hand(rig);
        });
        EXPECT_EQ(disturbed, plain[seed % 2 == 0 ? 1 : 0]) << "seed " << seed;
        EXPECT_GT(holds, 0) << "seed " << seed;
    }
}

TEST(SteppedProgram, EndsWhereItSaysOnOtherMachines) {
    Profile worn = program_profile();
    worn.r1.backlash_mm = 0.02;
    worn.y.backlash_mm = 0.05;
    Profile lifting = program_profile();
    lifting.job.lifts_on_hold = true;
    for (const Profile& profile : {worn, lifting}) {
        motion::Operator hand{5, 10'000, motion::Operator::Of::programs};
        stepped_order(profile, false, [](ProgramRig&) {});
        stepped_order(profile, false, hand);
    }
}

TEST(SteppedProgram, RestsBehindEachOfItsBlocksWhereOneAtATimeIsAskedFor) {
    std::set<std::uint64_t> lines;
    stepped_order(program_profile(), true, [&](ProgramRig& rig) {
        if (rig.cycle->state() != MachineState::held) return;
        EXPECT_EQ(rig.program().hold, ProgramHold::single);
        lines.insert(rig.program().line);
        rig.ask(RequestKind::resume);
    });
    EXPECT_EQ(lines, (std::set<std::uint64_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
}

Profile two_timer_profile() {
    Profile profile = program_profile();
    profile.tick.schedule = Schedule::two_timer;
    profile.tick.period_us = 100.0;
    profile.psi.speed_deg_s = 112.5;
    profile.psi.accel_deg_s2 = 1125.0;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->speed_mm_s *= 0.5;
        axis->accel_mm_s2 *= 0.5;
    }
    return profile;
}

TEST(SteppedProgram, RunsOnTwoTimersWithTheSamePulses) {
    const auto plain = stepped_order(two_timer_profile(), false, [](ProgramRig&) {});
    ASSERT_GT(plain.size(), 1'500U);
    for (const std::uint64_t seed : {3U, 4U}) {
        motion::Operator hand{seed, 3'000, motion::Operator::Of::programs};
        EXPECT_EQ(stepped_order(two_timer_profile(), false, hand), plain) << seed;
    }
}

// Its records do not come: it rests where the last one that has come ends, is held there, and goes on.
TEST(SteppedProgram, RestsBetweenItsRecordsWhereTheyAreLate) {
    for (const Profile& profile : {program_profile(), two_timer_profile()}) {
        const auto plain = stepped_order(profile, false, [](ProgramRig&) {});
        // Behind a line, an arc, a whole circle, and two lines that do not move both axes.
        for (const std::size_t come : {3U, 4U, 5U, 7U, 8U, 9U}) {
            ProgramRig sut{profile};
            const Script script = mixed_steps(sut.positions());
            const auto source = sut.give(script.steps);
            source->written = come;
            ASSERT_EQ(sut.start(), Refusal::none);
            ASSERT_TRUE(sut.run_until(MachineState::held)) << come;
            EXPECT_EQ(sut.program().hold, ProgramHold::starved);
            EXPECT_EQ(sut.program().starvations, 1U);
            EXPECT_EQ(sut.program().line, come);
            EXPECT_EQ(sut.positions(), script.steps[come - 1].target_pulses) << come;
            sut.run(3 * kPatienceTicks);
            EXPECT_EQ(sut.cycle->state(), MachineState::held);
            EXPECT_EQ(sut.positions(), script.steps[come - 1].target_pulses) << come;
            source->written = script.steps.size();
            ASSERT_TRUE(sut.run_until(MachineState::ready)) << come;
            EXPECT_EQ(sut.program().starvations, 1U);
            EXPECT_EQ(sut.positions(), script.at());
            EXPECT_EQ(order_of(sut.port->writes), plain) << come;
        }
    }
}

// A block is a run of steps of one axis: of a large circle there are more than wait for the tick at once.
TEST(SteppedProgram, HasArcsOfMoreBlocksThanTheQueueHolds) {
    Profile profile = program_profile();
    profile.r1.travel_mm = {0.0, 40.0};
    profile.r1.home_position_mm = 40.0;
    profile.y.travel_mm = {0.0, 40.0};
    ProgramRig sut{profile};
    constexpr std::int64_t kRadius = 6'000;
    Script script{sut.positions()};
    script.way({0, 0, 0, 7'000}, 0.0);
    const Positions begin = script.at();
    script.stepped_arc({0, 0, 0, 0}, {-kRadius, 0}, true).end();
    sut.give(script.steps);
    ASSERT_EQ(sut.start(), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.program().starvations, 0U);
    EXPECT_EQ(sut.positions(), begin);
    PinCounter pins{{begin[0], begin[1], begin[2], begin[kSteppedY] - 7'000}};
    PointByPoint way = PointByPoint::arc({kRadius, 0}, {kRadius, 0}, true);
    std::size_t runs = 0;
    std::uint32_t before = 0;
    bool is_on_arc = false;
    for (const PortWrite& write : sut.port->writes) {
        const std::uint32_t axes = pins.take(write.levels);
        if (axes != 0 && is_on_arc) {
            ASSERT_FALSE(way.is_finished());
            way.next();
            ASSERT_EQ(pins.positions()[0], begin[0] - kRadius + way.at().x);
            ASSERT_EQ(pins.positions()[kSteppedY], begin[kSteppedY] + way.at().y);
            if (axes != before) ++runs;
            before = axes;
        }
        is_on_arc = is_on_arc || pins.positions() == begin;
    }
    EXPECT_TRUE(way.is_finished());
    EXPECT_GT(runs, kBlockRingEntries);
}

}  // namespace
}  // namespace psicarve::cycle
