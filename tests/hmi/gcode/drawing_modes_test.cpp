// SPDX-License-Identifier: GPL-3.0-or-later
// G7.1 and G12.1: where they hold, and what they refuse.
#include <cmath>
#include <iterator>
#include <random>

#include "hmi/gcode/canon_writer.hpp"
#include "tests/hmi/gcode/drawn_program.hpp"

namespace psicarve::gcode {
namespace {

TEST(DrawingModes, StandAloneInTheirBlock) {
    EXPECT_EQ(drawn_faults("G0 X40 C0\nG12.1 G64\nM2\n"), Faults{"2:7 drawing_beside"});
    EXPECT_EQ(drawn_faults("G0 X40 C0\nG12.1 X30\nM2\n"), Faults{"2:7 drawing_beside"});
    EXPECT_EQ(drawn_faults("G7.1 C40 Y3\nM2\n"), Faults{"1:6 drawing_beside"});
    EXPECT_EQ(drawn_faults("G7.1 C40 F300\nM2\n"), Faults{"1:10 drawing_beside"});
    EXPECT_EQ(drawn_faults("G7.1 C40 R3\nM2\n"), Faults{"1:10 word_unused"});
    EXPECT_EQ(drawn_faults("G7.1\nM2\n"), Faults{"1:1 word_missing"});
    EXPECT_EQ(drawn_faults("G7.1 C-40\nM2\n"), Faults{"1:6 out_of_range"});
    EXPECT_EQ(drawn_faults("N10 G7.1 C40\nM2\n"), Faults{});
}

TEST(DrawingModes, MayBeEndedWhereNoneHoldsAndLeftOpenAtTheEnd) {
    EXPECT_EQ(drawn_faults("G7.1 C0\nG13.1\nG0 X40 C0\nG12.1\nM2\n"), Faults{});
}

TEST(DrawingModes, BeginWhereTheyCanBeCarriedOut) {
    EXPECT_EQ(drawn_faults("G12.1\nG1 F300 X30\nG13.1\nM2\n"), Faults{"1:1 drawing_begin"});
    EXPECT_EQ(drawn_faults("G0 X40\nG12.1\nM2\n"), Faults{"2:1 drawing_begin"});
    EXPECT_EQ(drawn_faults("G10 L2 P1 X1\nG0 X40 C0\nG12.1\nM2\n"), Faults{"3:1 drawing_begin"});
    EXPECT_EQ(drawn_faults("G0 X40 C0\nG92 X39\nG12.1\nM2\n"), Faults{"3:1 drawing_begin"});
    EXPECT_EQ(drawn_faults("G10 L2 P1 R10\nG0 X40 Y10 C0\nG7.1 C30\nM2\n"), Faults{"3:1 drawing_begin"});
    EXPECT_EQ(drawn_faults("F100 G0 X40 Y40 Z30 C0\nG81 X40 Y40 Z20 R25\nG7.1 C30\nM2\n"),
              Faults{"3:1 drawing_begin"});
    EXPECT_EQ(read_program("G12.1\nM2\n")->faults(), Faults{"1:1 drawing_begin"});
    // C may count from elsewhere: that turns the drawing.
    EXPECT_EQ(drawn_faults("G10 L2 P1 C90\nG0 X40 C0\nG12.1\nG13.1\nM2\n"), Faults{});
}

TEST(DrawingModes, RefuseWhatWouldMoveTheDrawing) {
    for (const char* const mode : {"G12.1", "G7.1 C30"}) {
        const std::string begin = "F100\nG0 X40 Y40 Z30 C0\n" + std::string{mode} + "\n";
        for (const char* const block :
             {"G17", "G18", "G19", "G28", "G30", "G28.1", "G53 G0 X40", "G92 X40", "G92.1", "G10 L2 P1 X3",
              "G54", "G55", "G43.1 X2", "G49", "G81 X40 Y40 Z20 R25", "G12.1", "G7.1 C20"})
            EXPECT_EQ(drawn_faults(begin + block + "\nM2\n"), Faults{"4:1 drawing_code"})
                << mode << " " << block;
        for (const char* const block :
             {"G20", "G91", "G61", "G64 P.05", "G4 P1", "M3", "G93", "G94", "M0", "G40"})
            EXPECT_EQ(drawn_faults(begin + block + "\nM2\n"), Faults{}) << mode << " " << block;
    }
    EXPECT_EQ(drawn_faults("G0 X40 C0\nG12.1\nG7.1 C0\nM2\n"), Faults{"3:1 drawing_code"});
    EXPECT_EQ(drawn_faults("G7.1 C30\nG13.1\nM2\n"), Faults{"2:1 drawing_code"});
}

TEST(DrawingModes, HaveTheirWaysInCanonicalMotion) {
    const auto read = drawn("G64 P1\n" + kPolar + "G1 X30 C30\nG13.1\nG7.1 C30\nG0 C60\nG7.1 C0\nM2\n");
    ASSERT_EQ(read->faults(), Faults{});
    std::string text;
    for (const CanonRecord& record : of_line(*read, 5)) append_canon_line(record, text);
    append_canon_line(of_line(*read, 8).back(), text);
    EXPECT_EQ(text,
              R"({"k":"feed","line":5,"end":[38.242646,10,0,0,0,11.309932],"f":300,"within":true}
{"k":"feed","line":5,"end":[38.078866,10,0,0,0,23.198591],"f":300,"within":true}
{"k":"feed","line":5,"end":[39.528471,10,0,0,0,34.695154],"f":300,"within":true}
{"k":"feed","line":5,"end":[40.812069,10,0,0,0,40.030259],"f":300,"within":true}
{"k":"feed","line":5,"end":[42.426407,10,0,0,0,45],"f":300}
{"k":"rapid","line":8,"end":[42.426407,10,0,0,0,60]}
)");
}

TEST(DrawingModes, MakeMotionWithoutAGapWhateverStandsInThem) {
    constexpr const char* kBlocks[] = {
        "G7.1 C30", "G7.1 C0",      "G12.1",       "G13.1",          "G1 X30 C10", "G1 X&",
        "G0 X-30",  "G1 C-30 Y20",  "G2 I5",       "G3 X20 C20 R40", "G91",        "G90",
        "G20",      "G21",          "G1 X#5420",   "G92 X3",         "G92.1",      "C400",
        "G17",      "G2 I-3 P3 Y5", "X1000000000", "G93 G1 X20 F3",  "G94 F200",   "G64 P.1"};
    std::mt19937 random{3};
    for (int round = 0; round < 300; ++round) {
        std::string text = "G21 G90 F300\nG0 X40 C0 Y10\n";
        for (int i = 0; i < 12; ++i) text += std::string{kBlocks[random() % std::size(kBlocks)]} + "\n";
        Profile profile;
        const auto read = drawn(text + "M2\n", profile);
        Position at{};
        for (const CanonRecord& record : read->records) {
            if (record.kind != CanonKind::feed && record.kind != CanonKind::rapid &&
                record.kind != CanonKind::arc)
                continue;
            ASSERT_EQ(record.start, at) << text;
            for (const double place : record.end) ASSERT_TRUE(std::isfinite(place)) << text;
            ASSERT_TRUE(std::isfinite(record.feed_per_min) && record.feed_per_min >= 0.0) << text;
            at = record.end;
        }
    }
}

TEST(DrawingModes, RefuseAWayOfTooManyPieces) {
    EXPECT_EQ(drawn_faults(kPolar + "G1 X30\nG3 X30 I-5 P10000\nM2\n"), Faults{"5:4 out_of_range"});
    EXPECT_EQ(drawn_faults(kCylinder + "G3 I-5 P10000\nM2\n"), Faults{"4:1 out_of_range"});
}

TEST(DrawingModes, CountEachPieceWhereLoopsAreBounded) {
    const auto faults_of = [](std::uint64_t most_blocks, const std::string& times) {
        InterpreterOptions options = machine_options({});
        options.most_repeated_blocks = most_blocks;
        return read_program(kCylinder + "o1 repeat [" + times + "]\nG2 I10\no1 endrepeat\nM2\n", options)
            ->faults();
    };
    EXPECT_EQ(faults_of(2000, "10"), Faults{});
    EXPECT_EQ(faults_of(2000, "100"), Faults{"6:1 too_many_blocks"});
}

TEST(DrawingModes, AreNotJudgedBehindAWrongBlockUntilARightOne) {
    // What follows is right, or wrong, by a mode that nobody knows.
    const std::string drawing =
        "G1 X30 C30\nC-30\nG2 X-20 C10 I3\nG18\nG2 K10\nG53 G0 X40\nG92 X3\nG28\nG1 X-20\n";
    for (const auto& [block, fault] :
         std::vector<std::pair<std::string, std::string>>{{"G12.1 X10", "3:7 drawing_beside"},
                                                          {"G12.1 @", "3:7 bad_character"},
                                                          {"G 1 2 . 1 X&", "3:11 number_missing"},
                                                          {"g012.1 @", "3:8 bad_character"},
                                                          {"G7.1", "3:1 word_missing"},
                                                          {"G7.1 C-3", "3:6 out_of_range"},
                                                          {"G7.1 C&", "3:6 number_missing"}}) {
        const std::string begin = "G21 G90 F300\nG0 X40 C0\n" + block + "\nF300\n";
        EXPECT_EQ(drawn_faults(begin + drawing + "G13.1\nM2\n"), Faults{fault}) << block;
        EXPECT_EQ(drawn_faults(begin + drawing + "G7.1 C0\nG0 X40 Y200\nM2\n"),
                  (Faults{fault, "15:4 outside_travel"}))
            << block;
        EXPECT_EQ(drawn_faults(begin + "G7.1 C30\nG2 I3\nG12.1\nM2\n"), (Faults{fault, "7:1 drawing_code"}))
            << block;
    }
    for (const std::string mode : {"G12.1", "G7.1 C30"})
        for (const std::string block : {"G13.1 X5", "G7.1 C0 &", "G13.1 &"}) {
            const auto faults = drawn_faults("G21 G90 F300\nG0 X40 Y20 C0\n" + mode + "\nG1 X30\n" + block +
                                             "\nF300\n" + drawing + "M2\n");
            EXPECT_EQ(faults.size(), 1U) << mode << " " << block << " " << faults.back();
        }
}

TEST(DrawingModes, AreNotJudgedByAValueThatIsNotKnown) {
    for (const std::string blocks :
         {"#1=[1/0]\nG7.1 C#1\nF300\nG1 X30 C300\nG18\nG2 K3\nG12.1\nG1 X30\nG13.1",
          "#1=30\n#1=[1/0]\nG7.1 C[#1]\nF300\nG2 I3\nG18\nG7.1 C0", "#1=-3\n#1=[1/0]\nG7.1 C#1\nG13.1"})
        EXPECT_EQ(drawn_faults("G21 G90 F300\nG0 X40 Y20 C0\n" + blocks + "\nM2\n").size(), 1U) << blocks;
}

TEST(DrawingMachines, HaveTheProfilesTolerance) {
    EXPECT_EQ(DrawingMachine{}.tolerance_mm, JobProfile{}.path_tolerance_mm);
    Profile profile;
    profile.job.path_tolerance_mm = 0.03;
    EXPECT_EQ(drawing_machine_of(profile).tolerance_mm, 0.03);
}

}  // namespace
}  // namespace psicarve::gcode
