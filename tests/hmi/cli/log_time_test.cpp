// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/log_time.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>

namespace psicarve::cli {
namespace {

constexpr std::int64_t kHour_ms = 3'600'000;
constexpr std::int64_t kNoon_ms = 1'764'244'800'000;  ///< 2025-11-27 12:00:00 UTC, 13:00 in Central Europe

class LogTime : public ::testing::Test {
protected:
    void SetUp() override {
        setenv("TZ", "CET-1CEST,M3.5.0,M10.5.0/3", 1);
        tzset();
    }
    void TearDown() override {
        unsetenv("TZ");
        tzset();
    }
};

TEST_F(LogTime, ATimeOfDayIsTheLastThatHasBeen) {
    EXPECT_EQ(since_ms("12:00", kNoon_ms).value(), kNoon_ms - kHour_ms);
    EXPECT_EQ(since_ms("13:00", kNoon_ms).value(), kNoon_ms);
    EXPECT_EQ(since_ms("13:00:01", kNoon_ms).value(), kNoon_ms + 1000 - 24 * kHour_ms);
    EXPECT_EQ(since_ms("22:00", kNoon_ms).value(), kNoon_ms - 15 * kHour_ms);
    EXPECT_EQ(since_ms("22:00Z", kNoon_ms).value(), kNoon_ms - 14 * kHour_ms);
    EXPECT_EQ(since_ms("11:00Z", kNoon_ms).value(), kNoon_ms - kHour_ms);
}

TEST_F(LogTime, YesterdayMayHaveHadAnotherOffset) {
    // 2025-10-26 at 03:00 CEST became 02:00 CET; now is 2025-10-26 12:00 UTC.
    constexpr std::int64_t kNow_ms = 1'761'480'000'000;
    EXPECT_EQ(since_ms("22:00", kNow_ms).value(), kNow_ms - 16 * kHour_ms);
    // The first of a month, of a year: 2026-01-01 00:30 UTC.
    constexpr std::int64_t kNewYear_ms = 1'767'227'400'000;
    EXPECT_EQ(since_ms("23:30Z", kNewYear_ms).value(), kNewYear_ms - kHour_ms);
}

}  // namespace
}  // namespace psicarve::cli
