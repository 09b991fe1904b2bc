// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/level_history.hpp"

#include <gtest/gtest.h>

namespace psicarve::session {
namespace {

using namespace std::chrono_literals;

TEST(LevelHistory, CountsStepsBetweenLooksAndKeepsTwentySeconds) {
    LevelHistory sut;
    const LevelHistory::Clock::time_point begin{};
    CoreStatus status{};
    status.emitted_pulses[0] = 500;
    sut.note(status, begin);
    EXPECT_EQ(sut.looks().back().pulses[0], 0U) << "what was before is not known";
    status.emitted_pulses[0] = 540;
    status.signals = bit_of(Signal::spindle);
    sut.note(status, begin + 33ms);
    EXPECT_EQ(sut.looks().back().pulses[0], 40U);
    EXPECT_EQ(sut.looks().back().levels, bit_of(Signal::spindle));
    status.emitted_pulses[0] = 0;
    sut.note(status, begin + 66ms);
    EXPECT_EQ(sut.looks().back().pulses[0], 0U) << "another job";
    for (int i = 1; i <= 1000; ++i) sut.note(status, begin + 66ms + i * 33ms);
    EXPECT_GE(sut.looks().back().time - sut.looks().front().time, LevelHistory::kLength);
    EXPECT_LT(sut.looks().back().time - sut.looks().front().time, LevelHistory::kLength + 100ms);
    sut.forget();
    EXPECT_TRUE(sut.looks().empty());
}

}  // namespace
}  // namespace psicarve::session
