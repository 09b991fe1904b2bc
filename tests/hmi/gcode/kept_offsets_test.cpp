// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/kept_offsets.hpp"

#include "hmi/gcode/offsets_log.hpp"
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

TEST(OffsetsLog, HoldsNothingReachedBeforeTheMachineIsBehindIt) {
    OffsetsLog sut{x_offset(1.0)};
    sut.note(1);
    sut.set(x_offset(2.0), 1);
    sut.note(3);
    sut.note(4);
    sut.set(x_offset(3.0), 3);
    EXPECT_FALSE(sut.has_reached());
    sut.reach(0, 3);
    EXPECT_FALSE(sut.has_reached());
    sut.reach(1, 3);
    EXPECT_TRUE(sut.has_reached());
    EXPECT_EQ(sut.reached(), x_offset(1.0));
    sut.reach(3, 3);
    EXPECT_EQ(sut.reached(), x_offset(2.0));
    sut.reach(4, 3);
    EXPECT_EQ(sut.reached(), x_offset(2.0));
    EXPECT_EQ(sut.last(), x_offset(3.0));
}

TEST(OffsetsLog, TakesTheEarliestPassOfALoopThatItMayBe) {
    OffsetsLog sut{x_offset(0.0)};
    for (int pass = 1; pass <= 3; ++pass) {
        sut.set(x_offset(pass), static_cast<std::uint64_t>(2 * (pass - 1)));
        sut.note(5);
        sut.note(6);
    }
    sut.reach(6, 6);
    EXPECT_EQ(sut.reached(), x_offset(1.0));
    // Seen in between: it has come by.
    sut.reach(5, 6);
    EXPECT_EQ(sut.reached(), x_offset(2.0));
    sut.reach(6, 4);
    EXPECT_EQ(sut.reached(), x_offset(2.0));
}

TEST(OffsetsLog, LeavesBehindWhatTheCoreCannotHaveAnyMore) {
    OffsetsLog sut{x_offset(0.0)};
    for (std::uint64_t n = 0; n < OffsetsLog::kMostAhead; ++n) {
        sut.note(5);
        sut.note(6);
    }
    sut.set(x_offset(1.0), 2 * OffsetsLog::kMostAhead);
    for (std::uint64_t n = 0; n < OffsetsLog::kMostAhead; ++n) {
        sut.note(5);
        sut.note(6);
    }
    sut.reach(5, 2 * OffsetsLog::kMostAhead);
    EXPECT_EQ(sut.reached(), x_offset(0.0));
    sut.reach(5, 4 * OffsetsLog::kMostAhead);
    EXPECT_EQ(sut.reached(), x_offset(1.0));
}

}  // namespace
}  // namespace psicarve::gcode
