// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/refused_order.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "hmi/machine/machine_link.hpp"
#include "shared/machine/message_argument.hpp"
#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using S = MachineState;
using OrderHelp = OrderRefusal::Help;
using test::machine_in;

constexpr std::uint8_t kR1Homed = 1;

RefusedOrder refused(OrderHelp help, const MachineView& machine) {
    RefusedOrder sut;
    sut.note({OrderPlace::job, phrase("Start"), help}, machine);
    return sut;
}

/// The core has written its status since it answered.
MachineView settled(MachineView machine) {
    machine.status->heartbeat += 100;
    return machine;
}

TEST(RefusedOrder, StaysWhileTheMachineIsAsItWas) {
    const MachineView machine = machine_in(S::ready);
    RefusedOrder sut = refused(OrderHelp::none, machine);
    for (int look = 0; look < 3; ++look) sut.look(settled(machine));
    ASSERT_TRUE(sut.told());
    EXPECT_EQ(sut.told()->place, OrderPlace::job);
    sut.forget(OrderPlace::jog);
    EXPECT_TRUE(sut.told()) << "another field";
    sut.forget(OrderPlace::job);
    EXPECT_FALSE(sut.told());
}

TEST(RefusedOrder, IsOfTheStatusThatTheCoreWritesRightAfterItsAnswer) {
    MachineView machine = machine_in(S::ready);
    RefusedOrder sut = refused(OrderHelp::reset_alarm, machine);
    machine.status->state = S::alarm;
    ++machine.status->heartbeat;
    sut.look(machine);
    sut.look(settled(machine));
    EXPECT_TRUE(sut.told());
    machine.status->state = S::off;
    sut.look(settled(machine));
    EXPECT_FALSE(sut.told());
}

struct Change {
    std::string name;
    std::function<void(MachineView&)> change;
};
class RefusedOrderOf : public ::testing::TestWithParam<Change> {};

TEST_P(RefusedOrderOf, GoesWithAMachineThatIsAnother) {
    MachineView machine = machine_in(S::ready);
    RefusedOrder sut = refused(OrderHelp::none, machine);
    machine = settled(machine);
    sut.look(machine);
    ASSERT_TRUE(sut.told());
    GetParam().change(machine);
    sut.look(machine);
    EXPECT_FALSE(sut.told());
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedOrderOf,
    ::testing::Values(Change{"State", [](MachineView& m) { m.status->state = S::homing; }},
                      Change{"Homing", [](MachineView& m) { m.status->homed_mask = kR1Homed; }},
                      Change{"Job", [](MachineView& m) { ++m.status->job_generation; }},
                      Change{"Alarm", [](MachineView& m) { ++m.status->alarm_count; }},
                      Change{"Switch", [](MachineView& m) { m.status->signals |= bit_of(Signal::y_limit); }},
                      Change{"Position", [](MachineView& m) { ++m.status->position_pulses[0]; }},
                      Change{"Core", [](MachineView& m) { ++m.core_pid; }},
                      Change{"Silence", [](MachineView& m) { m.life = CoreLife::silent; }}),
    [](const auto& change) { return change.param.name; });

TEST(RefusedOrder, OffersNoHomingThatIsDoneAndNoAlarmThatIsGone) {
    RefusedOrder homing = refused(OrderHelp::home_all, machine_in(S::off, 0));
    homing.look(settled(machine_in(S::off, 0)));
    EXPECT_TRUE(homing.told());
    RefusedOrder done = refused(OrderHelp::home_all, machine_in(S::ready));
    done.look(settled(machine_in(S::ready)));
    EXPECT_FALSE(done.told());
    RefusedOrder alarm = refused(OrderHelp::reset_alarm, machine_in(S::ready));
    alarm.look(settled(machine_in(S::ready)));
    EXPECT_FALSE(alarm.told());
}

TEST(RefusedOrder, KnowsWhatHelpsByTheCoresMessage) {
    const auto wrong_state = [](CommandKind kind, S state) {
        return message_of(MessageId::wrong_state, argument_of(kind), argument_of(state), way_out_of(state));
    };
    EXPECT_EQ(help_for(message_of(MessageId::not_homed)), OrderHelp::home_all);
    EXPECT_EQ(help_for(wrong_state(CommandKind::jog, S::off)), OrderHelp::home_all);
    EXPECT_EQ(help_for(message_of(MessageId::heads_not_homed)), OrderHelp::home_all);
    EXPECT_EQ(help_for(wrong_state(CommandKind::home, S::alarm)), OrderHelp::reset_alarm);
    EXPECT_EQ(help_for(wrong_state(CommandKind::home, S::carving)), OrderHelp::none);
    CoreStatus in_alarm{};
    in_alarm.alarm_cause = AlarmCause::limit;
    for (const std::uint8_t axis : {std::uint8_t{0}, kNoAxis}) {
        in_alarm.alarm_axis = axis;
        EXPECT_EQ(help_for(machine::alarm_error(in_alarm).said), OrderHelp::reset_alarm);
    }
    EXPECT_EQ(help_for(message_of(MessageId::port_failed)), OrderHelp::reset_alarm);
    EXPECT_EQ(
        help_for(message_of(MessageId::at_the_end, argument_of(CommandKind::jog), argument_of(Axis::r1))),
        OrderHelp::none);
    EXPECT_EQ(help_for({}), OrderHelp::none);
}

}  // namespace
}  // namespace psicarve::session
