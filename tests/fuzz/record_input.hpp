// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "shared/program/motion_record.hpp"

namespace psicarve::fuzz {

// What record_fuzz reads: how a program is run, its records, and what is overwritten in the ring meanwhile.
//
//     how | pace | passes | 5 bytes that say nothing | record ... record | edit ... edit
//
// An edit has four bytes; edits are what is left behind the last whole record.

inline constexpr std::size_t kRecordInputHead = 8;

/// Bits of `how`.
inline constexpr std::uint8_t kIsForeign =
    1;  ///< records stand there as they are; otherwise signed by a writer
inline constexpr std::uint8_t kIsSingle = 2;  ///< a halt after each block
inline constexpr std::uint8_t kHasBacklash = 4;
inline constexpr std::uint8_t kIsTwoTimer = 8;
inline constexpr std::uint8_t kLiftsOnHold = 16;
inline constexpr std::uint8_t kIsHeld = 32;  ///< an operator holds, resumes and overrides

/// One byte that changes: after how many records, where, and how.
struct RingEdit {
    std::uint8_t after;
    std::uint8_t place_low;
    std::uint8_t place_high;
    std::uint8_t flip;
};
static_assert(sizeof(RingEdit) == 4);

struct RecordInput {
    std::uint8_t how = 0;
    std::uint8_t pace = 0;    ///< records that come at a time
    std::uint8_t passes = 0;  ///< how often they come once more, one pass behind the other
    std::vector<MotionRecord> records;
    std::vector<RingEdit> edits;
};

inline RecordInput record_input(std::span<const std::uint8_t> bytes) {
    RecordInput input;
    if (bytes.size() < kRecordInputHead) return input;
    input.how = bytes[0];
    input.pace = bytes[1];
    input.passes = bytes[2];
    bytes = bytes.subspan(kRecordInputHead);
    input.records.resize(bytes.size() / sizeof(MotionRecord));
    const std::size_t of_records = input.records.size() * sizeof(MotionRecord);
    if (of_records > 0) std::memcpy(static_cast<void*>(input.records.data()), bytes.data(), of_records);
    bytes = bytes.subspan(of_records);
    input.edits.resize(bytes.size() / sizeof(RingEdit));
    if (!input.edits.empty())
        std::memcpy(input.edits.data(), bytes.data(), input.edits.size() * sizeof(RingEdit));
    return input;
}

inline std::vector<std::byte> bytes_of_input(std::uint8_t how, std::uint8_t pace, std::uint8_t passes,
                                             std::span<const MotionRecord> records) {
    std::vector<std::byte> bytes(kRecordInputHead + records.size_bytes());
    bytes[0] = static_cast<std::byte>(how);
    bytes[1] = static_cast<std::byte>(pace);
    bytes[2] = static_cast<std::byte>(passes);
    if (!records.empty()) std::memcpy(bytes.data() + kRecordInputHead, records.data(), records.size_bytes());
    return bytes;
}

}  // namespace psicarve::fuzz
