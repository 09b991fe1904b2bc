// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "shared/trace/trace_format.hpp"

namespace psicarve::test {

/// A binary trace as programs wrote it before there were jobs in it: version 1, without any.
inline std::string older_trace(const std::string& bytes) {
    std::string older = bytes.substr(0, sizeof(TraceHeader));
    const auto version = static_cast<std::uint32_t>(older[offsetof(TraceHeader, version)]);
    older[offsetof(TraceHeader, version)] = static_cast<char>(kOldestTraceVersion);
    const auto* at = reinterpret_cast<const std::uint8_t*>(bytes.data()) + trace_head_bytes(version);
    const auto* const end = reinterpret_cast<const std::uint8_t*>(bytes.data()) + bytes.size();
    const auto number = [&] {
        std::uint64_t value = 0;
        if (at != nullptr) at = decode_leb128(at, end, value);
        return value;
    };
    while (at != nullptr && at != end) {
        const auto* const record = at;
        const TraceRecordKind kind = trace_record_kind(number());
        int numbers = 0;
        if (kind == TraceRecordKind::position) numbers = kAxisCount;
        if (kind == TraceRecordKind::pins_with_offset) numbers = 2;
        for (; numbers > 0; --numbers) number();
        if (kind == TraceRecordKind::pins && number() == 0) {
            const std::uint64_t job_bytes = number();
            at += kTraceChecksumBytes + job_bytes;
            continue;
        }
        if (at != nullptr)
            older.append(reinterpret_cast<const char*>(record), static_cast<std::size_t>(at - record));
    }
    return older;
}

}  // namespace psicarve::test
