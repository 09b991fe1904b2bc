// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/stop_words.hpp"

#include <gtest/gtest.h>

namespace psicarve::cycle {
namespace {

Request seen(std::uint32_t stops, std::uint32_t emergency_stops) {
    Request request{};
    request.stops_seen = stops;
    request.emergency_stops_seen = emergency_stops;
    return request;
}

TEST(StopWords, TakeEachChangeOfEitherWordOnce) {
    UrgentWords words;
    StopWords sut;
    EXPECT_FALSE(sut.take_stop(words));
    words.stop_requests = 1;
    EXPECT_TRUE(sut.take_stop(words));
    EXPECT_FALSE(sut.take_stop(words));
    words.stop_word = 3;
    EXPECT_FALSE(sut.take_emergency_stop(words)) << "each kind has words of its own";
    EXPECT_TRUE(sut.take_stop(words));
    words.estop_word = 1;
    EXPECT_TRUE(sut.take_emergency_stop(words));
    words.estop_requests = 1;
    EXPECT_TRUE(sut.take_emergency_stop(words));
    EXPECT_FALSE(sut.take_emergency_stop(words));
    EXPECT_FALSE(sut.take_stop(words));
}

TEST(StopWords, TakeNoChangeOfTheSegmentForAStop) {
    UrgentWords words;
    StopWords sut;
    words.stop_word = std::uint64_t{7} << 32U;
    EXPECT_FALSE(sut.take_stop(words)) << "the high half says which segment it is";
}

TEST(StopWords, OvertakeWhatWasAskedForBeforeAStopOfEitherKind) {
    for (const bool is_emergency : {false, true}) {
        UrgentWords words;
        StopWords sut;
        EXPECT_FALSE(sut.have_overtaken(seen(0, 0)));
        (is_emergency ? words.estop_word : words.stop_word) = 1;
        EXPECT_FALSE(sut.have_overtaken(seen(0, 0))) << "it is not acted on yet";
        (void)sut.take_stop(words);
        (void)sut.take_emergency_stop(words);
        EXPECT_TRUE(sut.have_overtaken(seen(0, 0)));
        EXPECT_FALSE(sut.have_overtaken(is_emergency ? seen(0, 1) : seen(1, 0))) << "its sender knew of it";
    }
}

TEST(StopWords, ComeFirstWhenTheSenderKnewOfThem) {
    UrgentWords words;
    StopWords sut;
    EXPECT_TRUE(sut.comes_after_one_not_taken(seen(1, 0)));
    EXPECT_TRUE(sut.comes_after_one_not_taken(seen(0, 1)));
    words.stop_word = 1;
    words.estop_word = 1;
    (void)sut.take_stop(words);
    (void)sut.take_emergency_stop(words);
    EXPECT_FALSE(sut.comes_after_one_not_taken(seen(1, 1)));
    EXPECT_FALSE(sut.have_overtaken(seen(1, 1)));
}

TEST(StopWords, CountOnWhereTheWordOverflows) {
    UrgentWords words;
    StopWords sut;
    words.stop_word = 0xFFFF'FFFF;
    (void)sut.take_stop(words);
    words.stop_word = 0;
    EXPECT_TRUE(sut.take_stop(words));
    EXPECT_TRUE(sut.have_overtaken(seen(0xFFFF'FFFF, 0)));
    EXPECT_TRUE(sut.comes_after_one_not_taken(seen(1, 0)));
}

}  // namespace
}  // namespace psicarve::cycle
