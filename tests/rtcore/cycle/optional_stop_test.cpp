// SPDX-License-Identifier: GPL-3.0-or-later
// M1 that an operator switches while a program runs.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "shared/machine/command.hpp"
#include "tests/rtcore/cycle/program_rig.hpp"

namespace psicarve::cycle {
namespace {

using plan::test::Script;

using Holds = std::vector<std::pair<std::uint64_t, ProgramHold>>;

/// Lines in which a program was held and why, each resumed.
Holds optional_holds(ProgramRig& sut) {
    Holds holds;
    while (sut.run_while([&] {
        return sut.cycle->state() != MachineState::held && sut.cycle->state() != MachineState::ready;
    }) && sut.cycle->state() == MachineState::held) {
        holds.emplace_back(sut.program().line, sut.program().hold);
        EXPECT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    }
    return holds;
}

Refusal start_with(ProgramRig& sut, std::uint32_t switches) {
    return sut.ask(RequestKind::run_program, static_cast<std::uint8_t>(switches), kProgram);
}

/// Six ways under G64; behind the second and the fifth, in lines 3 and 7, M1.
Script curve_with(const Positions& from, StopReason reason, bool has_stops = true) {
    Script script{from};
    for (int i = 0; i < 6; ++i) {
        script.way({i % 2 == 0 ? -40 : 40, 0, 60, 20}, 0.01, 0.02);
        if (has_stops && (i == 1 || i == 4)) script.stop(reason);
    }
    script.end();
    return script;
}

struct Ran {
    std::vector<std::uint32_t> order;
    std::uint64_t ticks = 0;
    Holds holds;
};
Ran run_of(StopReason reason, std::uint32_t switches, bool has_stops = true) {
    ProgramRig sut;
    const Script script = curve_with(sut.positions(), reason, has_stops);
    sut.give(script.steps);
    EXPECT_EQ(start_with(sut, switches), Refusal::none);
    const std::uint64_t begin = sut.cycle->next_tick();
    Ran ran;
    ran.holds = optional_holds(sut);
    ran.ticks = sut.cycle->next_tick() - begin;
    ran.order = order_of(sut.port->writes);
    EXPECT_EQ(sut.positions(), script.at());
    return ran;
}

TEST(OptionalStop, IsNothingAtAllWhileItsSwitchIsOff) {
    const Ran without = run_of(StopReason::optional_on_way, 0, false);
    const Ran off = run_of(StopReason::optional_on_way, 0);
    EXPECT_EQ(off.holds, Holds{});
    EXPECT_EQ(off.ticks, without.ticks) << "it does not even rest";
    EXPECT_EQ(off.order, without.order);
}

TEST(OptionalStop, HoldsOnTheCurveWhereItsSwitchIsOn) {
    const Ran off = run_of(StopReason::optional_on_way, 0);
    const Ran on = run_of(StopReason::optional_on_way, kProgramStopsAtOptional);
    EXPECT_EQ(on.holds, (Holds{{2, ProgramHold::optional}, {6, ProgramHold::optional}}));
    EXPECT_EQ(on.order, off.order) << "pulses and their order stay";
    EXPECT_GT(on.ticks, off.ticks);
}

TEST(OptionalStop, OfAPlannedRestWaitsOnlyWhileItsSwitchIsOn) {
    const Ran on = run_of(StopReason::optional_at_rest, kProgramStopsAtOptional);
    EXPECT_EQ(on.holds, (Holds{{3, ProgramHold::optional}, {7, ProgramHold::optional}}));
    EXPECT_EQ(run_of(StopReason::optional_at_rest, 0).holds, Holds{});
}

TEST(OptionalStop, OfAnOlderWriterAlwaysWaits) {
    EXPECT_EQ(run_of(StopReason::optional, 0).holds,
              (Holds{{3, ProgramHold::optional}, {7, ProgramHold::optional}}));
}

TEST(OptionalStop, IsSwitchedFromTheNextOneOnAndBack) {
    ProgramRig sut;
    EXPECT_EQ(sut.ask(RequestKind::optional_stop, 0, 1), Refusal::no_program);
    const Script script = curve_with(sut.positions(), StopReason::optional_on_way);
    sut.give(script.steps);
    ASSERT_EQ(start_with(sut, 0), Refusal::none);
    EXPECT_EQ(sut.program().stops_at_optional, 0U);
    // Behind the first of the two.
    ASSERT_TRUE(sut.run_while([&] { return sut.program().line < 4; }));
    ASSERT_EQ(sut.ask(RequestKind::optional_stop, 0, 1), Refusal::none);
    EXPECT_EQ(sut.program().stops_at_optional, 1U);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    EXPECT_EQ(sut.program().line, 6U);
    EXPECT_EQ(sut.program().hold, ProgramHold::optional);
    EXPECT_EQ(sut.program().is_single, 0U);
    ASSERT_EQ(sut.ask(RequestKind::optional_stop, 0, 0), Refusal::none);
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.positions(), script.at());
    EXPECT_EQ(sut.ask(RequestKind::optional_stop, 0, 0), Refusal::no_program);
}

// Before the first way, behind a dwell, behind a way from rest to rest, and as the last before the end.
TEST(OptionalStop, HoldsWhereItStandsAtRest) {
    for (const bool is_on : {false, true}) {
        ProgramRig sut;
        Script script{sut.positions()};
        constexpr StopReason kM1 = StopReason::optional_on_way;
        script.stop(kM1).way({-40, 0, 60, 20}, 0.0).stop(kM1).dwell(0.01).stop(kM1);
        script.stepped_line({-20, 0, 10, 0}).stop(kM1).way({0, 0, 30, 0}, 0.01).stop(kM1).end();
        sut.give(script.steps);
        ASSERT_EQ(start_with(sut, is_on ? kProgramStopsAtOptional : 0), Refusal::none);
        Holds expected;
        // The last one is told of the way behind which it stands.
        for (const std::uint64_t line : {1U, 3U, 5U, 7U, 8U})
            if (is_on) expected.emplace_back(line, ProgramHold::optional);
        EXPECT_EQ(optional_holds(sut), expected);
        EXPECT_EQ(sut.positions(), script.at());
    }
}

TEST(OptionalStop, RestsOnceOnTheCurveForItAndForSingleBlock) {
    const auto run = [](std::uint32_t switches) {
        ProgramRig sut;
        Script script = curve_with(sut.positions(), StopReason::optional_on_way);
        sut.give(script.steps);
        EXPECT_EQ(start_with(sut, 0), Refusal::none);
        if ((switches & kProgramIsSingle) != 0) {
            EXPECT_EQ(sut.ask(RequestKind::single, 0, 1), Refusal::none);
        }
        if ((switches & kProgramStopsAtOptional) != 0) {
            EXPECT_EQ(sut.ask(RequestKind::optional_stop, 0, 1), Refusal::none);
        }
        return optional_holds(sut);
    };
    constexpr auto kSingleHold = ProgramHold::single;
    EXPECT_EQ(run(kProgramIsSingle | kProgramStopsAtOptional), (Holds{{1, kSingleHold},
                                                                      {2, ProgramHold::optional},
                                                                      {4, kSingleHold},
                                                                      {5, kSingleHold},
                                                                      {6, ProgramHold::optional},
                                                                      {8, kSingleHold}}));
    EXPECT_EQ(run(kProgramIsSingle), (Holds{{1, kSingleHold},
                                            {2, kSingleHold},
                                            {4, kSingleHold},
                                            {5, kSingleHold},
                                            {6, kSingleHold},
                                            {8, kSingleHold}}));
}

/// Six ways under G64, each of many ticks; behind the second and the fifth, in lines 3 and 7, M1.
Script long_curve(const Positions& from) {
    Script script{from};
    for (int i = 0; i < 6; ++i) {
        script.way({i % 2 == 0 ? 200 : -200, 0, 900, 300}, 0.01, 0.0);
        if (i == 1 || i == 4) script.stop(StopReason::optional_on_way);
    }
    script.end();
    return script;
}

const Holds kBothStops{{2, ProgramHold::optional}, {6, ProgramHold::optional}};

/// Runs that curve with these switches once for each of some 60 instants up to its first rest, at which
/// `disturb` is done, and gives what held each of them.
template <typename Disturb>
std::vector<Holds> disturbed_runs(std::uint32_t switches, std::uint32_t single, const Disturb& disturb) {
    const auto begin = [&](ProgramRig& sut) {
        sut.give(long_curve(sut.positions()).steps);
        EXPECT_EQ(start_with(sut, switches), Refusal::none);
        if (single != 0) {
            EXPECT_EQ(sut.ask(RequestKind::single, 0, 1), Refusal::none);
        }
        return sut.cycle->next_tick();
    };
    ProgramRig first;
    const std::uint64_t from = begin(first);
    EXPECT_TRUE(first.run_until(MachineState::held));
    const std::uint64_t ticks = first.cycle->next_tick() - from;
    std::vector<Holds> runs;
    for (std::uint64_t after = 1; after < ticks; after += ticks / 60) {
        ProgramRig sut;
        const Script script = long_curve(sut.positions());
        (void)begin(sut);
        sut.run(after);
        disturb(sut);
        runs.push_back(optional_holds(sut));
        EXPECT_EQ(sut.positions(), script.at());
    }
    EXPECT_GE(runs.size(), 60U);
    return runs;
}

TEST(OptionalStop, IsNotPassedBecauseSingleBlockIsTurned) {
    for (const Holds& holds : disturbed_runs(kProgramStopsAtOptional, 0, [](ProgramRig& sut) {
             EXPECT_EQ(sut.ask(RequestKind::single, 0, 1), Refusal::none);
             EXPECT_EQ(sut.ask(RequestKind::single, 0, 0), Refusal::none);
         }))
        EXPECT_EQ(holds, kBothStops);
}

TEST(OptionalStop, HoldsOnceSingleBlockHasHeldBeforeIt) {
    for (const Holds& holds : disturbed_runs(kProgramStopsAtOptional, 0, [](ProgramRig& sut) {
             EXPECT_EQ(sut.ask(RequestKind::single, 0, 1), Refusal::none);
         })) {
        Holds optional;
        for (const auto& hold : holds)
            if (hold.second == ProgramHold::optional) optional.push_back(hold);
        EXPECT_EQ(optional, kBothStops);
        EXPECT_GE(holds.size(), 4U) << "lines 4, 5 and 8 hold in any case, but for those passed too fast";
    }
}

TEST(OptionalStop, ThatIsTurnedLosesNoEndOfALineOfSingleBlock) {
    for (const Holds& holds : disturbed_runs(0, 1, [](ProgramRig& sut) {
             EXPECT_EQ(sut.ask(RequestKind::optional_stop, 0, 1), Refusal::none);
             EXPECT_EQ(sut.ask(RequestKind::optional_stop, 0, 0), Refusal::none);
         })) {
        ASSERT_FALSE(holds.empty());
        EXPECT_EQ(holds.front(), (std::pair{std::uint64_t{1}, ProgramHold::single}));
    }
}

TEST(OptionalStop, IsNotPassedByOverridesAndHoldsOnTheWay) {
    for (const Holds& holds : disturbed_runs(kProgramStopsAtOptional, 0, [](ProgramRig& sut) {
             EXPECT_EQ(sut.ask(RequestKind::override, 0, 200), Refusal::none);
             sut.run(50);
             EXPECT_EQ(sut.ask(RequestKind::override, 0, 20), Refusal::none);
         }))
        EXPECT_EQ(holds, kBothStops);
    for (Holds holds : disturbed_runs(kProgramStopsAtOptional, 0, [](ProgramRig& sut) {
             EXPECT_EQ(sut.ask(RequestKind::hold), Refusal::none);
         })) {
        ASSERT_FALSE(holds.empty());
        // A hold that comes to rest at the optional stop itself is told as what it was asked for.
        if (holds.front().second != ProgramHold::optional) holds.erase(holds.begin());
        EXPECT_TRUE(holds == kBothStops || holds == Holds{kBothStops.back()});
    }
}

// It brakes for the far M1 in all of what is left, by its plan at twice the feed: ends of lines before it are
// within reach.
TEST(OptionalStop, ThatIsBrakedForHidesNoNearerEndOfALine) {
    ProgramRig sut;
    Script script{sut.positions()};
    for (int i = 0; i < 400; ++i) script.way({0, 0, 3, 1}, 0.01, 0.0);
    script.stop(StopReason::optional_on_way).way({0, 0, 40, 0}, 0.01, 0.0).end();
    sut.give(script.steps);
    ASSERT_EQ(start_with(sut, kProgramStopsAtOptional), Refusal::none);
    ASSERT_EQ(sut.ask(RequestKind::override, 0, 40), Refusal::none);
    ASSERT_TRUE(sut.run_while([&] { return sut.program().line < 385; }));
    ASSERT_EQ(sut.ask(RequestKind::single, 0, 1), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    EXPECT_LE(sut.program().line, 395U);
    EXPECT_EQ(sut.program().hold, ProgramHold::single);
}

}  // namespace
}  // namespace psicarve::cycle
