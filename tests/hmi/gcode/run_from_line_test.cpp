// SPDX-License-Identifier: GPL-3.0-or-later
// A program that is run from a line on, and dry runs.
#include <algorithm>
#include <random>

#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

constexpr std::uint8_t kHeadBits = 3;
constexpr std::uint8_t kOnlyPsi = 4;
constexpr std::uint8_t kOnlyY = 8;

bool are_alike(const MotionRecord& a, const MotionRecord& b) {
    return a.line == b.line && a.kind == b.kind && a.axes == b.axes && a.flags == b.flags &&
           a.code == b.code && a.target == b.target && a.seconds == b.seconds &&
           a.tolerance_mm == b.tolerance_mm;
}

std::vector<MotionRecord> from(const std::vector<MotionRecord>& records, std::uint64_t line) {
    std::vector<MotionRecord> found;
    for (const MotionRecord& record : records)
        if (record.line >= line) found.push_back(record);
    return found;
}

/// Of everything that a program can say to this machine, one word or mode after the other.
std::string drawn_program(unsigned seed) {
    std::mt19937 random{seed};
    const auto number = [&](int least, int most) {
        return std::to_string(std::uniform_int_distribution<int>{least, most}(random));
    };
    std::string text = "G21 G90 F300\n";
    for (int line = 0; line < 60; ++line) {
        const int kind = std::uniform_int_distribution<int>{0, 15}(random);
        switch (kind) {
            case 0:
                text += "G0 X" + number(20, 50) + " Z" + number(20, 50) + " C" + number(-900, 900);
                break;
            case 1:
                text += "G1 Y" + number(10, 90) + " C" + number(-900, 900);
                break;
            case 2:
                text += "G1 X" + number(20, 50);
                break;
            case 3:
                text += "G61";
                break;
            case 4:
                text += "G64 P.0" + number(1, 9);
                break;
            case 5:
                text += "G64";
                break;
            case 6:
                text += "G4 P" + number(0, 9);
                break;
            case 7:
                text += number(0, 1) == "0" ? "M3" : "M5";
                break;
            case 8:
                text += "T" + number(1, 9) + " M6";
                break;
            case 9:
                text += "M" + number(0, 1);
                break;
            case 10:
                text += "G10 L2 P1 Y" + number(0, 5) + " X" + number(0, 5);
                break;
            case 11:
                text += "G91 G1 Y" + number(-2, 2) + " C" + number(-90, 90) + " G94\nG90";
                break;
            case 12:
                text += "G92 C" + number(0, 9);
                break;
            case 13:
                text += "(a word)";
                break;
            case 14:
                text += "G" + number(2, 3) + " I" + number(1, 9) + " J-.5";
                break;
            default:
                text += "G20\nG1 Y2\nG21\nF" + number(100, 500);
                break;
        }
        text += "\n";
    }
    return text + "M30\n";
}

TEST(RunFromLine, IsTheTailOfTheWholeProgramFromTheEndOfThatLineOn) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const std::string text = drawn_program(seed);
        Profile profile;
        profile.gcode.turns_shortest = seed % 2 == 0;
        const MadeRecords whole = made_records(text, {}, profile);
        ASSERT_EQ(whole.faults, Faults{}) << text;
        const std::uint64_t last = static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
        for (std::uint64_t line = 1; line <= last; ++line) {
            RunOptions how;
            how.from_line = line;
            const MadeRecords part = made_records(text, how, profile);
            ASSERT_EQ(part.failure, "") << text;
            const std::vector<MotionRecord> wanted = from(whole.records, line);
            ASSERT_GE(part.records.size(), wanted.size()) << "seed " << seed << " line " << line;
            const std::size_t approach = part.records.size() - wanted.size();
            ASSERT_LE(approach, 5U);
            for (std::size_t i = 0; i < wanted.size(); ++i)
                ASSERT_TRUE(are_alike(part.records[approach + i], wanted[i]))
                    << "seed " << seed << " from line " << line << " record " << i;
            for (std::size_t i = 0; i < part.records.size(); ++i) ASSERT_EQ(part.records[i].sequence, i + 1);
            for (std::size_t i = 0; i < approach; ++i) ASSERT_EQ(part.records[i].line, line);
        }
    }
}

