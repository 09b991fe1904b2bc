// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/base/printable.hpp"

#include <gtest/gtest.h>

#include <string>

namespace psicarve {
namespace {

TEST(Printable, LeavesWhatSteersNothing) {
    for (const std::string text : {"", "a b.stl", "two\nlines\tand more", "Zahnrad_größer.stl", "齿轮.stl",
                                   "шестерня", "\U0001F600", "back\\slash", "\u00a0\u0300"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesWhatSteers) {
    EXPECT_EQ(printable("\033[2Jx.stl"), "\\u001b[2Jx.stl");
    EXPECT_EQ(printable(std::string("a\0b\rc\x7f\bz", 8)), "a\\u0000b\\u000dc\\u007f\\u0008z");
    EXPECT_EQ(printable("\u009b2J"), "\\u009b2J") << "C1";
    EXPECT_EQ(printable("x\u202egnp.stl"), "x\\u202egnp.stl") << "turns the direction";
    EXPECT_EQ(printable("\u2066\u200f\u061c"), "\\u2066\\u200f\\u061c");
}

TEST(Printable, EscapesEveryByteThatIsNoUtf8) {
    EXPECT_EQ(printable("\x9b"), "\\x9b");
    EXPECT_EQ(printable("\xff"
                        "a"),
              "\\xffa");
    EXPECT_EQ(printable("\xc3"), "\\xc3") << "cut off";
    EXPECT_EQ(printable("\xe9\xbd"
                        "a"),
              "\\xe9\\xbda");
    EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b") << "longer than it must be";
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half a surrogate";
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
}

TEST(Printable, KnowsWhereALetterIsCutOff) {
    const std::string text = "a齿";
    EXPECT_EQ(unfinished_letter_bytes(text), 0U);
    EXPECT_EQ(unfinished_letter_bytes(text.substr(0, 3)), 2U);
    EXPECT_EQ(unfinished_letter_bytes(text.substr(0, 2)), 1U);
    EXPECT_EQ(unfinished_letter_bytes("a"), 0U);
    EXPECT_EQ(unfinished_letter_bytes("\x80\x80\x80\x80"), 0U);
    EXPECT_EQ(unfinished_letter_bytes(""), 0U);
}

}  // namespace
}  // namespace psicarve
