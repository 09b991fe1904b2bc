// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "shared/machine/signal.hpp"

namespace psicarve {

// The compact binary pin trace (docs/trace.md). Little-endian; every number after the header is LEB128.
//
//   header    TraceHeader, 64 bytes; version 3: and TraceCrossed, 32 bytes
//   records   number N, then what the record's kind asks for. N = 4*d + kind; d = ticks since the last
//             record (since tick 0 for the first):
//               kind 0  pins      XOR word: old levels ^ new levels (SignalWord); 0: a job, see below
//               kind 1  position  4 zig-zag numbers r1 r2 psi y [pulses]: what the core counts from here on
//                                 (homing defined it anew); pins unchanged
//               kind 2  pins      offset inside the tick [ns], then the XOR word
//               kind 3  end       the trace covers d more ticks and is complete. Nothing follows; a file
//                                 without this record was cut off
//
// A job (from version 2 on) is what the pins carve from here on, until the next one: a record of kind 0 whose
// change is 0; then the number of its bytes, its checksum (job_checksum, 8 bytes, little-endian), and the
// blob as it stands in a job file (shared/job/job.hpp), which carries the machine's profile.
//
// Time of a record [ns] = tick * period_ns + offset. Records come in the order in which things happened.

inline constexpr std::uint64_t kTraceMagic = 0x3143525441435350ULL;  // "PSCATRC1"
inline constexpr std::uint32_t kTraceVersion = 2;
/// Only where an axis stands within or beyond its gap, so that programs that do not know of it refuse the
/// trace instead of counting from elsewhere.
inline constexpr std::uint32_t kCrossedTraceVersion = 3;
inline constexpr std::uint32_t kOldestTraceVersion = 1;  ///< without jobs

/// The two lowest bits of a record's first number.
enum class TraceRecordKind : std::uint8_t { pins = 0, position = 1, pins_with_offset = 2, end = 3 };
inline constexpr unsigned kTraceKindBits = 2;

struct TraceHeader {
    std::uint64_t magic;
    std::uint32_t version;
    SignalWord initial_levels;  ///< all signals at tick 0
    std::int64_t period_ns;
    std::int64_t position_pulses[kAxisCount];  ///< as counted before the first value
    std::uint64_t reserved;                    ///< 0
};
static_assert(sizeof(TraceHeader) == 64);

/// How much of each axis' gap (its backlash) was crossed downwards before the first value.
struct TraceCrossed {
    std::int64_t crossed_pulses[kAxisCount];
};
static_assert(sizeof(TraceCrossed) == 32);

/// From here on there are records.
constexpr std::size_t trace_head_bytes(std::uint32_t version) noexcept {
    return sizeof(TraceHeader) + (version >= kCrossedTraceVersion ? sizeof(TraceCrossed) : 0);
}

constexpr std::uint64_t trace_record_head(std::uint64_t ticks_passed, TraceRecordKind kind) noexcept {
    return ticks_passed << kTraceKindBits | static_cast<std::uint64_t>(kind);
}
constexpr TraceRecordKind trace_record_kind(std::uint64_t head) noexcept {
    return static_cast<TraceRecordKind>(head & ((std::uint64_t{1} << kTraceKindBits) - 1));
}
constexpr std::uint64_t trace_record_ticks(std::uint64_t head) noexcept {
    return head >> kTraceKindBits;
}

inline constexpr std::size_t kLeb128MaxBytes = 10;
/// The longest record: a head and four positions.
inline constexpr std::size_t kTraceRecordMaxBytes = 5 * kLeb128MaxBytes;

/// A longer job is garbage.
inline constexpr std::uint64_t kMostTraceJobBytes = std::uint64_t{1} << 36;

/// Writes `value` seven bits a byte, lowest first, and returns the place after it. Needs kLeb128MaxBytes of
/// room. RT: yes.
constexpr std::uint8_t* encode_leb128(std::uint8_t* out, std::uint64_t value) noexcept {
    while (value >= 0x80) {
        *out++ = static_cast<std::uint8_t>(value | 0x80);
        value >>= 7;
    }
    *out++ = static_cast<std::uint8_t>(value);
    return out;
}

/// Reads a number that begins at `in` and returns the place after it; nullptr when it does not end before
/// `end` or does not fit 64 bits.
constexpr const std::uint8_t* decode_leb128(const std::uint8_t* in, const std::uint8_t* end,
                                            std::uint64_t& value) noexcept {
    value = 0;
    for (unsigned shift = 0; in != end && shift < 64; shift += 7) {
        const std::uint64_t bits = *in & 0x7F;
        if (shift == 63 && bits > 1) return nullptr;
        value |= bits << shift;
        if ((*in++ & 0x80) == 0) return in;
    }
    return nullptr;
}

inline constexpr std::size_t kTraceChecksumBytes = 8;

/// The record of a job, in the tick of the record before it, up to its blob. Returns as encode_leb128 does.
/// Needs kTraceRecordMaxBytes of room.
constexpr std::uint8_t* encode_trace_job_head(std::uint8_t* out, std::uint64_t job_bytes,
                                              std::uint64_t checksum) noexcept {
    out = encode_leb128(out, trace_record_head(0, TraceRecordKind::pins));
    out = encode_leb128(out, 0);
    out = encode_leb128(out, job_bytes);
    for (std::size_t i = 0; i < kTraceChecksumBytes; ++i)
        *out++ = static_cast<std::uint8_t>(checksum >> 8 * i);
    return out;
}
constexpr std::uint64_t decode_trace_checksum(const std::uint8_t* in) noexcept {
    std::uint64_t checksum = 0;
    for (std::size_t i = 0; i < kTraceChecksumBytes; ++i) checksum |= std::uint64_t{in[i]} << 8 * i;
    return checksum;
}

/// Small numbers of either sign become small numbers: 0, -1, 1, -2 ... -> 0, 1, 2, 3 ...
constexpr std::uint64_t zigzag_from(std::int64_t value) noexcept {
    return static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
}
constexpr std::int64_t value_from_zigzag(std::uint64_t zigzag) noexcept {
    return static_cast<std::int64_t>(zigzag >> 1 ^ (~(zigzag & 1) + 1));
}

}  // namespace psicarve
