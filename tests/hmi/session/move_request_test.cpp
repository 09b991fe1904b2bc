// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/move_request.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using test::machine_in;
using S = MachineState;

MoveRequest to(std::initializer_list<Axis> axes, MoveShape shape = MoveShape::straight) {
    MoveRequest request;
    request.shape = shape;
    for (const Axis axis : axes) request.target[index_of(axis)] = 10.0 + static_cast<double>(index_of(axis));
    return request;
}

std::string lock(const MoveRequest& request, S state = S::ready) {
    const auto why = move_lock(machine_in(state), request);
    return why ? in_english(*why) : std::string{};
}

TEST(MoveRequest, WantsAnAxisAndAMachineThatIsReady) {
    EXPECT_EQ(lock(to({})), "Go to: choose an axis");
    EXPECT_EQ(lock(to({Axis::psi})), "");
    EXPECT_EQ(lock(to({Axis::y}), S::moving), "Locked while an axis moves");
    EXPECT_EQ(lock(to({Axis::y}), S::carving), "Locked while carving");
    EXPECT_EQ(lock(to({Axis::y}), S::alarm), "Locked until the alarm is reset");
}

TEST(MoveRequest, TakesTheShapesThatTheCoreKnows) {
    using M = MoveShape;
    EXPECT_EQ(lock(to({Axis::r1, Axis::r2, Axis::psi, Axis::y})), "");
    EXPECT_EQ(lock(to({Axis::r1, Axis::r2}, M::stepped)), "");
    EXPECT_EQ(lock(to({Axis::r1, Axis::r2, Axis::y}, M::stepped)), "Go to: two axes at most, step by step");
    EXPECT_EQ(lock(to({Axis::psi}, M::stepped)), "Go to: Ψ moves in straight lines only");
    EXPECT_EQ(lock(to({Axis::r2, Axis::y}, M::arc)), "");
    EXPECT_EQ(lock(to({Axis::r1, Axis::r2}, M::clockwise)), "Go to: an arc is of one head and Y");
    EXPECT_EQ(lock(to({Axis::y}, M::arc)), "Go to: an arc is of one head and Y");
}

TEST(MoveRequest, BecomesTheCommandOfTheCommandLine) {
    MoveRequest sut = to({Axis::r1, Axis::y}, MoveShape::clockwise);
    sut.centre = {30.0, 99.0, 99.0, 31.0};
    const Command command = move_command(sut);
    EXPECT_EQ(command.kind, CommandKind::move);
    EXPECT_EQ(command.axis, 0b1001U);
    EXPECT_EQ(command.shape, MoveShape::clockwise);
    EXPECT_EQ(command.target[index_of(Axis::r1)], 10.0);
    EXPECT_EQ(command.target[index_of(Axis::y)], 13.0);
    EXPECT_EQ(command.centre[index_of(Axis::r1)], 30.0);
    EXPECT_EQ(command.centre[index_of(Axis::y)], 31.0);
    EXPECT_EQ(command.centre[index_of(Axis::psi)], 0.0) << "not moved";
}

TEST(MoveRequest, LeavesTheSpindleFreeWhileAnAxisMoves) {
    EXPECT_FALSE(spindle_lock(machine_in(S::moving)));
    EXPECT_FALSE(spindle_lock(machine_in(S::ready)));
    EXPECT_TRUE(spindle_lock(machine_in(S::carving)));
    EXPECT_TRUE(spindle_lock(machine_in(S::off)));
}

}  // namespace
}  // namespace psicarve::session
