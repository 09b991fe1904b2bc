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

}  // namespace
}  // namespace psicarve::gcode
