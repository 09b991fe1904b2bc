// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/trace/binary_writer.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace psicarve::trace {

static_assert(std::endian::native == std::endian::little, "the header is written as it stands in memory");

BinaryWriter::BinaryWriter(TraceOutput out, const TraceStart& start) noexcept
    : out_(std::move(out)), levels_(start.levels) {
    TraceHeader header{.magic = kTraceMagic,
                       .version = start.has_crossed() ? kCrossedTraceVersion : kTraceVersion,
                       .initial_levels = start.levels,
                       .period_ns = start.period_ns,
                       .position_pulses = {},
                       .reserved = 0};
    std::copy(start.position_pulses.begin(), start.position_pulses.end(), header.position_pulses);
    std::uint8_t* place = out_.room(sizeof header + sizeof(TraceCrossed));
    std::memcpy(place, &header, sizeof header);
    place += sizeof header;
    if (start.has_crossed()) {
        TraceCrossed crossed{};
        std::copy(start.crossed_pulses.begin(), start.crossed_pulses.end(), crossed.crossed_pulses);
        std::memcpy(place, &crossed, sizeof crossed);
        place += sizeof crossed;
    }
    out_.commit(place);
}

void BinaryWriter::add(const TraceEntry& entry) noexcept {
    if (entry.kind == TraceEntry::Kind::position) {
        std::uint8_t* place = begin_record(entry.tick, TraceRecordKind::position);
        for (const std::int64_t position : entry.position_pulses) {
            place = encode_leb128(place, zigzag_from(position));
        }
        out_.commit(place);
        return;
    }
    const SignalWord changed = entry.levels ^ levels_;
    if (changed == 0) return;
    levels_ = entry.levels;
    std::uint8_t* place;
    if (entry.offset_ns == 0) {
        place = begin_record(entry.tick, TraceRecordKind::pins);
    } else {
        place = begin_record(entry.tick, TraceRecordKind::pins_with_offset);
        place = encode_leb128(place, entry.offset_ns);
    }
    out_.commit(encode_leb128(place, changed));
}

void BinaryWriter::add_job(const TracedJob& job) noexcept {
    std::uint8_t* const place = out_.room(kTraceRecordMaxBytes);
    out_.commit(encode_trace_job_head(place, job.blob.size(), job.checksum));
    out_.write({reinterpret_cast<const char*>(job.blob.data()), job.blob.size()});
}

void BinaryWriter::finish(std::uint64_t end_tick) noexcept {
    out_.commit(begin_record(std::max(end_tick, last_tick_), TraceRecordKind::end));
    out_.flush();
}

std::uint8_t* BinaryWriter::begin_record(std::uint64_t tick, TraceRecordKind kind) noexcept {
    const std::uint64_t passed = tick - std::exchange(last_tick_, tick);
    return encode_leb128(out_.room(kTraceRecordMaxBytes), trace_record_head(passed, kind));
}

}  // namespace psicarve::trace
