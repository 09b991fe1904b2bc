// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/interpreter.hpp"

#include "hmi/gcode/canon_writer.hpp"
#include "tests/hmi/gcode/read_program.hpp"

namespace psicarve::gcode {
namespace {

TEST(Interpreter, CountsAFeedBesideUnitsInTheNewOnesAndSaysSo) {
    const auto read = read_program("G20 F10\nG1 X1\nM2\n");
    EXPECT_EQ(read->faults(), Faults{"1:5 feed_beside_units"});
    EXPECT_DOUBLE_EQ(read->records[0].feed_per_min, 254.0);
    EXPECT_TRUE(read_program("G21 F10\nG1 X1\nM2\n")->faults().empty());
}

TEST(Interpreter, KeepsAFeedWhenUnitsChange) {
    EXPECT_DOUBLE_EQ(read_program("F254\nG20\nG1 X1\nM2\n")->records[0].feed_per_min, 254.0);
}

TEST(Interpreter, ForgetsAFeedWhenItsMeaningChanges) {
    EXPECT_EQ(read_program("S10 F100\nG95\nG1 X1\nM2\n")->faults(), Faults{"3:4 feed_missing"});
}

TEST(Interpreter, CountsDegreesWhereOnlyARotaryAxisMoves) {
    const auto read = read_program("G20\nF15\nG1 A90\nG1 A91 X1\nM2\n");
    EXPECT_DOUBLE_EQ(read->records[0].feed_per_min, 15.0);
    EXPECT_DOUBLE_EQ(read->records[1].feed_per_min, 381.0);
    EXPECT_DOUBLE_EQ(read->records[1].end[3], 91.0);
}

TEST(Interpreter, ReadsTheUnitsOfAnotherDialectWhereItIsChosen) {
    EXPECT_EQ(read_program("G70\nG0 X1\nM2\n")->faults(), Faults{"1:1 unknown_g"});
    InterpreterOptions options;
    options.dialect = Dialect::iso;
    const auto read = read_program("G70\nG0 X1\nG71\nG0 Y1\nM2\n", options);
    EXPECT_TRUE(read->faults().empty());
    EXPECT_EQ(read->records[1].end[0], 25.4);
    EXPECT_EQ(read->records[1].end[1], 1.0);
}

TEST(Interpreter, RunsDeletedBlocksUnlessTheyAreSwitchedOff) {
    InterpreterOptions options;
    EXPECT_EQ(read_program("/G0 X1\nM2\n", options)->facts.motion_count, 1U);
    options.skips_deleted = true;
    EXPECT_EQ(read_program("/G0 X1\n/G0 Y!\nM2\n", options)->facts.motion_count, 0U);
    EXPECT_TRUE(read_program("/G0 X1\n/G0 Y!\nM2\n", options)->faults().empty());
}

TEST(Interpreter, ReadsNothingBehindTheEnd) {
    for (const char* text : {"M2\n???\n", "%\n%\n???\n", "M30\n???\n"}) {
        const auto read = read_program(text);
        EXPECT_TRUE(read->faults().empty()) << text;
        EXPECT_TRUE(read->facts.has_end);
    }
}

TEST(Interpreter, EndsWhereAStreamEndsUnlessThatIsFramedOrEmptyOrWithinABlock) {
    InterpreterOptions options;
    options.ends_with_input = true;
    for (const char* text :
         {"G0 X1\n", "(a comment)\n", "o1 if [1]\nG0 X1\no1 endif\n", "M2\n", "M2", "G0 X1\n "}) {
        const auto read = read_program(text, options);
        EXPECT_EQ(read->faults(), Faults{}) << text;
        EXPECT_TRUE(read->facts.has_end) << text;
        ASSERT_FALSE(read->records.empty()) << text;
        EXPECT_EQ(read->records.back().kind, CanonKind::end) << text;
    }
    EXPECT_EQ(read_program("", options)->faults(), Faults{"1:1 no_end"});
    EXPECT_EQ(read_program("%\nG0 X1\n", options)->faults(), Faults{"2:1 no_end"});
    EXPECT_EQ(read_program("o1 if [1]\nG0 X1\n", options)->faults(), Faults{"1:1 o_word_open"});
    const auto wrong = read_program("G0 X1\nG1 X2\n", options);
    EXPECT_EQ(wrong->faults(), Faults{"2:4 feed_missing"});
    EXPECT_FALSE(wrong->facts.has_end);
}

// Torn off, G1 X40 may be the half of G1 X400.
TEST(Interpreter, RunsNoLineThatAStreamEndsWithin) {
    InterpreterOptions options;
    options.ends_with_input = true;
    for (const char* text : {"G0 X1\nG0 X40", "%\nG0 X40", "G0 X1\nM3"}) {
        const auto read = read_program(text, options);
        EXPECT_EQ(read->faults(), Faults{"2:1 no_end"}) << text;
        EXPECT_FALSE(read->facts.has_end) << text;
        for (const CanonRecord& record : read->records) EXPECT_EQ(record.line, 1U) << text;
    }
    EXPECT_EQ(read_program("G0 X1\nG0 X40\nM2")->faults(), Faults{}) << "of a file";
}

TEST(Interpreter, MovesSecondaryAxesAndTellsThemApart) {
    const auto read = read_program("G0 U1 V2 W3\nM2\n");
    std::string text;
    append_canon_line(read->records[0], text);
    EXPECT_EQ(text, "{\"k\":\"rapid\",\"line\":1,\"end\":[0,0,0,0,0,0],\"uvw\":[1,2,3]}\n");
}

TEST(Interpreter, GoesToTheReferenceThatTheProgramHasSet) {
    const auto read = read_program("G0 X5 Y6\nG28.1\nG0 X0 Y0\nG28\nM2\n");
    EXPECT_EQ(read->records[3].end[0], 5.0);
    EXPECT_EQ(read->records[3].end[1], 6.0);
}

TEST(Interpreter, StopsTheSpindleForATool) {
    const auto read = read_program("M3\nT4 M6\nM2\n");
    ASSERT_EQ(read->of_kind(CanonKind::spindle).size(), 2U);
    EXPECT_EQ(read->of_kind(CanonKind::spindle)[1].code, 5);
    EXPECT_EQ(read->of_kind(CanonKind::tool_change)[0].value, 4.0);
}

TEST(Interpreter, LetsAMotionStandBesideTheEndOfACycle) {
    const auto read = read_program("F9 G81 X1 Z-1 R1\nG80 G0 X5\nG0 G80 X6\nM2\n");
    EXPECT_TRUE(read->faults().empty());
    EXPECT_EQ(read->records[read->records.size() - 2].end[0], 6.0);
}

TEST(Interpreter, RefusesABlockThatWouldDrillWithoutEnd) {
    EXPECT_EQ(read_program("F9\nG83 X1 Z-99 R1 Q.01 L100\nG83 X1 Z-1 R0 Q.0000001\nM2\n")->faults(),
              (Faults{"2:5 out_of_range", "3:5 out_of_range"}));
}

TEST(Interpreter, HasAPlaceForACycleThatGoesOnFromAWrongOne) {
    EXPECT_EQ(read_program("F9\nG83\nG83 X3\nM2\n")->faults(),
              (Faults{"2:1 axes_missing", "3:5 out_of_range"}));
    EXPECT_EQ(read_program("F9\nG82 X1 Z-1 R1 P-1\nG82 X3\nM2\n")->faults(),
              (Faults{"2:15 out_of_range", "3:5 out_of_range"}));
}

TEST(Interpreter, MovesSecondaryAxesInNoCycle) {
    EXPECT_EQ(read_program("F9 G81 X1 U2 Z-1 R1\nM2\n")->faults(), Faults{"1:8 cycle_rotary"});
    EXPECT_EQ(read_program("F9 G81 X1 Z-1 R1\nW2\nM2\n")->faults(), Faults{"2:1 cycle_rotary"});
}

TEST(Interpreter, LetsNoMotionStandBesideACodeThatMayHaveAxisWords) {
    for (const std::string code : {"G28", "G30", "G10 L2 P1", "G92"})
        EXPECT_EQ(read_program("F9 G81 " + code + "\nM2\n")->faults(), Faults{"1:4 claimed_twice"}) << code;
    EXPECT_EQ(read_program("G80 G28\nM2\n")->faults(), Faults{});
}

TEST(Interpreter, GoesNoFurtherThanItCanCount) {
    EXPECT_EQ(read_program("G91 G0 X900000000\nX900000000\nM2\n")->faults(), Faults{"2:1 out_of_range"});
    EXPECT_EQ(read_program("G91 G0 X900000000\nX-900000000\nM2\n")->faults(), Faults{});
    EXPECT_EQ(read_program("G20\nF9 G2 X1 R900000000\nM2\n")->faults(), Faults{"2:7 out_of_range"});
    EXPECT_EQ(read_program("G20\nF9 G81 X1 Z-1 R900000000\nM2\n")->faults(), Faults{"2:8 out_of_range"});
    EXPECT_EQ(read_program("G20\nG28 X900000000\nM2\n")->faults(), Faults{"2:5 out_of_range"});
    EXPECT_EQ(read_program("G10 L2 P1 X900000000\nG0 X900000000\nM2\n")->faults(),
              Faults{"2:4 out_of_range"});
}

TEST(Interpreter, TakesACentreAloneForAnotherArc) {
    const auto read = read_program("F9 G2 X2 Y0 I1\nI1\nM2\n");
    EXPECT_EQ(read->faults(), Faults{});
    EXPECT_EQ(read->of_kind(CanonKind::arc).size(), 2U);
    EXPECT_EQ(read_program("F9 G1 X2\nI1\nM2\n")->faults(), Faults{"2:1 word_unused"});
}

TEST(Interpreter, KnowsTheRangesOfWordsThatSwitch) {
    EXPECT_EQ(read_program("M66 P1 L5\nM66 P1 L-1\nM66 P1 L.5\nM66 P1 L3 Q-1\nM66 P1 L4 Q1\nM2\n")->faults(),
              (Faults{"1:8 out_of_range", "2:8 out_of_range", "3:8 not_whole", "4:11 out_of_range"}));
    EXPECT_EQ(read_program("G64 P-.1\nG64 P1 Q-1\nG64 P0\nM2\n")->faults(),
              (Faults{"1:5 out_of_range", "2:8 out_of_range"}));
    EXPECT_EQ(read_program("M50 P2\nM51 P-1\nM52 P.5\nM53 P1\nM50\nM2\n")->faults(),
              (Faults{"1:5 out_of_range", "2:5 out_of_range", "3:5 out_of_range"}));
}

// CAM systems write it into every program; once is enough.
TEST(Interpreter, SaysOnceThatItDoesNotUseQOfG64) {
    EXPECT_EQ(read_program("G64 P.1 Q.2\nG64 Q.2\nG64\nM2\n")->faults(), Faults{"1:9 tolerance_unused"});
    EXPECT_EQ(read_program("G64 P.1\nG64 Q0\nM2\n")->faults(), Faults{"2:5 tolerance_unused"});
    EXPECT_EQ(read_program("G61 Q.2\nM2\n")->faults(), Faults{"1:5 word_unused"});
}

TEST(Canon, WritesEveryKindAsOneObject) {
    const auto read = read_program(
        "F60 S9\nG64 P.1\nG2 X2 Y0 I1\nG4 P.5\nM3\nM8\nM9\nT2 M6\nM50 P0\nM62 P1\nM65 P2\nM66 "
        "P3\nM1\nG61\nM2\n");
    std::string text;
    for (const CanonRecord& record : read->records) append_canon_line(record, text);
    EXPECT_EQ(text,
              "{\"k\":\"speed\",\"line\":1,\"rpm\":9}\n"
              "{\"k\":\"path\",\"line\":2,\"mode\":\"blend\",\"p\":0.1}\n"
              "{\"k\":\"arc\",\"line\":3,\"end\":[2,0,0,0,0,0],\"f\":60,\"plane\":\"XY\",\"ctr\":[1,0],"
              "\"rot\":-1}\n"
              "{\"k\":\"dwell\",\"line\":4,\"s\":0.5}\n"
              "{\"k\":\"spindle\",\"line\":5,\"dir\":\"cw\"}\n"
              "{\"k\":\"coolant\",\"line\":6,\"on\":true,\"which\":\"flood\"}\n"
              "{\"k\":\"coolant\",\"line\":7,\"on\":false}\n"
              "{\"k\":\"tool\",\"line\":8,\"t\":2}\n"
              "{\"k\":\"spindle\",\"line\":8,\"dir\":\"off\"}\n"
              "{\"k\":\"tool_change\",\"line\":8,\"t\":2}\n"
              "{\"k\":\"override\",\"line\":9,\"m\":50,\"p\":0}\n"
              "{\"k\":\"output\",\"line\":10,\"n\":1,\"on\":true,\"with_motion\":true}\n"
              "{\"k\":\"output\",\"line\":11,\"n\":2,\"on\":false,\"with_motion\":false}\n"
              "{\"k\":\"input\",\"line\":12,\"n\":3}\n"
              "{\"k\":\"stop\",\"line\":13,\"why\":\"optional\"}\n"
              "{\"k\":\"path\",\"line\":14,\"mode\":\"exact_path\"}\n"
              "{\"k\":\"end\",\"line\":15}\n");
}

}  // namespace
}  // namespace psicarve::gcode
