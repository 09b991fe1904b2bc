// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/block_reader.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <random>

#include "hmi/gcode/number_reader.hpp"

namespace psicarve::gcode {
namespace {

/// Nothing is known of a machine.
struct NoState : ProgramState {
    StateAnswer numbered(std::uint32_t /*number*/) const override { return {}; }
    StateAnswer named(std::string_view /*name*/) const override { return {}; }
};

std::optional<Problem> read_alone(std::string_view line, std::uint64_t number, Block& block) {
    const NoState state;
    Parameters parameters{state};
    return read_block(line, number, parameters, {}, block);
}

/// "G0@1 X1.5@4" of a line that can be read.
std::string words_in(std::string_view line) {
    Block sut;
    const auto wrong = read_alone(line, 1, sut);
    EXPECT_FALSE(wrong.has_value()) << line;
    std::string text;
    for (const Word& word : sut.words()) {
        char part[64];
        std::snprintf(part, sizeof part, "%s%c%g@%u", text.empty() ? "" : " ", word.letter, word.value,
                      word.column);
        text += part;
    }
    return text;
}

TEST(BlockReader, ReadsEveryFormOfANumber) {
    EXPECT_EQ(words_in("X1. Y.5 Z+2 A-0.25 B007 C-.5"), "X1@1 Y0.5@5 Z2@9 A-0.25@13 B7@20 C-0.5@25");
}

TEST(BlockReader, ReadsBlanksAnywhereAndNone) {
    EXPECT_EQ(words_in("g0x1 2 . 5y-3\tz\t4 "), "G0@1 X12.5@3 Y-3@11 Z4@15");
    EXPECT_EQ(words_in("G1X1Y2\r"), "G1@1 X1@3 Y2@5");
}

TEST(BlockReader, LeavesOutCommentsAndCountsTheirBytes) {
    EXPECT_EQ(words_in("(\xc3\xa4) G1 (x) X2 ; Y3 ( ("), "G1@6 X2@13");
    EXPECT_EQ(words_in("(only this)"), "");
}

TEST(BlockReader, KnowsADeletedBlock) {
    Block sut;
    EXPECT_FALSE(read_alone(" /G1", 4, sut).has_value());
    EXPECT_TRUE(sut.is_deleted());
    EXPECT_EQ(sut.line(), 4U);
    EXPECT_FALSE(read_alone("G1", 5, sut).has_value());
    EXPECT_FALSE(sut.is_deleted());
}

TEST(BlockReader, KnowsALineOfPercent) {
    EXPECT_TRUE(is_percent_line(" %\r"));
    EXPECT_FALSE(is_percent_line("%%"));
    EXPECT_FALSE(is_percent_line(""));
}

TEST(BlockReader, HasRoomForTheLongestLine) {
    std::string line;
    while (line.size() < kMostLineBytes) line += "G1";
    Block sut;
    EXPECT_FALSE(read_alone(line, 1, sut).has_value());
    EXPECT_EQ(sut.words().size(), kMostLineBytes / 2);
    EXPECT_EQ(read_alone(line + " ", 1, sut)->code, ProblemCode::line_too_long);
}

TEST(NumberReader, IsRightToTheLastBit) {
    std::mt19937_64 random{7};
    std::uniform_int_distribution<int> digit{0, 9};
    for (int i = 0; i < 20'000; ++i) {
        std::string text;
        const int before = static_cast<int>(random() % 9);
        const int after = static_cast<int>(random() % 22) + (before == 0 ? 1 : 0);
        for (int k = 0; k < before; ++k) text += static_cast<char>('0' + digit(random));
        if (after > 0) text += '.';
        for (int k = 0; k < after; ++k) text += static_cast<char>('0' + digit(random));
        double expected = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), expected);
        const NumberReading sut = read_number(text, 0);
        ASSERT_EQ(sut.end, text.size()) << text;
        ASSERT_TRUE(sut.value.has_value()) << text;
        ASSERT_EQ(*sut.value, expected) << text;
    }
}

}  // namespace
}  // namespace psicarve::gcode
