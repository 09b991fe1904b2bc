// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

std::vector<std::uint64_t> lines_of_ways(const MadeRecords& made) {
    std::vector<std::uint64_t> lines;
    for (const MotionRecord& record : made.records)
        if (record.kind == MotionKind::way) lines.push_back(record.line);
    return lines;
}

TEST(RecordsOfLoops, EndABlockWithEachPass) {
    const MadeRecords made = made_records(
        "F100 G91\no1 repeat [3]\nG1 Y1\no1 endrepeat\nM98 P5 L2\nM2\nO5\nG1 Y1\nM99\n", {}, Profile{});
    ASSERT_EQ(made.faults, Faults{});
    EXPECT_EQ(lines_of_ways(made), (std::vector<std::uint64_t>{3, 3, 3, 8, 8}));
    for (const MotionRecord& record : made.records)
        EXPECT_NE(record.flags & kEndsBlock, 0U) << record.sequence;
}

TEST(RecordsOfLoops, BeginWhereTheLineIsReachedFirst) {
    const std::string text = "F100 G91\no1 repeat [3]\nG1 Y1\nG1 C9\no1 endrepeat\nG1 Y2\nM2\n";
    RunOptions how;
    how.from_line = 4;
    const MadeRecords made = made_records(text, how, Profile{});
    ASSERT_EQ(made.failure, "");
    std::vector<std::uint64_t> lines = lines_of_ways(made);
    // The way to where the program stands by then bears the same number.
    const std::vector<std::uint64_t> tail{3, 4, 3, 4, 6};
    ASSERT_GE(lines.size(), tail.size() + 1);
    EXPECT_TRUE(std::equal(tail.rbegin(), tail.rend(), lines.rbegin()));
    lines.resize(lines.size() - tail.size());
    for (const std::uint64_t line : lines) EXPECT_EQ(line, 4U);
}

/// Lines of the ways of a program that begins with this one.
std::vector<std::uint64_t> lines_from(const std::string& text, std::uint64_t line) {
    RunOptions how;
    how.from_line = line;
    const MadeRecords made = made_records(text, how, Profile{});
    EXPECT_EQ(made.failure, "") << line;
    return lines_of_ways(made);
}

TEST(RecordsOfLoops, DoNotBeginInASubroutineBehindTheLine) {
    using Lines = std::vector<std::uint64_t>;
    const std::string text =
        "F100 G91\nG0 Y1\no1 call\nG1 Y2\nM98 P9\nM2\no1 sub\nG1 C9\n(none)\nG1 Y3\no1 endsub\nO9\nG1 "
        "Y4\nM99\n";
    // The way to where the program stands is heads, psi and y.
    EXPECT_EQ(lines_from(text, 4), (Lines{4, 4, 4, 4, 4, 13}));
    EXPECT_EQ(lines_from(text, 5), (Lines{5, 5, 5, 5, 13}));
    EXPECT_EQ(lines_from(text, 8), (Lines{8, 8, 8, 8, 8, 10, 4, 13}));
    EXPECT_EQ(lines_from(text, 9), (Lines{9, 9, 9, 9, 10, 4, 13}));
    EXPECT_EQ(lines_from(text, 13), (Lines{13, 13, 13, 13, 13}));
    EXPECT_EQ(lines_from("F100 G91\no1 call\nM2\no1 sub\nM98 P9\no1 endsub\nO9\nG1 Y4\nM99\n", 5), Lines{8});
}

}  // namespace
}  // namespace psicarve::gcode
