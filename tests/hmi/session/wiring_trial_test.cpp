// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/wiring_trial.hpp"

#include <gtest/gtest.h>

#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using std::chrono::seconds;
using test::machine_in;
using S = MachineState;

std::string lock(const MachineView& machine) {
    const auto why = wiring_lock(machine);
    return why ? in_english(*why) : "";
}

TEST(WiringLock, OpensOnlyWhenTheDrivesAreOff) {
    EXPECT_EQ(lock(machine_in(S::off, 0)), "");
    EXPECT_EQ(lock(machine_in(S::testing, 0)), "");
    EXPECT_EQ(lock(machine_in(S::ready)), "Wiring test: switch the drives off first");
    EXPECT_EQ(lock(machine_in(S::alarm)), "Locked until the alarm is reset");
    EXPECT_EQ(lock(machine_in(S::carving)), "Locked while carving");
    EXPECT_EQ(lock(MachineView{}), "No core serves the segment");
    MachineView pressed = machine_in(S::off, 0);
    pressed.status->signals = bit_of(Signal::estop);
    EXPECT_EQ(lock(pressed), "The emergency stop switch is still pressed");
}

TEST(WiringTrial, IsOverWhenNothingWasTestedForAWhile) {
    constexpr WiringTrial::Clock::time_point kNow{std::chrono::hours{1}};
    WiringTrial sut;
    EXPECT_EQ(sut.left(kNow), seconds{0});
    sut.arm(kNow);
    EXPECT_EQ(sut.left(kNow), seconds{30});
    EXPECT_EQ(sut.left(kNow + seconds{29}), seconds{1});
    sut.use(kNow + seconds{29});
    EXPECT_EQ(sut.left(kNow + seconds{30}), seconds{29});
    EXPECT_EQ(sut.left(kNow + seconds{99}), seconds{0});
    sut.disarm();
    EXPECT_EQ(sut.left(kNow + seconds{29}), seconds{0});
}

}  // namespace
}  // namespace psicarve::session
