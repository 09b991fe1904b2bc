// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/record_maker.hpp"

#include <array>

#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

using Target = std::array<double, kAxisCount>;

constexpr std::uint8_t kAllFour = 0xF;
constexpr std::uint8_t kR1Bit = 1;
constexpr std::uint8_t kPsiBit = 4;
constexpr std::uint8_t kYBit = 8;

/// The seconds of the only way behind the lines that set it up.
double seconds_of(const std::string& text) {
    const MadeRecords made = made_records(text + "\nM2\n");
    EXPECT_EQ(made.faults, Faults{}) << text;
    EXPECT_EQ(made.failure, "") << text;
    EXPECT_FALSE(made.ways().empty()) << text;
    return made.ways().empty() ? -1.0 : made.ways().back().seconds;
}

std::vector<double> tolerances_of(const std::string& text, double own_mm) {
    Profile profile;
    profile.job.path_tolerance_mm = own_mm;
    std::vector<double> found;
    for (const MotionRecord& way : made_records(text, {}, profile).ways()) found.push_back(way.tolerance_mm);
    return found;
}

/// "LINE KIND", with * where a record ends its block.
std::vector<std::string> steps_of(const MadeRecords& made) {
    static const std::array<std::string, 6> kNames{"?", "way", "dwell", "spindle", "stop", "end"};
    std::vector<std::string> steps;
    for (const MotionRecord& record : made.records) {
        std::string step = std::to_string(record.line) + " " + kNames[static_cast<std::size_t>(record.kind)];
        if (record.code != 0) step += std::to_string(record.code);
        if ((record.flags & kEndsBlock) != 0) step += "*";
        steps.push_back(step);
    }
    return steps;
}
using Steps = std::vector<std::string>;

TEST(RecordMaker, SendsEachLetterToItsAxis) {
    const MadeRecords made = made_records("G0 X20 Y5 Z30\nG1 C-720.5 F90\nM2\n");
    ASSERT_EQ(made.records.size(), 3U);
    EXPECT_EQ(made.records[0].target, (Target{20.0, 30.0, 0.0, 5.0}));
    EXPECT_EQ(made.records[0].axes, kAllFour);
    EXPECT_EQ(made.records[0].flags, kIsRapid | kEndsBlock);
    EXPECT_EQ(made.records[0].seconds, 0.0);
    EXPECT_EQ(made.records[1].target, (Target{20.0, 30.0, -720.5, 5.0}));
    EXPECT_EQ(made.records[1].flags, kEndsBlock);
    EXPECT_EQ(made.records[2].kind, MotionKind::end);
}

TEST(RecordMaker, CountsRotaryWordsInDegreesUnderInches) {
    const auto ways = made_records("G20\nG0 Y1 C90\nM2\n").ways();
    ASSERT_EQ(ways.size(), 1U);
    EXPECT_EQ(ways[0].target, (Target{60.0, 60.0, 90.0, 25.4}));
}

TEST(RecordMaker, NumbersItsRecordsAndSealsThem) {
    RunOptions how;
    how.program = 77;
    const MadeRecords made = made_records("F60\nG0 Y5\nG3 X40 Y5 I-10\nG4 P1\nM2\n", how);
    ASSERT_GT(made.records.size(), 10U);
    for (std::size_t i = 0; i < made.records.size(); ++i) {
        EXPECT_EQ(made.records[i].program, 77U);
        EXPECT_EQ(made.records[i].sequence, i + 1);
        EXPECT_EQ(made.records[i].check, record_check(made.records[i]));
    }
}

TEST(RecordMaker, TakesTheTimeThatTheFeedAsksFor) {
    // 5 mm along X Y Z, whatever C does meanwhile.
    EXPECT_DOUBLE_EQ(seconds_of("G1 X57 Y4 C90 F60"), 5.0);
    EXPECT_DOUBLE_EQ(seconds_of("G1 Y120 F240"), 30.0);
    EXPECT_DOUBLE_EQ(seconds_of("G1 C90 F60"), 90.0);
    EXPECT_DOUBLE_EQ(seconds_of("G20 G1 C90 F60"), 90.0);
    EXPECT_DOUBLE_EQ(seconds_of("G20\nG1 Y1 F2"), 30.0);
}

TEST(RecordMaker, TakesOneByFMinutesUnderInverseTime) {
    EXPECT_DOUBLE_EQ(seconds_of("G93\nG1 X57 Y4 C90 F4"), 15.0);
    EXPECT_DOUBLE_EQ(seconds_of("G93\nG1 C90 F4"), 15.0);
    EXPECT_DOUBLE_EQ(seconds_of("G20 G93\nG1 Y2 C90 F.5"), 120.0);
    double sum_s = 0.0;
    for (const MotionRecord& way : made_records("G93\nG3 X40 Y0 I-10 F4\nM2\n").ways()) sum_s += way.seconds;
    EXPECT_NEAR(sum_s, 15.0, 1e-9);
}

