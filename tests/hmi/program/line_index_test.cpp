// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/line_index.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <random>
#include <string>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve::program {
namespace {

std::string numbered(std::uint64_t line) {
    return "N" + std::to_string(line) + " G1 X" + std::to_string(line % 97);
}

/// In pieces of all sizes, as a file is read.
LineIndex index_of(const std::string& text) {
    LineIndex index;
    std::mt19937 random{7};
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = std::min<std::size_t>(text.size() - at, random() % 5000);
        index.note({text.data() + at, length});
        at += length;
    }
    return index;
}

TEST(LineIndex, FindsEveryLineOfAMillionInConstantMemory) {
    constexpr std::uint64_t kLines = 1'000'000;
    std::string text;
    for (std::uint64_t line = 1; line <= kLines; ++line) text += numbered(line) + "\n";
    const test::TemporaryFolder folder;
    const std::string path = folder.path("million.ngc");
    std::ofstream{path, std::ios::binary} << text;
    const LineIndex sut = index_of(text);
    EXPECT_EQ(sut.line_count(), kLines);
    EXPECT_LE(sut.mark_count(), LineIndex::kMostMarks);
    EXPECT_GE(sut.mark_count(), LineIndex::kMostMarks / 2 - 1);
    const auto state = gcode::state_of_program(path);
    ASSERT_TRUE(state);
    for (const std::uint64_t first : {1ULL, 2ULL, 31ULL, 65'536ULL, 499'999ULL, 999'998ULL, 1'000'000ULL}) {
        const auto lines = read_lines(path, *state, sut, first, 3);
        ASSERT_TRUE(lines) << first;
        ASSERT_EQ(lines->size(), std::min<std::uint64_t>(3, kLines - first + 1));
        for (std::size_t i = 0; i < lines->size(); ++i) EXPECT_EQ((*lines)[i], numbered(first + i));
    }
    const auto beyond = read_lines(path, *state, sut, kLines + 1, 3);
    ASSERT_TRUE(beyond);
    EXPECT_TRUE(beyond->empty());
}

TEST(LineIndex, CountsWhatStandsBehindTheLastLineFeed) {
    EXPECT_EQ(index_of("").line_count(), 0U);
    EXPECT_EQ(index_of("M2").line_count(), 1U);
    EXPECT_EQ(index_of("G0\nM2").line_count(), 2U);
    EXPECT_EQ(index_of("G0\nM2\n").line_count(), 2U);
    EXPECT_EQ(index_of("\n\n").line_count(), 2U);
}

TEST(LineIndex, CutsLongLinesAndLineEndsOff) {
    const test::TemporaryFolder folder;
    const std::string path = folder.path("long.ngc");
    const std::string text = std::string(200'000, 'X') + "\r\nG0 X1\r\nM2";
    std::ofstream{path, std::ios::binary} << text;
    const auto lines = read_lines(path, *gcode::state_of_program(path), index_of(text), 1, 9);
    ASSERT_TRUE(lines);
    ASSERT_EQ(lines->size(), 3U);
    EXPECT_EQ((*lines)[0].size(), kMostShownBytes);
    EXPECT_EQ((*lines)[1], "G0 X1");
    EXPECT_EQ((*lines)[2], "M2");
}

TEST(LineIndex, ReadsNoFileThatWasChangedSince) {
    const test::TemporaryFolder folder;
    const std::string path = folder.path("changed.ngc");
    std::ofstream{path} << "G0 X1\nM2\n";
    const auto state = *gcode::state_of_program(path);
    std::ofstream{path} << "G0 X1\nG0 X2\nM2\n";
    const auto lines = read_lines(path, state, index_of("G0 X1\nM2\n"), 1, 2);
    ASSERT_FALSE(lines);
    EXPECT_NE(lines.error().message.find("has been changed"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::program
