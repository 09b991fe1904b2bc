// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/pin_follower.hpp"

#include <gtest/gtest.h>

namespace psicarve::replay {
namespace {

constexpr SignalWord kOn = bit_of(Signal::y_enable);

Profile with_gap_of_4() {
    Profile profile;
    profile.y.backlash_mm = 4.0 / 400.0;
    return profile;
}

/// Y's tip, from 100, after so many pulses up.
std::int64_t y_after(std::int64_t crossed_pulses, int pulses) {
    verify::TraceStart start;
    start.initial_levels = kOn;
    start.position_pulses[index_of(Axis::y)] = 100;
    start.crossed_pulses[index_of(Axis::y)] = crossed_pulses;
    PinFollower sut{start, with_gap_of_4()};
    const SignalWord up = kOn | bit_of(Signal::y_dir);
    std::int64_t time_ns = 0;
    for (; pulses > 0; --pulses) {
        sut.take({.time_ns = ++time_ns, .levels = up | bit_of(Signal::y_step)});
        sut.take({.time_ns = ++time_ns, .levels = up});
    }
    return sut.moment().position_pulses[index_of(Axis::y)];
}

TEST(PinFollower, BeginsWithTheGapsAsTheTraceTellsThem) {
    EXPECT_EQ(y_after(0, 6), 106);
    EXPECT_EQ(y_after(3, 3), 100);
    EXPECT_EQ(y_after(3, 6), 103);
    EXPECT_EQ(y_after(4, 6), 102);
}

TEST(PinFollower, ShowsATraceOfAWiderGapAsIfThisOneWereCrossed) {
    EXPECT_EQ(y_after(9, 6), 102);
}

}  // namespace
}  // namespace psicarve::replay