TEST(RecordMaker, TakesTheTurnsOfASpindleWhoseSpeedIsSaid) {
    EXPECT_DOUBLE_EQ(seconds_of("S300 G95\nG1 Y30 F.1"), 60.0);
    EXPECT_DOUBLE_EQ(seconds_of("S300 G95\nG1 C30 F.1"), 60.0);
}

TEST(RecordMaker, TakesTheRestOfASumForNoMove) {
    // 30.3 - 30.1 is not 0.2: Y does not move all the same, and C turns by degrees a minute.
    EXPECT_NEAR(seconds_of("G10 L2 P2 Y30.1\nG53 G0 Y30.3\nG55\nG1 Y.2 C90 F360"), 15.0, 1e-9);
    EXPECT_NEAR(seconds_of("G93\nG10 L2 P2 Y30.1\nG53 G0 Y30.3\nG55\nG1 Y.2 C90 F4"), 15.0, 1e-9);
}

TEST(RecordMaker, PassesEndsWithinTheToleranceOfTheirMode) {
    EXPECT_EQ(
        tolerances_of("F60 G1 Y1\nG64 Y2\nG64 P.25 Y3\nG0 Y4\nG61 Y5\nG61.1 Y6\nG64 P0 Y7\nY8\nM2\n", 0.02),
        (std::vector<double>{0.015, 0.015, 0.1875, 0.1875, 0.0, 0.0, 0.015, 0.015}));
    EXPECT_EQ(tolerances_of("G20\nF60 G64 P.01\nG1 Y1\nY2\nM2\n", 0.02),
              (std::vector<double>{0.1905, 0.1905}));
}

// What brings the machine to rest has it in the end before, to the pulse, anyway: an exact way would rest at
// its begin, too.
TEST(RecordMaker, LeavesTheLastWayBeforeARestTheToleranceOfTheOthers) {
    for (const std::string rest :
         {"G4 P0", "M3", "M5", "M0", "M60", "M6", "M2", "M30", "", "M1", "G64", "G17"})
        EXPECT_EQ(tolerances_of("G0 Y1\nY2\n" + rest + "\nG0 Y3\nM2\n", 0.02)[1], 0.015) << rest;
}

TEST(RecordMaker, SharesAnArcsToleranceBetweenChordsAndCorners) {
    // The corner before an arc belongs to it, too.
    const auto found = tolerances_of("F60 G0 Y20\nG1 X50\nG3 Y40 J10\nG1 X40\nX39\nM2\n", 0.02);
    ASSERT_GT(found.size(), 8U);
    // Lines beside it have the same: where it changes the path would rest.
    for (const double tolerance : found) EXPECT_EQ(tolerance, 0.015);
    const auto exact = tolerances_of("F60 G61 G0 Y20\nG3 Y40 J10\nG1 X40\nM2\n", 0.02);
    // The rest behind its last chord is a way of its own, without a pulse.
    ASSERT_EQ(exact.size(), found.size() - 1);
    EXPECT_EQ(exact.front(), 0.0);
    for (std::size_t i = 1; i + 2 < exact.size(); ++i) EXPECT_EQ(exact[i], 0.015) << i;
    EXPECT_EQ(exact[exact.size() - 2], 0.0);
    // Where ends are exact no earlier P counts.
    EXPECT_EQ(tolerances_of("F60 G64 P.2\nG61 G0 Y20\nG3 Y40 J10\nG1 X40\nM2\n", 0.02), exact);
}

TEST(RecordMaker, SaysWhereABlockEnds) {
    EXPECT_EQ(steps_of(made_records("G0 Y1\nG28 Y2\nT2 M3\nT3 M6\nG4 P1 M0\nG1 F60 Y9\nM30\n")),
              (Steps{"1 way*", "2 way", "2 way*", "3 spindle1*", "4 spindle", "4 stop3*", "5 dwell",
                     "5 stop1*", "6 way*", "7 end*"}));
    EXPECT_EQ(steps_of(made_records("G0 Y1 M2\n")), (Steps{"1 way", "1 end*"}));
}

TEST(RecordMaker, EndsABlockWithTheLastChordOfItsArc) {
    const MadeRecords made = made_records("F60 G0 Y20\nG3 Y40 J10\nG3 Y20 J-10\nM2\n");
    for (std::size_t i = 0; i + 1 < made.records.size(); ++i)
        EXPECT_EQ((made.records[i].flags & kEndsBlock) != 0,
                  made.records[i].line != made.records[i + 1].line);
}

TEST(RecordMaker, WaitsForTheOperatorWhereTheProgramStops) {
    RunOptions how;
    EXPECT_EQ(steps_of(made_records("M0\nM1\nM60\nM6\nM2\n", how)),
              (Steps{"1 stop1*", "2 stop5*", "3 stop1*", "4 stop3*", "5 end*"}));
    how.stops_at_optional = true;
    EXPECT_EQ(steps_of(made_records("M0\nM1\nM60\nM6\nM2\n", how)),
              (Steps{"1 stop1*", "2 stop4*", "3 stop1*", "4 stop3*", "5 end*"}));
}

