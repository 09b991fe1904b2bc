// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sched.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <optional>

#include "shared/segment/layout.hpp"

namespace psicarve {

// Values in shared memory are copied word by word. Each word is stored with release and loaded with acquire:
// a reader that meets a word of the next value therefore also sees the counter that announced it, without
// fences (which ThreadSanitizer does not model). On x86-64 these are plain moves.

inline constexpr int kRecordRetries = 1000;
/// After this many failed tries the writer may be a process that waits for our processor.
inline constexpr int kRetriesBeforeYield = 16;
/// On a busy computer each yield may take some milliseconds: a reader must not wait a second for a dead
/// writer.
inline constexpr int kMostYields = 16;

template <typename T>
using RecordWords = std::array<std::uint64_t, sizeof(T) / 8>;

template <typename T>
void store_words(AtomicWord64 (&words)[sizeof(T) / 8], const T& value) noexcept {
    RecordWords<T> copy;
    std::memcpy(copy.data(), &value, sizeof(T));
    for (std::size_t index = 0; index < copy.size(); ++index) {
        words[index].store(copy[index], std::memory_order_release);
    }
}

template <typename T>
T load_words(const AtomicWord64 (&words)[sizeof(T) / 8]) noexcept {
    RecordWords<T> copy;
    for (std::size_t index = 0; index < copy.size(); ++index) {
        copy[index] = words[index].load(std::memory_order_acquire);
    }
    T value;
    std::memcpy(static_cast<void*>(&value), copy.data(), sizeof(T));
    return value;
}

/// One writer only. Never waits. Also mends a record that a dead writer left half written.
template <typename T>
void write_record(SharedRecord<T>& record, const T& value) noexcept {
    const std::uint64_t writing = record.sequence.load(std::memory_order_relaxed) | 1U;
    record.sequence.store(writing, std::memory_order_relaxed);
    store_words<T>(record.words, value);
    record.sequence.store(writing + 1, std::memory_order_release);
}

/// Any process. Nothing when the writer kept it odd or changing for all retries (it died halfway, or writes
/// without a pause): the caller keeps its last good copy.
template <typename T>
std::optional<T> read_record(const SharedRecord<T>& record, int retries = kRecordRetries) noexcept {
    for (int attempt = 0; attempt < retries; ++attempt) {
        const std::uint64_t before = record.sequence.load(std::memory_order_acquire);
        if ((before & 1U) == 0) {
            const T value = load_words<T>(record.words);
            if (record.sequence.load(std::memory_order_relaxed) == before) return value;
        }
        const int yields = attempt - kRetriesBeforeYield;
        if (yields >= 0 && yields < kMostYields) ::sched_yield();
    }
    return std::nullopt;
}

/// The same of its first bytes alone, as words: for a large record of which a small part is wanted often.
template <std::size_t kBytes, typename T>
std::optional<std::array<std::uint64_t, kBytes / 8>> read_record_head(
    const SharedRecord<T>& record) noexcept {
    static_assert(kBytes % 8 == 0 && kBytes <= sizeof(T));
    for (int attempt = 0; attempt < kRecordRetries; ++attempt) {
        const std::uint64_t before = record.sequence.load(std::memory_order_acquire);
        std::array<std::uint64_t, kBytes / 8> head;
        for (std::size_t index = 0; index < head.size(); ++index)
            head[index] = record.words[index].load(std::memory_order_acquire);
        const bool is_whole = (before & 1U) == 0 && record.sequence.load(std::memory_order_relaxed) == before;
        if (is_whole) return head;
        const int yields = attempt - kRetriesBeforeYield;
        if (yields >= 0 && yields < kMostYields) ::sched_yield();
    }
    return std::nullopt;
}

/// One writer only. Never waits; overwrites the oldest.
template <typename T, std::size_t kEntries>
void append_to_ring(SharedRing<T, kEntries>& ring, const T& value) noexcept {
    const std::uint64_t position = ring.published.load(std::memory_order_relaxed);
    ring.claimed.store(position + 1, std::memory_order_relaxed);
    store_words<T>(ring.words[position % kEntries], value);
    ring.published.store(position + 1, std::memory_order_release);
}

/// One writer only, which has appended it, and `newer` after it. Word by word: a reader may see some words of
/// each.
template <typename T, std::size_t kEntries>
void replace_in_ring(SharedRing<T, kEntries>& ring, std::uint64_t newer, const T& value) noexcept {
    const std::uint64_t position = ring.published.load(std::memory_order_relaxed) - 1 - newer;
    store_words<T>(ring.words[position % kEntries], value);
}

/// One writer only: all entries so far belong to an earlier writer, and readers skip them.
template <typename T, std::size_t kEntries>
void begin_ring_anew(SharedRing<T, kEntries>& ring) noexcept {
    ring.first.store(ring.published.load(std::memory_order_relaxed), std::memory_order_release);
}

/// Reads a ring from its own position; several readers are independent of each other.
template <typename T, std::size_t kEntries>
class RingReader {
public:
    /// Starts at the oldest entry still there, or (from_now) behind the newest.
    explicit RingReader(const SharedRing<T, kEntries>& ring, bool from_now = false) noexcept : ring_(&ring) {
        const std::uint64_t published = ring.published.load(std::memory_order_acquire);
        position_ = from_now ? published : oldest(published);
    }

    /// The next entry; nothing when there is none yet.
    std::optional<T> next() noexcept {
        // Each turn either returns or moves on to entries that are newer by a whole ring: a reader that is
        // slower than that again and again gives up this call.
        for (int attempt = 0; attempt < kRecordRetries; ++attempt) {
            const std::uint64_t published = ring_->published.load(std::memory_order_acquire);
            if (position_ > published) position_ = published;  // not our ring any more, or overwritten
            skip_to(oldest(published));
            if (position_ == published) return std::nullopt;
            const T value = load_words<T>(ring_->words[position_ % kEntries]);
            if (ring_->claimed.load(std::memory_order_relaxed) - position_ <= kEntries) {
                ++position_;
                return value;
            }
        }
        return std::nullopt;
    }

    /// How many entries there were before the next one, since the segment was made.
    std::uint64_t position() const noexcept { return position_; }

    /// Entries that were overwritten before they could be read.
    std::uint64_t lost() const noexcept { return lost_; }

private:
    std::uint64_t oldest(std::uint64_t published) const noexcept {
        const std::uint64_t first = ring_->first.load(std::memory_order_acquire);
        const std::uint64_t kept = published > kEntries ? published - kEntries : 0;
        return first > kept && first <= published ? first : kept;
    }
    void skip_to(std::uint64_t position) noexcept {
        if (position <= position_) return;
        lost_ += position - position_;
        position_ = position;
    }

    const SharedRing<T, kEntries>* ring_;
    std::uint64_t position_ = 0;
    std::uint64_t lost_ = 0;
};

}  // namespace psicarve
