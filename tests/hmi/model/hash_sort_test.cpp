// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/hash_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace psicarve::model {
namespace {

std::vector<std::uint64_t> random_hashes(std::size_t count, std::uint64_t mask) {
    std::mt19937_64 random(count);
    std::vector<std::uint64_t> hashes(count);
    for (std::uint64_t& hash : hashes) hash = random() & mask;
    return hashes;
}

// Hashes as they come, many of them equal, all alike in the bits that are looked at first, few.
TEST(HashSort, SortsAsAnyOtherSort) {
    for (const std::size_t count : {0U, 1U, 100U, 4096U, 50'000U}) {
        for (const std::uint64_t mask : {~0ULL, 0xFFF0'0000'0000'0001ULL, 0x3FFULL << 40U, 0xFULL}) {
            std::vector<std::uint64_t> sut = random_hashes(count, mask);
            std::vector<std::uint64_t> expected = sut;
            std::sort(expected.begin(), expected.end());
            sort_by_hash(sut, [](std::uint64_t hash) { return hash; });
            EXPECT_EQ(sut, expected) << count << ' ' << mask;
        }
    }
}

TEST(HashSort, OfEqualHashesTheRestDecides) {
    using Pair = std::pair<std::uint64_t, std::uint32_t>;
    std::vector<Pair> sut;
    for (const std::uint64_t hash : random_hashes(20'000, 0xFF00'0000'0000'0000ULL))
        sut.emplace_back(hash, static_cast<std::uint32_t>(20'000 - sut.size()));
    std::vector<Pair> expected = sut;
    std::sort(expected.begin(), expected.end());
    sort_by_hash(sut, [](const Pair& pair) { return pair.first; });
    EXPECT_EQ(sut, expected);
}

TEST(HashSieve, LetsThroughWhatItHoldsAndLittleElse) {
    for (const std::size_t count : {1U, 70U, 10'000U}) {
        const std::vector<std::uint64_t> held = random_hashes(count, ~0ULL);
        const HashSieve sut(held);
        for (const std::uint64_t hash : held) ASSERT_TRUE(sut.may_hold(hash));
        const auto others = random_hashes(10'001, ~0ULL);
        const auto passed =
            std::count_if(others.begin(), others.end(), [&sut](std::uint64_t h) { return sut.may_hold(h); });
        EXPECT_LT(passed, 1000) << count;
    }
}

}  // namespace
}  // namespace psicarve::model
