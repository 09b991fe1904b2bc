// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/tick_health.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

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

TEST(MissedMeter, TellsTheWorstSecondOfTheLastFive) {
    MissedMeter sut;
    const MissedMeter::Clock::time_point begin{};
    std::uint64_t most = 0;
    for (int look = 0; look <= 250; ++look) {  // of 20 ms: 60 missed from 1.0 s on, within 0.4 s
        const int missed = std::clamp(look - 50, 0, 20) * 3;
        most = sut.note(static_cast<std::uint64_t>(missed), begin + look * 20ms);
        EXPECT_EQ(most, static_cast<std::uint64_t>(missed)) << look;
    }
    EXPECT_EQ(sut.note(60, begin + 5900ms), 60U);
    EXPECT_EQ(sut.note(60, begin + 6600ms), 0U) << "it is over five seconds ago";
}

TEST(MissedMeter, CountsNoSecondTwiceAndBeginsAnewWithAnotherCore) {
    MissedMeter sut;
    const MissedMeter::Clock::time_point begin{};
    std::uint64_t most = 0;
    for (int look = 0; look <= 200; ++look)  // 40 a second
        most = sut.note(static_cast<std::uint64_t>(look), begin + look * 25ms);
    EXPECT_EQ(most, 40U);
    EXPECT_EQ(sut.note(5, begin + 5030ms), 0U);
    EXPECT_EQ(sut.note(65, begin + 8030ms), 20U) << "three seconds without a look";
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

TEST(TickHealth, TellsThe99PercentAlone) {
    CoreStatus status{};
    EXPECT_EQ(late_p99_ns(status), 0);
    status.lateness_histogram[9] = 980;
    status.lateness_histogram[12] = 20;  // up to 8 us
    status.max_lateness_ns = 8'000;
    EXPECT_EQ(late_p99_ns(status), 8'000);
    status.lateness_histogram[9] = 9'980;
    EXPECT_EQ(late_p99_ns(status), 1024);
}

TEST(SurfaceSpeed, IsThatOfTheFasterHead) {
    const Profile profile;
    const double r_per_mm = axis_motion(profile, Axis::r1).pulses_per_unit;
    const double psi_per_deg = axis_motion(profile, Axis::psi).pulses_per_unit;
    CoreStatus status{};
    status.period_ns = 100'000;
    status.position_pulses[index_of(Axis::r1)] = std::llround(20.0 * r_per_mm);
    status.position_pulses[index_of(Axis::r2)] = std::llround(10.0 * r_per_mm);
    RateMeter rates;
    rates.note(status, {});
    EXPECT_EQ(surface_speed_mm_s(rates, status, profile), 0.0);
    status.tick = 10'000;  // a second of the machine's
    status.emitted_pulses[index_of(Axis::psi)] = static_cast<std::uint64_t>(std::llround(90.0 * psi_per_deg));
    status.emitted_pulses[index_of(Axis::r1)] = static_cast<std::uint64_t>(std::llround(3.0 * r_per_mm));
    rates.note(status, RateMeter::Clock::time_point{} + 500ms);
    const double round_mm_s = 20.0 * kPi / 2.0;  // a quarter of a turn
    EXPECT_NEAR(surface_speed_mm_s(rates, status, profile), std::hypot(round_mm_s, 3.0), 0.01);
}

}  // namespace
}  // namespace psicarve::session