// Where the switch is off the block ends with its way, as without an M1.
TEST(RecordMaker, EndsABlockWithTheWayBeforeAnM1ThatMayBePassed) {
    RunOptions how;
    EXPECT_EQ(steps_of(made_records("G0 Y1 M1\nG0 Y2\nM2\n", how)),
              (Steps{"1 way*", "1 stop5*", "2 way*", "3 end*"}));
    how.stops_at_optional = true;
    EXPECT_EQ(steps_of(made_records("G0 Y1 M1\nG0 Y2\nM2\n", how)),
              (Steps{"1 way", "1 stop4*", "2 way*", "3 end*"}));
}

// The records of a snapshot before layout 18 are to be made again.
TEST(RecordMaker, MakesTheRecordsOfBeforeM1WasSwitched) {
    RunOptions how;
    how.has_optional_stops = false;
    EXPECT_EQ(steps_of(made_records("G0 Y1 M1\nM2\n", how)), (Steps{"1 way*", "2 end*"}));
    how.stops_at_optional = true;
    EXPECT_EQ(steps_of(made_records("G0 Y1 M1\nM2\n", how)), (Steps{"1 way", "1 stop2*", "2 end*"}));
}

TEST(RecordMaker, EndsWhereTheProgramEndsOrAStreamDoes) {
    EXPECT_EQ(steps_of(made_records("%\nG0 Y1\n%\nG0 Y2\n")), (Steps{"2 way*", "3 end*"}));
    EXPECT_EQ(steps_of(made_records("G0 Y1\nG64\n")), (Steps{"1 way*", "2 end*"}));
    EXPECT_EQ(steps_of(made_records("")), Steps{"1 end*"});
}

TEST(RecordMaker, KeepsTheSecondsOfADwell) {
    const MadeRecords made = made_records("G4 P1.25\nM2\n");
    EXPECT_EQ(made.records[0].kind, MotionKind::dwell);
    EXPECT_EQ(made.records[0].seconds, 1.25);
}

TEST(RecordMaker, MakesNoWayWhereNothingMoves) {
    EXPECT_EQ(steps_of(made_records("F60 G0 Y1\nG1 Y1\nG0 X60\nG93 G1 Y1 F1\nM2\n")),
              (Steps{"1 way*", "5 end*"}));
}

TEST(RecordMaker, LeavesAxesWhoseFirstPlaceIsNotKnownWhereTheyAre) {
    const MadeRecords made = made_records("G0 X20\nC0\nG1 X25 F60\nG0 Y0\nM2\n", {}, {}, false);
    EXPECT_EQ(made.failure, "");
    ASSERT_EQ(made.records.size(), 5U);
    EXPECT_EQ(made.records[0].axes, kR1Bit);
    EXPECT_EQ(made.records[1].axes, kR1Bit | kPsiBit);
    EXPECT_EQ(made.records[2].axes, kR1Bit | kPsiBit);
    EXPECT_EQ(made.records[3].axes, kR1Bit | kPsiBit | kYBit);
}

TEST(RecordMaker, RefusesWhatItCannotSay) {
    const auto failure = [](const std::string& text, bool is_start_known) {
        const MadeRecords made = made_records("G0 X40\n" + text + "\nG0 X41\nM2\n", {}, {}, is_start_known);
        EXPECT_LE(made.records.size(), 1U) << text;
        return made.failure;
    };
    EXPECT_EQ(failure("G1 Y5 F60", false), "line 2: it is not known where Y begins");
    EXPECT_EQ(failure("G91 G0 Y5", false), "line 2: it is not known where Y begins");
    EXPECT_EQ(failure("F60 G3 I-5", false), "line 2: it is not known where Y begins");
    EXPECT_EQ(failure("G0 A5", true), "line 2: the machine has no axis A");
    EXPECT_EQ(failure("F60 G18 G3 X50 Z50 R30", true), "line 2: an arc in ZX does not move Y and one head");
    EXPECT_EQ(failure("M4", true), "line 2: the machine's spindle does not turn back");
    EXPECT_EQ(failure("M64 P1", true), "line 2: the machine has no such output or input");
    EXPECT_EQ(failure("M66 P1", true), "line 2: the machine has no such output or input");
}

TEST(RecordMaker, EndsTheReadingWhereItsRecordsAreNotTaken) {
    std::string text = "F60 G0 Y20\n";
    for (int i = 0; i < 1000; ++i) text += "G3 Y40 J10 P1000000\nG3 Y20 J-10\n";
    const MadeRecords made = made_records(text + "M2\n", {}, {}, true, 5);
    EXPECT_EQ(made.failure, "the list is full");
    EXPECT_EQ(made.records.size(), 5U);
    EXPECT_EQ(made.lines, 2U);
    EXPECT_EQ(made.faults, Faults{});
}

}  // namespace
}  // namespace psicarve::gcode
