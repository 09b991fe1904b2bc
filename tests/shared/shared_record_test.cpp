// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/shared_record.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

namespace {
std::atomic<int> yields{0};
}  // namespace

// Every yield of this program is counted.
extern "C" int sched_yield() noexcept {
    ++yields;
    return static_cast<int>(::syscall(SYS_sched_yield));
}

namespace psicarve {
namespace {

struct Sample {
    std::array<std::uint64_t, 37> values;
};

Sample sample_of(std::uint64_t number) {
    Sample sample{};
    sample.values.fill(number);
    return sample;
}

/// So large that reader and writer meet in the middle all the time.
struct LargeSample {
    std::array<std::uint64_t, 600> values;
};

LargeSample large_sample_of(std::uint64_t number) {
    LargeSample sample{};
    sample.values.fill(number);
    return sample;
}

bool is_whole(const LargeSample& sample) {
    for (const std::uint64_t value : sample.values) {
        if (value != sample.values.front()) return false;
    }
    return true;
}

using Ring = SharedRing<Sample, 16>;

TEST(SharedRecord, GivesBackWhatWasWritten) {
    const auto record = std::make_unique<SharedRecord<Sample>>();

    write_record(*record, sample_of(7));

    const auto read = read_record(*record);
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->values, sample_of(7).values);
}

TEST(SharedRecord, GivesNothingWhenItsWriterDiedHalfway) {
    const auto record = std::make_unique<SharedRecord<Sample>>();
    write_record(*record, sample_of(7));
    record->sequence.fetch_add(1);  // as a writer does before it writes
    const int yields_before = yields;

    EXPECT_FALSE(read_record(*record).has_value());
    // On a busy computer each may be a time slice of some milliseconds.
    EXPECT_LE(yields - yields_before, 20);
    EXPECT_GT(yields - yields_before, 0) << "a living one may wait for our processor";
}

TEST(SharedRecord, IsMendedByTheNextWriter) {
    const auto record = std::make_unique<SharedRecord<Sample>>();
    record->sequence.store(41);

    write_record(*record, sample_of(9));

    const auto read = read_record(*record);
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->values, sample_of(9).values);
}

TEST(SharedRecord, IsNeverReadTornWhileItIsBeingWritten) {
    constexpr std::uint64_t kWrites = 40'000;
    const auto record = std::make_unique<SharedRecord<LargeSample>>();
    std::thread writer{[&] {
        for (std::uint64_t number = 1; number <= kWrites; ++number)
            write_record(*record, large_sample_of(number));
    }};

    std::uint64_t last = 0;
    bool are_all_whole = true;
    bool is_in_order = true;
    while (last < kWrites) {
        const auto read = read_record(*record);
        if (!read) continue;
        are_all_whole = are_all_whole && is_whole(*read);
        is_in_order = is_in_order && read->values.front() >= last;
        last = read->values.front();
    }
    writer.join();

    EXPECT_TRUE(are_all_whole);
    EXPECT_TRUE(is_in_order);
}

TEST(SharedRing, GivesEveryEntryInOrder) {
    const auto ring = std::make_unique<Ring>();
    RingReader<Sample, 16> sut{*ring};
    EXPECT_FALSE(sut.next().has_value());

    for (std::uint64_t number = 0; number < 10; ++number) append_to_ring(*ring, sample_of(number));

    for (std::uint64_t number = 0; number < 10; ++number) {
        const auto entry = sut.next();
        ASSERT_TRUE(entry.has_value());
        EXPECT_EQ(entry->values.front(), number);
    }
    EXPECT_FALSE(sut.next().has_value());
    EXPECT_EQ(sut.lost(), 0U);
}

TEST(SharedRing, SlowReaderLosesTheOldestAndKnowsHowMany) {
    const auto ring = std::make_unique<Ring>();
    RingReader<Sample, 16> sut{*ring};
    for (std::uint64_t number = 0; number < 50; ++number) append_to_ring(*ring, sample_of(number));

    const auto entry = sut.next();

    ASSERT_TRUE(entry.has_value());
    EXPECT_EQ(entry->values.front(), 34U);
    EXPECT_EQ(sut.lost(), 34U);
}

TEST(SharedRing, KeepsItsPlaceAcrossManyWraparounds) {
    const auto ring = std::make_unique<Ring>();
    RingReader<Sample, 16> sut{*ring};
    for (std::uint64_t number = 0; number < 1000; ++number) {
        append_to_ring(*ring, sample_of(number));
        const auto entry = sut.next();
        ASSERT_TRUE(entry.has_value());
        ASSERT_EQ(entry->values.front(), number);
    }
    EXPECT_EQ(sut.lost(), 0U);
}

TEST(SharedRing, ReaderFromNowSkipsWhatWasBefore) {
    const auto ring = std::make_unique<Ring>();
    append_to_ring(*ring, sample_of(1));
    RingReader<Sample, 16> sut{*ring, /*from_now=*/true};
    EXPECT_FALSE(sut.next().has_value());

    append_to_ring(*ring, sample_of(2));

    EXPECT_EQ(sut.next().value().values.front(), 2U);
    EXPECT_EQ(sut.lost(), 0U);
}

TEST(SharedRing, EntriesOfAnEarlierWriterAreNotRead) {
    const auto ring = std::make_unique<Ring>();
    append_to_ring(*ring, sample_of(1));
    begin_ring_anew(*ring);
    append_to_ring(*ring, sample_of(2));

    RingReader<Sample, 16> sut{*ring};

    EXPECT_EQ(sut.next().value().values.front(), 2U);
}

TEST(SharedRing, EntryHalfWrittenByADeadWriterIsNotRead) {
    const auto ring = std::make_unique<Ring>();
    append_to_ring(*ring, sample_of(1));
    ring->claimed.fetch_add(1);
    ring->words[1][0].store(99);

    RingReader<Sample, 16> sut{*ring};

    EXPECT_EQ(sut.next().value().values.front(), 1U);
    EXPECT_FALSE(sut.next().has_value());
}

TEST(SharedRing, SurvivesCountersOverwrittenWithGarbage) {
    const auto ring = std::make_unique<Ring>();
    RingReader<Sample, 16> sut{*ring};
    ring->published.store(~std::uint64_t{0});
    ring->claimed.store(3);
    ring->first.store(~std::uint64_t{0} / 2);

    for (int round = 0; round < 40; ++round) (void)sut.next();

    ring->published.store(2);
    EXPECT_FALSE(sut.next().has_value());
}

TEST(SharedRing, ConcurrentReaderSeesWholeEntriesAndCountsTheRest) {
    constexpr std::uint64_t kEntries = 40'000;
    const auto ring = std::make_unique<SharedRing<LargeSample, 2>>();
    RingReader<LargeSample, 2> sut{*ring};
    std::thread writer{[&] {
        for (std::uint64_t number = 0; number < kEntries; ++number) {
            append_to_ring(*ring, large_sample_of(number));
        }
    }};

    std::uint64_t read_count = 0;
    std::uint64_t last = 0;
    bool are_all_right = true;
    while (last + 1 < kEntries) {
        const auto entry = sut.next();
        if (!entry) continue;
        last = entry->values.front();
        are_all_right = are_all_right && is_whole(*entry) && last == read_count + sut.lost();
        ++read_count;
    }
    writer.join();

    EXPECT_TRUE(are_all_right);
    EXPECT_EQ(read_count + sut.lost(), kEntries);
}

}  // namespace
}  // namespace psicarve
