// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/trace/binary_reader.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "shared/job/job.hpp"
#include "shared/trace/trace_format.hpp"

namespace psicarve::verify {

namespace {

constexpr SignalWord kAllSignals = kOutputMask | kInputMask;

/// Walks over the numbers of one record.
class NumberCursor {
public:
    explicit NumberCursor(std::string_view bytes)
        : at_(reinterpret_cast<const std::uint8_t*>(bytes.data())), end_(at_ + bytes.size()), begin_(at_) {}

    bool next(std::uint64_t& value) {
        const std::uint8_t* after = decode_leb128(at_, end_, value);
        if (after == nullptr) return false;
        at_ = after;
        return true;
    }
    std::size_t used() const { return static_cast<std::size_t>(at_ - begin_); }

private:
    const std::uint8_t* at_;
    const std::uint8_t* end_;
    const std::uint8_t* begin_;
};

/// Whether tick * period + offset stays a time.
bool fits(std::int64_t tick, std::uint64_t ticks_passed, std::int64_t period_ns, std::uint64_t offset_ns) {
    const std::int64_t last_tick = (std::numeric_limits<std::int64_t>::max() / 2) / period_ns;
    return ticks_passed <= static_cast<std::uint64_t>(last_tick - tick) &&
           offset_ns <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max() / 2);
}

}  // namespace

Result<std::unique_ptr<TraceReader>> BinaryReader::open(ByteSource source) {
    auto reader = open_binary(std::move(source));
    if (!reader) return reader.error();
    return std::unique_ptr<TraceReader>(std::move(reader).value());
}

Result<std::unique_ptr<BinaryReader>> BinaryReader::open_binary(ByteSource source) {
    std::unique_ptr<BinaryReader> reader(new BinaryReader(std::move(source)));
    auto header = reader->read_header();
    if (!header) return header.error();
    return reader;
}

std::unique_ptr<BinaryReader> BinaryReader::resume(ByteSource source, const TraceStart& start,
                                                   const Place& place) {
    std::unique_ptr<BinaryReader> reader(new BinaryReader(std::move(source)));
    reader->start_ = start;
    reader->tick_ = place.tick;
    reader->time_ns_ = place.time_ns;
    reader->levels_ = place.levels;
    return reader;
}

Result<void> BinaryReader::read_header() {
    auto wanted = source_.want(sizeof(TraceHeader));
    if (!wanted) return wanted;
    const std::string_view bytes = source_.unread();
    if (bytes.size() < sizeof(TraceHeader))
        return source_.bad_at(bytes.size(), "the trace is cut off inside its header");
    TraceHeader header;
    std::memcpy(&header, bytes.data(), sizeof header);
    if (header.magic != kTraceMagic) return source_.bad_at(0, "not a binary pin trace");
    if (header.version < kOldestTraceVersion || header.version > kCrossedTraceVersion)
        return source_.bad_at(offsetof(TraceHeader, version),
                              "trace version " + std::to_string(header.version) +
                                  "; this program reads version " + std::to_string(kOldestTraceVersion) +
                                  " to " + std::to_string(kCrossedTraceVersion));
    if (header.period_ns <= 0)
        return source_.bad_at(offsetof(TraceHeader, period_ns), "a tick period of no time");
    if ((header.initial_levels & ~kAllSignals) != 0)
        return source_.bad_at(offsetof(TraceHeader, initial_levels), "levels of signals that do not exist");
    if (!std::ranges::all_of(header.position_pulses, is_trace_position))
        return source_.bad_at(offsetof(TraceHeader, position_pulses), "a position beyond all bounds");
    start_.initial_levels = header.initial_levels;
    start_.present = kAllSignals;
    start_.has_positions = true;
    std::copy(std::begin(header.position_pulses), std::end(header.position_pulses),
              start_.position_pulses.begin());
    start_.period_ns = header.period_ns;
    start_.may_carry_jobs = header.version > kOldestTraceVersion;
    levels_ = header.initial_levels;
    source_.consume(sizeof(TraceHeader));
    return header.version >= kCrossedTraceVersion ? read_crossed() : Result<void>{};
}

