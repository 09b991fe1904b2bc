// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/text_places.hpp"

#include <gtest/gtest.h>

namespace psicarve::profile {
namespace {

TEST(TextPlaces, CountsCodePointsFromOne) {
    const std::string_view text =
        "a\xC3\xA4"
        "b\n\xF0\x9F\x94\xA7=1\nend";
    const TextPlaces sut{text};
    EXPECT_EQ(text[sut.offset_of(1, 1)], 'a');
    EXPECT_EQ(text[sut.offset_of(1, 3)], 'b');
    EXPECT_EQ(text[sut.offset_of(2, 2)], '=');
    EXPECT_EQ(text.substr(sut.offset_of(3, 1)), "end");
    EXPECT_EQ(sut.offset_of(3, 4), text.size());
    EXPECT_EQ(sut.offset_of(4, 1), text.size());
    EXPECT_EQ(sut.offset_of(0, 0), text.size());
}

TEST(TextPlaces, PassesOverAByteOrderMark) {
    const TextPlaces sut{"\xEF\xBB\xBFx = 1\n"};
    EXPECT_EQ(sut.text_begin(), 3U);
    EXPECT_EQ(sut.offset_of(1, 1), 3U);
    EXPECT_EQ(sut.line_begin(5), 3U);
}

TEST(TextPlaces, KnowsWhereLinesBeginAndEnd) {
    const TextPlaces sut{"one\ntwo\n\nfour"};
    EXPECT_EQ(sut.line_begin(0), 0U);
    EXPECT_EQ(sut.line_begin(3), 0U) << "its own end belongs to it";
    EXPECT_EQ(sut.line_end(3), 4U);
    EXPECT_EQ(sut.line_begin(4), 4U);
    EXPECT_EQ(sut.line_end(8), 9U);
    EXPECT_EQ(sut.line_end(9), 13U);
}

TEST(TextPlaces, EndsLinesAsTheFirstOneDoes) {
    EXPECT_EQ(TextPlaces{"a\r\nb\n"}.newline(), "\r\n");
    EXPECT_EQ(TextPlaces{"a\nb\r\n"}.newline(), "\n");
    EXPECT_EQ(TextPlaces{"\n"}.newline(), "\n");
    EXPECT_EQ(TextPlaces{""}.newline(), "\n");
}

}  // namespace
}  // namespace psicarve::profile
