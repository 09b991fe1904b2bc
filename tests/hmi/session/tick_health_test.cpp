// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/tick_health.hpp"

#include <gtest/gtest.h>

namespace psicarve::session {
namespace {

using namespace std::chrono_literals;

TEST(TickHealth, FindsPercentilesAndTheBarOfThePeriod) {
    CoreStatus status{};
    status.period_ns = 50'000;
    status.lateness_histogram[9] = 9'900;  // up to 1 us
    status.lateness_histogram[12] = 95;    // up to 8 us
    status.lateness_histogram[15] = 5;     // up to 65 us
    status.max_lateness_ns = 40'000;
    status.missed_ticks = 3;
    const TickHealth sut = tick_health(status);
    EXPECT_EQ(sut.ticks, 10'000U);
    EXPECT_EQ(sut.missed, 3U);
    EXPECT_EQ(sut.median_ns, 1024);
    EXPECT_EQ(sut.p99_ns, 1024);
    EXPECT_EQ(sut.p999_ns, 8192);
    EXPECT_EQ(sut.greatest_ns, 40'000);
    EXPECT_EQ(sut.period_bar, 15U);
    ASSERT_EQ(sut.bars.size(), 16U);
    EXPECT_EQ(sut.bars[9].height, 1.0);
    EXPECT_GT(sut.bars[15].height, 0.1) << "few, but to be seen";
    EXPECT_EQ(sut.bars[14].height, 0.0);
    EXPECT_EQ(sut.bars[9].label, "\u2264 1.0 \u00B5s");
}

TEST(TickHealth, OfACoreThatHasNotTickedIsEmpty) {
    const TickHealth sut = tick_health(CoreStatus{});
    EXPECT_EQ(sut.ticks, 0U);
    EXPECT_EQ(sut.p99_ns, 0);
}

TEST(TickHealth, ShowsDurationsShort) {
    EXPECT_EQ(duration_text(0), "0 ns");
    EXPECT_EQ(duration_text(999), "999 ns");
    EXPECT_EQ(duration_text(1'500), "1.5 \u00B5s");
    EXPECT_EQ(duration_text(61'200), "61 \u00B5s");
    EXPECT_EQ(duration_text(2'500'000), "2.5 ms");
}

TEST(RateMeter, MeasuresOverTheLastSecond) {
    RateMeter sut;
    const RateMeter::Clock::time_point begin{};
    CoreStatus status{};
    for (int i = 0; i <= 60; ++i) {
        status.tick = static_cast<std::uint64_t>(i) * 1000;
        status.emitted_pulses[index_of(Axis::psi)] = static_cast<std::uint64_t>(i < 30 ? 0 : (i - 30) * 50);
        status.missed_ticks = i >= 55 ? 2 : 0;
        sut.note(status, begin + i * 50ms);
    }
    EXPECT_NEAR(sut.ticks_per_s(), 20'000.0, 1e-6);
    EXPECT_NEAR(sut.pulses_per_s(Axis::psi), 1000.0, 1e-6);
    EXPECT_EQ(sut.pulses_per_s(Axis::r1), 0.0);
    EXPECT_EQ(sut.missed_lately(), 2U);
}

TEST(RateMeter, BeginsAnewWithAnotherCoreAndSaysNothingTooSoon) {
    RateMeter sut;
    const RateMeter::Clock::time_point begin{};
    CoreStatus status{};
    status.tick = 1'000'000;
    sut.note(status, begin);
    status.tick = 500;
    sut.note(status, begin + 50ms);
    EXPECT_EQ(sut.ticks_per_s(), 0.0);
    status.tick = 2500;
    sut.note(status, begin + 150ms);
    EXPECT_EQ(sut.ticks_per_s(), 0.0);
    status.tick = 6500;
    sut.note(status, begin + 350ms);
    EXPECT_NEAR(sut.ticks_per_s(), 20'000.0, 1e-6);
}

}  // namespace
}  // namespace psicarve::session
