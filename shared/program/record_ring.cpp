// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/program/record_ring.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace psicarve {
namespace {

constexpr std::size_t kRecordWords = sizeof(MotionRecord) / sizeof(std::uint64_t);
using RecordCopy = std::array<std::uint64_t, kRecordWords>;

RingRecord& record_at(const RecordRing& ring, std::uint64_t index) noexcept {
    return ring.records[index & (ring.capacity - 1)];
}

/// A writer that waits for room is woken when so many are free: at each one it would write a single record
/// between two sleeps.
std::uint64_t room_to_wake_for(const RecordRing& ring) noexcept {
    return ring.capacity / 4;
}

}  // namespace

// Who is to be woken: each side stores its index and then loads the other's, both sequentially consistent,
// and who is about to sleep has looked likewise before. So either the sleeper sees the new index, or the
// other side sees that it is the sleeper's turn, and signals; the event's counter keeps a signal that comes
// between look and sleep. Where a partner is dead or lies, every sleep has its limit.

RecordWriter::RecordWriter(const RecordRing& ring, std::uint64_t first) noexcept
    : ring_(ring), written_(first), taken_seen_(first) {}

/// False: the reader's index runs backwards, or past ours. `queued` of a good one never grows by itself.
bool RecordWriter::look() noexcept {
    if (is_broken_) return false;
    const std::uint64_t taken = ring_.ends->taken.load();
    is_broken_ = written_ - taken > written_ - taken_seen_;
    if (!is_broken_) taken_seen_ = taken;
    return !is_broken_;
}

RingAnswer RecordWriter::try_put(const MotionRecord& record) noexcept {
    if (is_broken_) return RingAnswer::broken;
    if (written_ - taken_seen_ == ring_.capacity) {
        if (!look()) return RingAnswer::broken;
        if (written_ - taken_seen_ == ring_.capacity) return RingAnswer::not_yet;
    }
    RecordCopy copy;
    std::memcpy(copy.data(), &record, sizeof(record));
    RingRecord& place = record_at(ring_, written_);
    for (std::size_t word = 0; word < kRecordWords; ++word)
        place.words[word].store(copy[word], std::memory_order_relaxed);
    ring_.ends->written.store(++written_);
    // The reader had taken all that there was, and may sleep.
    if (look() && written_ - taken_seen_ <= 1) event_signal(ring_.ends->was_put);
    return RingAnswer::done;
}

RingAnswer RecordWriter::put_for(const MotionRecord& record, std::chrono::nanoseconds limit) noexcept {
    using Clock = std::chrono::steady_clock;
    RingAnswer answer = try_put(record);
    if (answer != RingAnswer::not_yet) return answer;
    const Clock::time_point begin = Clock::now();
    for (;;) {
        const std::uint32_t seen = event_count(ring_.ends->was_taken);
        answer = try_put(record);
        const auto passed = Clock::now() - begin;
        if (answer != RingAnswer::not_yet || passed >= limit) return answer;
        event_wait_past(ring_.ends->was_taken, seen, limit - passed);
    }
}

std::uint64_t RecordWriter::queued() noexcept {
    (void)look();
    return written_ - taken_seen_;
}

RecordReader::RecordReader(const RecordRing& ring, std::uint64_t first) noexcept
    : ring_(ring), taken_(first), written_seen_(first) {}

/// False: the writer's index runs backwards, or further than there is room.
bool RecordReader::look() noexcept {
    if (is_broken_) return false;
    const std::uint64_t queued = ring_.ends->written.load() - taken_;
    is_broken_ = queued > ring_.capacity || queued < written_seen_ - taken_;
    if (!is_broken_) written_seen_ = taken_ + queued;
    return !is_broken_;
}

RingAnswer RecordReader::take(MotionRecord& record) noexcept {
    if (is_broken_) return RingAnswer::broken;
    if (taken_ == written_seen_) {
        if (!look()) return RingAnswer::broken;
        if (taken_ == written_seen_) return RingAnswer::not_yet;
    }
    RecordCopy copy;
    const RingRecord& place = record_at(ring_, taken_);
    for (std::size_t word = 0; word < kRecordWords; ++word)
        copy[word] = place.words[word].load(std::memory_order_relaxed);
    // Also for what was copied: it counts only if its writer still has a right index.
    if (!look()) return RingAnswer::broken;
    ring_.ends->taken.store(++taken_);
    if (!look()) return RingAnswer::broken;
    if (ring_.capacity - (written_seen_ - taken_) == room_to_wake_for(ring_))
        event_signal(ring_.ends->was_taken);
    std::memcpy(static_cast<void*>(&record), copy.data(), sizeof(record));
    return record.check == record_check(record) ? RingAnswer::done : RingAnswer::torn;
}

RingAnswer RecordReader::wait_for(std::chrono::nanoseconds limit) noexcept {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    for (;;) {
        const std::uint32_t seen = event_count(ring_.ends->was_put);
        if (!look()) return RingAnswer::broken;
        if (taken_ != written_seen_) return RingAnswer::done;
        const auto passed = Clock::now() - begin;
        if (passed >= limit) return RingAnswer::not_yet;
        event_wait_past(ring_.ends->was_put, seen, limit - passed);
    }
}

std::uint64_t RecordReader::queued() noexcept {
    (void)look();
    return written_seen_ - taken_;
}

}  // namespace psicarve
