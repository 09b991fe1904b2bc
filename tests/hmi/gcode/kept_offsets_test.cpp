// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/kept_offsets.hpp"

#include "tests/hmi/gcode/read_program.hpp"

namespace psicarve::gcode {
namespace {

struct TellingProgram : CanonSink {
    void take(const CanonRecord&) override {}
    void set_offsets(const KeptOffsets& kept) override { told.push_back(kept); }
    std::vector<KeptOffsets> told;
};

std::vector<KeptOffsets> offsets_told(const std::string& text, const KeptOffsets& begin = {}) {
    InterpreterOptions options;
    options.offsets = begin;
    TellingProgram sink;
    ProblemList problems;
    LineSource lines{bytes_of(text)};
    EXPECT_TRUE(interpret_program(lines, options, sink, problems));
    EXPECT_EQ(problems.error_count(), 0U);
    return sink.told;
}

KeptOffsets x_offset(double x_mm) {
    KeptOffsets kept;
    kept.systems[0].origin[0] = x_mm;
    return kept;
}

TEST(KeptOffsets, AreThoseThatAProgramBeginsWith) {
    InterpreterOptions options;
    options.offsets.systems[0].origin[0] = 10.0;
    options.offsets.systems[1].origin[1] = 5.0;
    options.offsets.systems[1].rotation_deg = 90.0;
    options.offsets.shift[2] = 3.0;
    options.offsets.is_shifted = true;
    options.offsets.references[0] = Position{7.0};
    const auto read = read_program(
        "G0 X1 Z1\nG55 G0 X2 Y0 Z0\nG28\nG54 G0 X[#5221] Y#5230\nG0 X#5241 Y#5250 Z#5213\nM2\n", options);
    ASSERT_TRUE(read->faults().empty());
    EXPECT_EQ(read->records[0].end[0], 11.0);
    EXPECT_EQ(read->records[0].end[2], 4.0);
    EXPECT_NEAR(read->records[1].end[1], 7.0, 1e-9);
    EXPECT_EQ(read->records[3].end[0], 7.0);
    EXPECT_EQ(read->of_kind(CanonKind::rapid).back().end[0], 10.0);
}

TEST(KeptOffsets, AShiftThatIsSuspendedStaysAndIsNotInForce) {
    InterpreterOptions options;
    options.offsets.shift[0] = 3.0;
    const auto read = read_program("G0 X1\nG92.3\nG0 X1\nM2\n", options);
    EXPECT_EQ(read->records[0].end[0], 1.0);
    EXPECT_EQ(read->records[1].end[0], 4.0);
}

TEST(KeptOffsets, AreToldWithAllThatHoldsWheneverOneIsSet) {
    const auto told =
        offsets_told("G10 L2 P2 Y5 R30\nG0 X4\nG92 X1\nG28.1\nG92.2\nG92.1\nG28\nM2\n", x_offset(2.0));
    ASSERT_EQ(told.size(), 5U);
    EXPECT_EQ(told[0].systems[0].origin[0], 2.0);
    EXPECT_EQ(told[0].systems[1].origin[1], 5.0);
    EXPECT_EQ(told[0].systems[1].rotation_deg, 30.0);
    EXPECT_TRUE(told[1].is_shifted);
    EXPECT_EQ(told[1].shift[0], 3.0);
    EXPECT_FALSE(told[1].references[0]);
    EXPECT_EQ((*told[2].references[0])[0], 6.0);
    EXPECT_FALSE(told[2].references[1]);
    EXPECT_FALSE(told[3].is_shifted);
    EXPECT_EQ(told[3].shift[0], 3.0);
    EXPECT_EQ(told[4].shift[0], 0.0);
}

TEST(KeptOffsets, AProgramThatSetsNoneTellsNothing) {
    EXPECT_TRUE(offsets_told("G55 G0 X1\nG43.1 Z4\n#100=5\nG28\nM2\n", x_offset(2.0)).empty());
}

TEST(KeptOffsets, OfABlockThatIsRefusedAreNotTold) {
    const auto told_by = [](const std::string& text) {
        TellingProgram sink;
        ProblemList problems;
        LineSource lines{bytes_of(text)};
        EXPECT_TRUE(interpret_program(lines, {}, sink, problems));
        EXPECT_EQ(problems.error_count(), 1U) << text;
        return sink.told.size();
    };
    EXPECT_EQ(told_by("G92.1 G1 X5\nM2\n"), 0U);
    EXPECT_EQ(told_by("G92.2 M98 P1.5\nM2\n"), 0U);
}

TEST(KeptOffsets, NoneIsSetBeyondWhatCanBeKept) {
    const auto code_of = [](const std::string& text) {
        const auto read = read_program(text, {});
        return read->faults();
    };
    for (const char* text :
         {"G20 G10 L2 P1 X999999999\nM2\n", "G20 G92 X-999999999\nM2\n",
          "G10 L2 P1 X999999999\nG10 L20 P2 X-999999999\nG0 X0\nG10 L20 P2 X-999999999\nM2\n"})
        EXPECT_FALSE(code_of(text).empty()) << text;
    EXPECT_TRUE(code_of("G10 L2 P1 X999999999 R360\nM2\n").empty());
}

}  // namespace
}  // namespace psicarve::gcode
