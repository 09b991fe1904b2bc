// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/base/spsc_ring.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <thread>

namespace psicarve {
namespace {

TEST(SpscRing, IsEmptyAtFirst) {
    SpscRing<int, 4> sut;
    int value = 7;
    EXPECT_EQ(sut.front(), nullptr);
    EXPECT_FALSE(sut.pop_into(value));
    EXPECT_EQ(value, 7);
    EXPECT_EQ(sut.size(), 0U);
}

TEST(SpscRing, GivesBackInOrderWhatWasPushed) {
    SpscRing<int, 4> sut;
    for (int i = 1; i <= 3; ++i) EXPECT_TRUE(sut.push(i));
    for (int i = 1; i <= 3; ++i) {
        int value = 0;
        ASSERT_TRUE(sut.pop_into(value));
        EXPECT_EQ(value, i);
    }
    EXPECT_EQ(sut.front(), nullptr);
}

TEST(SpscRing, PushFailsWhenFullAndOverwritesNothing) {
    SpscRing<int, 4> sut;
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(sut.push(i));
    EXPECT_FALSE(sut.push(99));
    EXPECT_EQ(sut.size(), sut.capacity());
    EXPECT_EQ(*sut.front(), 0);
    sut.pop();
    EXPECT_TRUE(sut.push(4));
    EXPECT_FALSE(sut.push(5));
    for (int i = 1; i <= 4; ++i) {
        EXPECT_EQ(*sut.front(), i);
        sut.pop();
    }
}

TEST(SpscRing, ShowsWhatIsBehindItsFront) {
    SpscRing<int, 4> sut;
    for (int round = 0; round < 10; ++round) {
        EXPECT_EQ(sut.ahead(0), nullptr);
        for (int i = 0; i < 3; ++i) ASSERT_TRUE(sut.push(10 * round + i));
        for (std::size_t i = 0; i < 3; ++i) {
            ASSERT_NE(sut.ahead(i), nullptr);
            EXPECT_EQ(*sut.ahead(i), 10 * round + static_cast<int>(i));
        }
        EXPECT_EQ(sut.ahead(3), nullptr);
        for (int i = 0; i < 3; ++i) sut.pop();
    }
}

TEST(SpscRing, GoesRoundManyTimes) {
    SpscRing<std::uint64_t, 8> sut;
    std::uint64_t read = 0;
    for (std::uint64_t written = 0; written < 1000; ++written) {
        ASSERT_TRUE(sut.push(written));
        if (written % 3 != 0) continue;
        std::uint64_t value = 0;
        while (sut.pop_into(value)) ASSERT_EQ(value, read++);
    }
}

TEST(SpscRingThreads, CarriesEveryEntryWholeBetweenTwoThreads) {
    struct Entry {
        std::uint64_t number;
        std::uint64_t words[6];
    };
    constexpr std::uint64_t kEntries = 300'000;
    auto sut = std::make_unique<SpscRing<Entry, 64>>();
    std::thread writer([&] {
        for (std::uint64_t n = 0; n < kEntries; ++n) {
            const Entry entry{n, {n, ~n, n * 3, n ^ 5, n + 7, n << 1}};
            while (!sut->push(entry)) std::this_thread::yield();
        }
    });
    std::uint64_t wrong = 0;
    for (std::uint64_t n = 0; n < kEntries;) {
        Entry entry{};
        if (!sut->pop_into(entry)) {
            std::this_thread::yield();
            continue;
        }
        if (entry.number != n || entry.words[1] != ~n || entry.words[5] != n << 1) ++wrong;
        ++n;
    }
    writer.join();
    EXPECT_EQ(wrong, 0U);
    EXPECT_EQ(sut->size(), 0U);
}

}  // namespace
}  // namespace psicarve
