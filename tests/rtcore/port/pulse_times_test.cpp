// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/pulse_times.hpp"

#include <gtest/gtest.h>

#include <random>

namespace psicarve::port {
namespace {

constexpr SignalWord kOn = bit_of(Signal::r1_enable) | bit_of(Signal::y_enable);
constexpr SignalWord kStep = bit_of(Signal::r1_step);
constexpr SignalWord kDir = bit_of(Signal::r1_dir);

PortProfile driver() {
    PortProfile port;
    port.step_high_ns = 10'000;
    port.step_low_ns = 20'000;
    port.dir_setup_ns = 30'000;
    port.dir_hold_ns = 40'000;
    return port;
}

TEST(PulseTimes, TheFirstEdgesMayComeAtAnyTime) {
    const PulseTimes sut{driver()};
    for (const SignalWord to : {kOn | kStep, kOn | kDir, kOn | kStep | kDir}) {
        EXPECT_LT(sut.earliest_ns(kOn, to), 0);
    }
}

TEST(PulseTimes, CountFromWhenAnEdgeWasWritten) {
    PulseTimes sut{driver()};
    sut.note(kOn, kOn | kDir, 1'000'000);
    EXPECT_EQ(sut.earliest_ns(kOn | kDir, kOn | kDir | kStep), 1'030'000) << "setup";
    sut.note(kOn | kDir, kOn | kDir | kStep, 1'050'000);
    EXPECT_EQ(sut.earliest_ns(kOn | kDir | kStep, kOn | kDir), 1'060'000) << "high";
    EXPECT_EQ(sut.earliest_ns(kOn | kDir | kStep, kOn | kStep), 1'090'000) << "hold";
    EXPECT_EQ(sut.earliest_ns(kOn | kDir | kStep, kOn), 1'090'000) << "the later of two";
    sut.note(kOn | kDir | kStep, kOn | kDir, 1'070'000);
    EXPECT_EQ(sut.earliest_ns(kOn | kDir, kOn | kDir | kStep), 1'090'000) << "low";
}

TEST(PulseTimes, OfOneAxisAreNotThoseOfAnother) {
    PulseTimes sut{driver()};
    sut.note(kOn, kOn | kStep, 1'000'000);
    EXPECT_LT(sut.earliest_ns(kOn | kStep, kOn | kStep | bit_of(Signal::y_step)), 0);
    EXPECT_LT(sut.earliest_ns(kOn | kStep, kOn | kStep | bit_of(Signal::y_dir)), 0);
    EXPECT_LT(sut.earliest_ns(kOn | kStep, kOn | kStep | bit_of(Signal::spindle)), 0);
}

TEST(PulseTimes, NeverHoldUpWhatMakesTheMachineSafe) {
    PulseTimes sut{driver()};
    sut.note(kOn, kOn | kStep | kDir, 1'000'000);
    EXPECT_LT(sut.earliest_ns(kOn | kStep | kDir, kDir), 0);
    EXPECT_LT(sut.earliest_ns(kOn | kStep | kDir, 0), 0);
    EXPECT_EQ(sut.earliest_ns(kOn | kStep | kDir, kOn | kDir), 1'010'000) << "drives are on";
}

// Whatever is asked for and however late it comes: no two edges closer than the driver's times, and no wait
// longer than the longest of them.
TEST(PulseTimes, HoldForAnyOrderOfWrites) {
    std::mt19937 random(11);
    const PortProfile port = driver();
    PulseTimes sut{port};
    SignalWord levels = kOn;
    std::int64_t now_ns = 0;
    std::int64_t rose_ns = -1'000'000;
    std::int64_t fell_ns = rose_ns;
    std::int64_t turned_ns = rose_ns;
    for (int n = 0; n < 10'000; ++n) {
        now_ns += static_cast<std::int64_t>(random() % 25'000);
        const SignalWord wanted = levels ^ (random() % 3 == 0 ? kDir : kStep);
        const std::int64_t earliest_ns = sut.earliest_ns(levels, wanted);
        ASSERT_LE(earliest_ns - now_ns, 40'000);
        now_ns = std::max(now_ns, earliest_ns);
        if (((levels ^ wanted) & kDir) != 0) {
            ASSERT_GE(now_ns - rose_ns, port.dir_hold_ns);
            turned_ns = now_ns;
        } else if ((wanted & kStep) != 0) {
            ASSERT_GE(now_ns - fell_ns, port.step_low_ns);
            ASSERT_GE(now_ns - turned_ns, port.dir_setup_ns);
            rose_ns = now_ns;
        } else {
            ASSERT_GE(now_ns - rose_ns, port.step_high_ns);
            fell_ns = now_ns;
        }
        sut.note(levels, wanted, now_ns);
        levels = wanted;
    }
}

}  // namespace
}  // namespace psicarve::port
