// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/dual_head_dda.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace psicarve::cycle {
namespace {

using Deltas = std::array<std::int64_t, kAxisCount>;

/// Runs `iterations` of a line and checks the distance from the straight line after each.
void expect_on_the_line(const Deltas& deltas, std::int64_t iterations) {
    DualHeadDda sut;
    sut.start(deltas);
    const std::int64_t capacity = sut.iterations_left();
    Deltas emitted{};
    Deltas off{};
    for (std::int64_t n = 1; n <= iterations; ++n) {
        const std::uint32_t axes = sut.iterate();
        ASSERT_NE(axes, 0U) << "iteration " << n << " of " << capacity;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            emitted[k] += axes >> k & 1U;
            // |emitted - n * |d| / S| <= 1/2, times S, carried on: whole numbers that cannot overflow.
            off[k] += ((axes >> k & 1U) != 0 ? capacity : 0) - std::abs(deltas[k]);
            ASSERT_LE(2 * std::abs(off[k]), capacity) << "axis " << k << " iteration " << n;
        }
    }
    if (iterations < capacity) return;
    EXPECT_EQ(sut.iterations_left(), 0);
    for (std::size_t k = 0; k < kAxisCount; ++k) EXPECT_EQ(emitted[k], std::abs(deltas[k]));
}

TEST(DualHeadDda, EmitsExactCountsWithinHalfAPulseOfTheLine) {
    std::mt19937_64 random(11);
    for (int round = 0; round < 3000; ++round) {
        const auto most = static_cast<std::int64_t>(1 + random() % 400);
        Deltas deltas{};
        for (std::int64_t& delta : deltas)
            delta = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most + 1)) - most;
        DualHeadDda probe;
        probe.start(deltas);
        expect_on_the_line(deltas, probe.iterations_left());
    }
}

TEST(DualHeadDda, KeepsTheOrderOfAWholeLineThatIsCutIntoParts) {
    std::mt19937_64 random(12);
    for (int round = 0; round < 2000; ++round) {
        Deltas line{};
        for (std::int64_t& delta : line) delta = static_cast<std::int64_t>(random() % 401) - 200;
        DualHeadDda whole;
        whole.start(line);
        const std::int64_t capacity = whole.iterations_left();
        std::int64_t done = 0;
        while (done < capacity) {
            const auto count =
                1 + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(capacity - done));
            DualHeadDda part;
            part.start_within(line, done, count);
            ASSERT_EQ(part.iterations_left(), count);
            while (part.iterations_left() > 0) ASSERT_EQ(part.iterate(), whole.iterate()) << "after " << done;
            done += count;
        }
    }
}

TEST(DualHeadDda, StaysExactOverLongLines) {
    expect_on_the_line({14'400'000, -3'999'999, 7'200'001, 0}, 14'400'000);
}

TEST(DualHeadDda, DoesNotOverflowNearTheEndOfThirtyTwoBits) {
    constexpr std::int64_t kNear = (std::int64_t{1} << 31) - 1;
    expect_on_the_line({kNear, -kNear + 1, 1, kNear / 3}, 1'000'000);
    expect_on_the_line({kNear * 8, 5, -kNear * 7, kNear}, 1'000'000);
}

TEST(DualHeadDda, HasNoIterationWithoutAWay) {
    DualHeadDda sut;
    sut.start({0, 0, 0, 0});
    EXPECT_EQ(sut.iterations_left(), 0);
}

}  // namespace
}  // namespace psicarve::cycle
