// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/start_from_line.hpp"

#include <gtest/gtest.h>

namespace psicarve::cli {
namespace {

LineStart start_within() {
    LineStart start;
    start.line = 7;
    start.approach.place = {40.0, 41.5, 450.0, 5.25};
    start.approach.placed = 0b1111;
    start.approach.is_spindle_on = true;
    return start;
}

TEST(StartFromLine, SaysStepByStepWhatComesFirst) {
    EXPECT_EQ(start_text(start_within()),
              "before line 7 the machine does this:\n"
              "  the spindle goes on\n"
              "  both heads go out to the end of their travel\n"
              "  psi turns to 450.000 deg, all turns\n"
              "  y goes to 5.250 mm\n"
              "  the heads come in: r1 to 40.000 mm, r2 to 41.500 mm");
}

TEST(StartFromLine, SaysOnlyWhatIsMoved) {
    LineStart start = start_within();
    start.approach.placed = 0b0010;
    start.approach.is_spindle_on = false;
    EXPECT_EQ(start_text(start),
              "before line 7 the machine does this:\n"
              "  both heads go out to the end of their travel\n"
              "  the heads come in: r2 to 41.500 mm\n"
              "  the spindle stays off until the program turns it on");
    start.approach.placed = 0;
    start.is_spindle_on = true;
    EXPECT_EQ(start_text(start),
              "before line 7 the machine does this:\n"
              "  nothing: no line before it moves anything\n"
              "  the spindle is on and stays on");
}

TEST(StartFromLine, OfADryRunLeavesHeadsOutAndTheSpindleOff) {
    LineStart start = start_within();
    start.is_dry = true;
    start.turns_shortest = true;
    EXPECT_EQ(start_text(start),
              "before line 7 the machine does this:\n"
              "  both heads go out to the end of their travel\n"
              "  psi turns\n"
              "  y goes to 5.250 mm\n"
              "  the heads stay out (dry run)\n"
              "  the spindle stays off until the program turns it on");
}

}  // namespace
}  // namespace psicarve::cli