TEST(RunFromLine, ApproachesWithTheSpindleOnAndTheHeadsOut) {
    const std::string text = "M3 S9\nG0 X40 Z50 Y30 C90\nG64 P.1\nG1 X20 F60\nG1 X25\nM2\n";
    RunOptions how;
    how.from_line = 5;
    const auto records = made_records(text, how).records;
    ASSERT_EQ(records.size(), 7U);
    EXPECT_EQ(records[0].kind, MotionKind::spindle);
    EXPECT_EQ(records[0].code, 1);
    EXPECT_EQ(records[1].axes, kHeadBits);
    EXPECT_EQ(records[1].target[0], 60.0);
    EXPECT_EQ(records[1].target[1], 60.0);
    EXPECT_EQ(records[2].axes, kOnlyPsi);
    EXPECT_EQ(records[2].target[kPsi], 90.0);
    EXPECT_EQ(records[3].axes, kOnlyY);
    EXPECT_EQ(records[3].target[kY], 30.0);
    EXPECT_EQ(records[4].axes, kHeadBits);
    EXPECT_EQ(records[4].target[0], 20.0);
    EXPECT_EQ(records[4].target[1], 50.0);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(records[i].line, 5U) << i;
        EXPECT_EQ(records[i].tolerance_mm, 0.0) << i;
        EXPECT_EQ((records[i].flags & kEndsBlock) != 0, i == 4) << i;
        EXPECT_EQ((records[i].flags & kIsRapid) != 0, i > 0) << i;
    }
    EXPECT_EQ(records[5].target[0], 25.0);
    EXPECT_EQ(records[5].flags, kEndsBlock);
}

TEST(RunFromLine, ApproachesNothingWhereNothingHasMovedBefore) {
    RunOptions how;
    how.from_line = 3;
    const auto records = made_records("F60 G64 P.2\nG10 L2 P1 Y5\nG1 Y1\nY2\nM2\n", how).records;
    ASSERT_EQ(records.size(), 3U);
    EXPECT_EQ(records[0].target[kY], 6.0);
    EXPECT_DOUBLE_EQ(records[0].tolerance_mm, 0.15);
}

TEST(RunFromLine, LeavesTheSpindleOffThatTheProgramHasSwitchedOff) {
    RunOptions how;
    how.from_line = 4;
    EXPECT_EQ(made_records("M3\nG0 Y1\nM5\nG0 Y2\nM2\n", how).records[0].kind, MotionKind::way);
}

TEST(RunFromLine, GoesToNoPlaceThatIsNotKnown) {
    RunOptions how;
    how.from_line = 3;
    const auto records = made_records("G0 X40 Y5\nG0 Y6\nG0 Y7\nM2\n", how, {}, false).records;
    ASSERT_EQ(records.size(), 5U);
    EXPECT_EQ(records[0].axes, kHeadBits);
    EXPECT_EQ(records[1].axes, kOnlyY);
    EXPECT_EQ(records[2].axes, 1);
}

TEST(RunFromLine, RefusesALineBehindTheEnd) {
    RunOptions how;
    how.from_line = 4;
    const MadeRecords made = made_records("G0 Y1\nG0 Y2\nM2\nG0 Y3\n", how);
    EXPECT_EQ(made.failure, "the program ends before line 4; begin at an earlier line");
    EXPECT_TRUE(made.records.empty());
}

TEST(DryRun, MovesPsiAndYAloneWithTheHeadsOutAndTheSpindleOff) {
    RunOptions how;
    how.is_dry = true;
    const auto records =
        made_records("M3\nG1 X20 Z30 Y5 C90 F60\nG1 X21\nG3 X21 Y15 J5\nM5\nM0\nM2\n", how).records;
    ASSERT_GT(records.size(), 5U);
    EXPECT_EQ(records[0].axes, kHeadBits);
    EXPECT_EQ(records[0].target[0], 60.0);
    EXPECT_EQ(records[0].target[1], 60.0);
    EXPECT_EQ(records[0].flags, kIsRapid | kEndsBlock);
    EXPECT_EQ(records[0].line, 1U);
    EXPECT_EQ(records[1].line, 2U);
    for (std::size_t i = 1; i < records.size(); ++i) {
        EXPECT_EQ(records[i].axes & kHeadBits, 0) << i;
        EXPECT_EQ(records[i].target[0], 0.0) << i;
        EXPECT_NE(records[i].kind, MotionKind::spindle) << i;
        EXPECT_NE(records[i].line, 3U) << i;
    }
    EXPECT_EQ(records[1].target[kPsi], 90.0);
    EXPECT_EQ(records[records.size() - 3].target[kY], 15.0);
    EXPECT_EQ(records[records.size() - 2].kind, MotionKind::stop);
}

TEST(DryRun, TakesTheTimeOfTheProgram) {
    RunOptions how;
    how.is_dry = true;
    const auto ways = made_records("G1 X57 Y4 F60\nM2\n", how).ways();
    ASSERT_EQ(ways.size(), 2U);
    EXPECT_DOUBLE_EQ(ways[1].seconds, 5.0);
}

TEST(DryRun, FromALineStaysOutAndOff) {
    RunOptions how;
    how.is_dry = true;
    how.from_line = 3;
    const auto records = made_records("M3\nG0 X40 Y5 C9\nG1 X41 Y6 F60\nM2\n", how).records;
    ASSERT_EQ(records.size(), 5U);
    EXPECT_EQ(records[0].axes, kHeadBits);
    EXPECT_EQ(records[1].axes, kOnlyPsi);
    EXPECT_EQ(records[2].axes, kOnlyY);
    EXPECT_EQ(records[2].flags, kIsRapid | kEndsBlock);
    EXPECT_EQ(records[3].axes, kOnlyPsi | kOnlyY);
}

}  // namespace
}  // namespace psicarve::gcode