Result<void> BinaryReader::read_crossed() {
    auto wanted = source_.want(sizeof(TraceCrossed));
    if (!wanted) return wanted;
    const std::string_view bytes = source_.unread();
    if (bytes.size() < sizeof(TraceCrossed))
        return source_.bad_at(bytes.size(), "the trace is cut off inside its header");
    TraceCrossed crossed;
    std::memcpy(&crossed, bytes.data(), sizeof crossed);
    if (!std::ranges::all_of(crossed.crossed_pulses, is_trace_gap))
        return source_.bad_at(0, "a gap crossed by less than nothing or beyond all bounds");
    std::copy(std::begin(crossed.crossed_pulses), std::end(crossed.crossed_pulses),
              start_.crossed_pulses.begin());
    source_.consume(sizeof(TraceCrossed));
    return {};
}

BinaryReader::Decoded BinaryReader::fail(const char* text) {
    garbage_ = text;
    return Decoded::garbage;
}

BinaryReader::Decoded BinaryReader::decode(TraceEvent& event) {
    const std::string_view bytes = source_.unread();
    // A number that does not end within the longest record is garbage, not a reason to wait for more.
    const auto incomplete = [&] {
        return bytes.size() >= kTraceRecordMaxBytes ? fail("a number that does not end")
                                                    : Decoded::incomplete;
    };
    NumberCursor cursor(bytes);
    std::uint64_t head = 0;
    if (!cursor.next(head)) return incomplete();
    const TraceRecordKind kind = trace_record_kind(head);
    std::uint64_t offset_ns = 0;
    if (kind == TraceRecordKind::pins_with_offset && !cursor.next(offset_ns)) return incomplete();
    if (!fits(tick_, trace_record_ticks(head), start_.period_ns, offset_ns))
        return fail("a time beyond all bounds");
    const std::int64_t tick = tick_ + static_cast<std::int64_t>(trace_record_ticks(head));
    const std::int64_t time_ns = tick * start_.period_ns + static_cast<std::int64_t>(offset_ns);

    SignalWord levels = levels_;
    if (kind == TraceRecordKind::position) {
        event.kind = TraceEvent::Kind::position;
        for (std::int64_t& position : event.position_pulses) {
            std::uint64_t zigzag = 0;
            if (!cursor.next(zigzag)) return incomplete();
            position = value_from_zigzag(zigzag);
            if (!is_trace_position(position)) return fail("a position beyond all bounds");
        }
    } else if (kind != TraceRecordKind::end) {
        std::uint64_t changed = 0;
        if (!cursor.next(changed)) return incomplete();
        if (changed == 0 || (changed & ~std::uint64_t{kAllSignals}) != 0) {
            const bool is_job = changed == 0 && kind == TraceRecordKind::pins && start_.may_carry_jobs;
            return is_job ? Decoded::job : fail("a change of no signal, or of one that does not exist");
        }
        event.kind = TraceEvent::Kind::pins;
        event.position_pulses = {};
        levels ^= static_cast<SignalWord>(changed);
    }
    if (time_ns < time_ns_) {
        // A position or the end stands on a whole tick, which an offset inside that tick may have passed.
        if (tick < tick_ || kind == TraceRecordKind::pins || kind == TraceRecordKind::pins_with_offset)
            return fail("time runs backwards");
    } else {
        time_ns_ = time_ns;
    }
    tick_ = tick;
    levels_ = levels;
    event.time_ns = time_ns_;
    event.levels = levels;
    source_.consume(cursor.used());
    return kind == TraceRecordKind::end ? Decoded::end : Decoded::event;
}

