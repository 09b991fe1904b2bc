// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/progress_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace psicarve::cli {
namespace {

TEST(ProgressLine, ShowsShareTimeLeftAndPlace) {
    EXPECT_EQ(progress_line("carving", 0.5, TimeToGo{192.0, false}, "layer 3", 80),
              "carving  [############............]   50 %  3:12 left  layer 3");
}

TEST(ProgressLine, SaysAboutOfWhatIsNotPlannedYet) {
    EXPECT_EQ(progress_line("carving", 0.5, TimeToGo{192.0, true}, "layer 3", 80),
              "carving  [############............]   50 %  about 3:12 left  layer 3");
}

TEST(ProgressLine, NeverFillsTheTerminalsLastColumn) {
    EXPECT_EQ(progress_line("carving", 1.0, TimeToGo{1.0, false}, "layer 3", 20).size(), 19U);
}

TEST(ProgressLine, BearsSharesThatMakeNoSense) {
    EXPECT_EQ(progress_line("x", 7.0, {}, "", 80), "x  [########################]  100 %");
    EXPECT_EQ(progress_line("x", -1.0, {}, "", 80), "x  [........................]    0 %");
    EXPECT_EQ(progress_line("x", std::nan(""), {}, "", 80), "x  [........................]    0 %");
}

TEST(ClockText, GrowsFromMinutesToHours) {
    EXPECT_EQ(clock_text(0.4), "0:00");
    EXPECT_EQ(clock_text(59.6), "1:00");
    EXPECT_EQ(clock_text(3900.0), "1:05:00");
    EXPECT_EQ(clock_text(-1.0), "0:00");
}

}  // namespace
}  // namespace psicarve::cli
