// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "shared/computer/event.hpp"
#include "shared/program/motion_record.hpp"

namespace psicarve {

// A queue of motion records between two processes: one writes, one reads, in shared memory that either may
// have overwritten. Each side keeps its own index and the capacity to itself; of the other's index it
// believes nothing but what the capacity allows. A record is copied out before it is looked at. Nothing
// here allocates or has an owner, so no process that dies leaves it locked. Not for the tick.
//
//     index    ... taken ........... written ...        written - taken <= capacity, whatever 2^64 does to
//     both record       | to be taken    | free

inline constexpr std::uint32_t kLeastRingRecords = 64;
inline constexpr std::uint32_t kMostRingRecords = 65'536;
inline constexpr std::uint32_t kDefaultRingRecords = 8'192;
constexpr bool is_ring_capacity(std::uint64_t records) noexcept {
    return records >= kLeastRingRecords && records <= kMostRingRecords && (records & (records - 1)) == 0;
}

/// A MotionRecord, word by word.
struct RingRecord {
    std::atomic<std::uint64_t> words[sizeof(MotionRecord) / sizeof(std::uint64_t)];
};
static_assert(sizeof(RingRecord) == sizeof(MotionRecord), "bump kLayoutVersion");

/// The words of a ring that both sides touch, those of each on a cache line of their own.
struct RingEnds {
    alignas(64) std::atomic<std::uint64_t> written;  ///< by the writer: records put
    EventWord was_put;                               ///< by the writer
    alignas(64) std::atomic<std::uint64_t> taken;    ///< by the reader: records taken
    EventWord was_taken;                             ///< by the reader
};
static_assert(sizeof(RingEnds) == 128 && std::is_standard_layout_v<RingEnds>, "bump kLayoutVersion");

/// Where a ring stands in this process. Requires is_ring_capacity(capacity); the number was checked once and
/// is never read from shared memory again.
struct RecordRing {
    RingEnds* ends;
    RingRecord* records;
    std::uint32_t capacity;
};

enum class RingAnswer : std::uint8_t {
    done,
    not_yet,  ///< full, or empty, until the time limit
    gone,     ///< the other side is no more
    broken,   ///< the other side's index is none that it can have: nothing is put or taken any more
    torn,     ///< a record was taken that does not bear out its check
};

/// How often who waits without a limit asks whether the other side is still there.
inline constexpr std::chrono::milliseconds kPartnerLook{100};

/// The one that writes.
class RecordWriter {
public:
    /// `first`: the index with which both sides begin; requires an empty ring there.
    RecordWriter(const RecordRing& ring, std::uint64_t first) noexcept;

    RingAnswer try_put(const MotionRecord& record) noexcept;
    RingAnswer put_for(const MotionRecord& record, std::chrono::nanoseconds limit) noexcept;
    /// Waits for room as long as `is_reader_there()` says so.
    template <typename IsReaderThere>
    RingAnswer put(const MotionRecord& record, const IsReaderThere& is_reader_there) {
        for (;;) {
            const RingAnswer answer = put_for(record, kPartnerLook);
            if (answer != RingAnswer::not_yet) return answer;
            if (!is_reader_there()) return RingAnswer::gone;
        }
    }
    /// How many the reader has not taken yet, as far as it is known.
    std::uint64_t queued() noexcept;

private:
    bool look() noexcept;

    RecordRing ring_;
    std::uint64_t written_;     // ours; the word in shared memory is only for the reader
    std::uint64_t taken_seen_;  // the last good one
    bool is_broken_ = false;
};

/// The one that reads.
class RecordReader {
public:
    RecordReader(const RecordRing& ring, std::uint64_t first) noexcept;

    /// Copies the next record. On `torn`, too: what it says is not to be believed.
    RingAnswer take(MotionRecord& record) noexcept;
    /// Waits until there is a record to take (done), or the limit has passed.
    RingAnswer wait_for(std::chrono::nanoseconds limit) noexcept;
    /// How many can be taken, as far as it is known.
    std::uint64_t queued() noexcept;

private:
    bool look() noexcept;

    RecordRing ring_;
    std::uint64_t taken_;         // ours; the word in shared memory is only for the writer
    std::uint64_t written_seen_;  // the last good one
    bool is_broken_ = false;
};

}  // namespace psicarve
