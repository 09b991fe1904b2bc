// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/program/record_ring.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <cstring>
#include <random>
#include <thread>

#include "tests/shared/record_fixture.hpp"

namespace psicarve {
namespace {

using std::chrono::milliseconds;
using test::numbered_record;
using test::RingInMemory;

constexpr std::uint64_t kBeforeWrap = ~std::uint64_t{0} - 100;

/// Puts and takes as many at a time as a seed says, and sees each come out as it was put.
void expect_order(std::uint32_t capacity, std::uint64_t first, std::uint64_t count) {
    RingInMemory ring{capacity, first};
    RecordWriter writer{ring.get(), first};
    RecordReader reader{ring.get(), first};
    std::mt19937 random{capacity};
    std::uint64_t put = 0;
    std::uint64_t taken = 0;
    while (taken < count) {
        for (auto left = random() % (2 * capacity); left > 0 && put < count; --left) {
            const RingAnswer answer = writer.try_put(numbered_record(put + 1));
            ASSERT_EQ(answer, put - taken == capacity ? RingAnswer::not_yet : RingAnswer::done) << put;
            if (answer == RingAnswer::not_yet) break;
            ++put;
        }
        for (auto left = random() % (2 * capacity); left > 0; --left) {
            MotionRecord record{};
            const RingAnswer answer = reader.take(record);
            ASSERT_EQ(answer, put == taken ? RingAnswer::not_yet : RingAnswer::done) << taken;
            if (answer == RingAnswer::not_yet) break;
            ASSERT_TRUE(test::is_same(record, numbered_record(++taken))) << taken;
        }
        ASSERT_EQ(writer.queued(), put - taken);
        ASSERT_EQ(reader.queued(), put - taken);
    }
}

TEST(RecordRing, CapacitiesArePowersOfTwoWithinBounds) {
    for (const std::uint64_t good : {64U, 128U, 8'192U, 65'536U}) EXPECT_TRUE(is_ring_capacity(good));
    for (const std::uint64_t bad : {0U, 1U, 32U, 63U, 65U, 100U, 65'535U, 131'072U})
        EXPECT_FALSE(is_ring_capacity(bad)) << bad;
}

TEST(RecordRing, GivesInOrderWhatWasPutAcrossTheCapacity) {
    expect_order(64, 0, 2'000);
    expect_order(65'536, 0, 200'000);
}

TEST(RecordRing, GoesOnWhereIndicesComeToTheirEnd) {
    expect_order(64, kBeforeWrap, 2'000);
    expect_order(8'192, kBeforeWrap, 30'000);
}

TEST(RecordRing, HoldsAsManyAsItsCapacityAndNoMore) {
    RingInMemory ring;
    RecordWriter writer{ring.get(), 0};
    for (std::uint64_t i = 1; i <= kLeastRingRecords; ++i)
        ASSERT_EQ(writer.try_put(numbered_record(i)), RingAnswer::done);

    EXPECT_EQ(writer.try_put(numbered_record(65)), RingAnswer::not_yet);
    EXPECT_EQ(writer.put_for(numbered_record(65), milliseconds{1}), RingAnswer::not_yet);

    RecordReader reader{ring.get(), 0};
    MotionRecord first{};
    EXPECT_EQ(reader.take(first), RingAnswer::done);
    EXPECT_TRUE(test::is_same(first, numbered_record(1)));
    EXPECT_EQ(writer.put_for(numbered_record(65), milliseconds{1}), RingAnswer::done);
}

TEST(RecordRing, APutThatWaitsEndsWhenTheReaderIsGone) {
    RingInMemory ring;
    RecordWriter writer{ring.get(), 0};
    while (writer.try_put(numbered_record(1)) == RingAnswer::done) continue;
    int looks = 0;

    const RingAnswer answer = writer.put(numbered_record(2), [&] { return ++looks < 2; });

    EXPECT_EQ(answer, RingAnswer::gone);
    EXPECT_EQ(looks, 2);
}

TEST(RecordRing, AnEmptyOneIsWaitedForUntilTheLimit) {
    RingInMemory ring;
    RecordReader reader{ring.get(), 0};
    RecordWriter writer{ring.get(), 0};

    EXPECT_EQ(reader.wait_for(milliseconds{1}), RingAnswer::not_yet);
    ASSERT_EQ(writer.try_put(numbered_record(1)), RingAnswer::done);
    EXPECT_EQ(reader.wait_for(milliseconds{60'000}), RingAnswer::done);
}

TEST(RecordRing, ARecordThatDoesNotBearOutItsCheckIsTorn) {
    RingInMemory ring;
    RecordWriter writer{ring.get(), 0};
    RecordReader reader{ring.get(), 0};
    for (std::size_t word = 0; word < sizeof(MotionRecord) / 8; ++word) {
        ASSERT_EQ(writer.try_put(numbered_record(word + 1)), RingAnswer::done);
        ring.record(word).words[word].fetch_xor(std::uint64_t{1} << (5 * word));
        MotionRecord record{};
        EXPECT_EQ(reader.take(record), RingAnswer::torn) << word;
    }
}

TEST(RecordRing, AWritersIndexThatCannotBeIsNeverFollowed) {
    // Of a ring of 64 in which 10 are written and 4 taken: 10 to 68 can be.
    for (const std::uint64_t foreign : {std::uint64_t{0}, std::uint64_t{3}, std::uint64_t{9},
                                        std::uint64_t{69}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
        RingInMemory ring;
        RecordWriter writer{ring.get(), 0};
        RecordReader reader{ring.get(), 0};
        for (std::uint64_t i = 1; i <= 10; ++i)
            ASSERT_EQ(writer.try_put(numbered_record(i)), RingAnswer::done);
        MotionRecord record{};
        for (int i = 0; i < 4; ++i) ASSERT_EQ(reader.take(record), RingAnswer::done);

        ring.ends().written.store(foreign);

        EXPECT_EQ(reader.take(record), RingAnswer::broken) << foreign;
        ring.ends().written.store(10);
        EXPECT_EQ(reader.wait_for(milliseconds{0}), RingAnswer::broken);
        EXPECT_EQ(reader.take(record), RingAnswer::broken) << "it is never believed again, " << foreign;
    }
}

TEST(RecordRing, AReadersIndexThatCannotBeIsNeverFollowed) {
    // Of a ring of 64 in which 64 are written and 20 taken: 20 to 64 can be.
    for (const std::uint64_t foreign : {std::uint64_t{0}, std::uint64_t{19}, std::uint64_t{65},
                                        std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
        RingInMemory ring;
        RecordWriter writer{ring.get(), 0};
        RecordReader reader{ring.get(), 0};
        for (std::uint64_t i = 1; i <= 64; ++i)
            ASSERT_EQ(writer.try_put(numbered_record(i)), RingAnswer::done);
        MotionRecord record{};
        for (int i = 0; i < 20; ++i) ASSERT_EQ(reader.take(record), RingAnswer::done);
        ASSERT_EQ(writer.queued(), 44U);

        ring.ends().taken.store(foreign);

        (void)writer.queued();
        EXPECT_EQ(writer.try_put(numbered_record(65)), RingAnswer::broken) << foreign;
        ring.ends().taken.store(20);
        (void)writer.queued();
        EXPECT_EQ(writer.put_for(numbered_record(65), milliseconds{60'000}), RingAnswer::broken);
    }
}

TEST(RecordRing, NobodyBelievesTheIndexThatIsHisOwn) {
    RingInMemory ring;
    RecordWriter writer{ring.get(), 0};
    RecordReader reader{ring.get(), 0};
    ASSERT_EQ(writer.try_put(numbered_record(1)), RingAnswer::done);
    ASSERT_EQ(writer.try_put(numbered_record(2)), RingAnswer::done);
    ring.ends().taken.store(1);
    MotionRecord record{};

    ASSERT_EQ(reader.take(record), RingAnswer::done);

    EXPECT_TRUE(test::is_same(record, numbered_record(1)));
    EXPECT_EQ(ring.ends().taken.load(), 1U);
    ring.ends().written.store(60);
    ASSERT_EQ(writer.try_put(numbered_record(3)), RingAnswer::done);
    EXPECT_EQ(ring.ends().written.load(), 3U);
}

// Both wait for each other again and again: a lost wake-up would last a hundred milliseconds each time.
TEST(RecordRing, TwoThreadsHandOverEveryRecordOnce) {
    constexpr std::uint64_t kCount = 60'000;
    for (const std::uint32_t capacity : {64U, 8'192U}) {
        RingInMemory ring{capacity, kBeforeWrap};
        std::thread writing{[&] {
            RecordWriter writer{ring.get(), kBeforeWrap};
            std::mt19937 random{1};
            for (std::uint64_t i = 1; i <= kCount; ++i) {
                ASSERT_EQ(writer.put(numbered_record(i), [] { return true; }), RingAnswer::done);
                if (random() % 1'000 == 0) std::this_thread::yield();
            }
        }};
        RecordReader reader{ring.get(), kBeforeWrap};
        std::mt19937 random{2};
        std::uint64_t wrong = 0;
        for (std::uint64_t i = 1; i <= kCount; ++i) {
            MotionRecord record{};
            while (reader.take(record) == RingAnswer::not_yet) (void)reader.wait_for(milliseconds{1'000});
            wrong += test::is_same(record, numbered_record(i)) ? 0U : 1U;
            if (random() % 1'000 == 0) std::this_thread::yield();
        }
        writing.join();
        EXPECT_EQ(wrong, 0U) << capacity;
        MotionRecord record{};
        EXPECT_EQ(reader.take(record), RingAnswer::not_yet);
    }
}

}  // namespace
}  // namespace psicarve