/// Reads the head of the record at the source's front; the job gets its blob. Returns the blob's length.
Result<std::uint64_t> BinaryReader::pass_job_head(Job& job) {
    for (;;) {
        const std::string_view bytes = source_.unread();
        NumberCursor cursor(bytes);
        std::uint64_t head = 0;
        std::uint64_t change = 0;
        std::uint64_t job_bytes = 0;
        const bool has_numbers = cursor.next(head) && cursor.next(change) && cursor.next(job_bytes);
        if (has_numbers && (job_bytes == 0 || job_bytes > kMostTraceJobBytes))
            return source_.bad_at(0, "a job of no bytes, or of more than any job has");
        if (has_numbers && bytes.size() >= cursor.used() + kTraceChecksumBytes) {
            // As a position: on a whole tick.
            tick_ += static_cast<std::int64_t>(trace_record_ticks(head));
            time_ns_ = std::max(time_ns_, tick_ * start_.period_ns);
            job.checksum =
                decode_trace_checksum(reinterpret_cast<const std::uint8_t*>(bytes.data() + cursor.used()));
            source_.consume(cursor.used() + kTraceChecksumBytes);
            return job_bytes;
        }
        if (bytes.size() >= kTraceRecordMaxBytes) return source_.bad_at(0, "a number that does not end");
        auto more = source_.refill();
        if (!more) return more.error();
        if (!*more)
            return source_.bad_at(bytes.size(), "the trace is cut off inside the job that it carries");
    }
}

Result<void> BinaryReader::pass_job(Job& job, bool keeps_blob) {
    const auto job_bytes = pass_job_head(job);
    if (!job_bytes) return job_bytes.error();
    // Allocates memory only for bytes that are there, whatever length the record claims.
    for (std::uint64_t left = *job_bytes; left > 0;) {
        const std::string_view bytes = source_.unread().substr(0, left);
        if (keeps_blob) {
            const auto* const first = reinterpret_cast<const std::byte*>(bytes.data());
            job.blob.insert(job.blob.end(), first, first + bytes.size());
        }
        source_.consume(bytes.size());
        left -= bytes.size();
        if (left == 0) break;
        auto more = source_.refill();
        if (!more) return more.error();
        if (!*more) return source_.bad_at(0, "the trace is cut off inside the job that it carries");
    }
    if (jobs_begun_ == 0 || job.checksum != job_checksum_) ++jobs_begun_;
    job_checksum_ = job.checksum;
    return {};
}

Result<std::optional<BinaryReader::Job>> BinaryReader::next_job(bool keeps_blob, WhenDamaged when_damaged) {
    while (!ended_) {
        TraceEvent event;
        const Decoded decoded = decode(event);
        if (decoded == Decoded::event) continue;
        if (decoded == Decoded::end) break;
        if (decoded == Decoded::garbage) return source_.bad_at(0, garbage_);
        if (decoded == Decoded::job) {
            Job job;
            if (const auto passed = pass_job(job, keeps_blob); !passed) return passed.error();
            if (keeps_blob && when_damaged == WhenDamaged::refuses && job_checksum(job.blob) != job.checksum)
                return bad_input(source_.name() + ": the job that it carries is damaged");
            return std::optional{std::move(job)};
        }
        auto more = source_.refill();
        if (!more) return more.error();
        if (!*more) return cut_off();
    }
    ended_ = true;
    return std::optional<Job>{};
}

Error BinaryReader::cut_off() const {
    return source_.bad_at(source_.unread().size(), "the trace is cut off: it ends without its end record");
}

Result<std::size_t> BinaryReader::check_nothing_follows() {
    while (source_.unread().empty()) {
        auto more = source_.refill();
        if (!more) return more.error();
        if (!*more) return std::size_t{0};
    }
    return source_.bad_at(0, "bytes after the trace's end record");
}

Result<std::size_t> BinaryReader::read(std::span<TraceEvent> events) {
    std::size_t count = 0;
    while (count < events.size() && !ended_) {
        const Decoded decoded = decode(events[count]);
        if (decoded == Decoded::event) {
            ++count;
        } else if (decoded == Decoded::end) {
            // The last event carries the time that the trace covers, so that silence is not mistaken for an
            // end.
            ended_ = true;
            events[count].kind = TraceEvent::Kind::pins;
            events[count].position_pulses = {};
            ++count;
        } else if (count > 0) {
            return count;  // the next call reports the fault
        } else if (decoded == Decoded::job) {
            Job job;
            if (const auto passed = pass_job(job, false); !passed) return passed.error();
        } else if (decoded == Decoded::garbage) {
            return source_.bad_at(0, garbage_);
        } else {
            auto more = source_.refill();
            if (!more) return more.error();
            if (!*more) return cut_off();
        }
    }
    if (count > 0 || !ended_) return count;
    return check_nothing_follows();
}

}  // namespace psicarve::verify
