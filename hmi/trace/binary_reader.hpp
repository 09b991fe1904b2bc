// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hmi/trace/byte_source.hpp"
#include "hmi/trace/trace_reader.hpp"
#include "shared/base/result.hpp"

namespace psicarve::verify {

/// Reads the compact binary trace of shared/trace/trace_format.hpp.
class BinaryReader final : public TraceReader {
public:
    /// A place between two records: all that a reader needs to continue from there.
    struct Place {
        std::uint64_t offset = 0;  ///< in the file
        std::int64_t tick = 0;
        std::int64_t time_ns = 0;
        SignalWord levels = 0;
    };

    /// Waits for the header and checks it.
    static Result<std::unique_ptr<TraceReader>> open(ByteSource source);
    /// The same, for callers that come back to a place.
    static Result<std::unique_ptr<BinaryReader>> open_binary(ByteSource source);
    /// Continues from a place of the same file; the source stands there.
    static std::unique_ptr<BinaryReader> resume(ByteSource source, const TraceStart& start,
                                                const Place& place);

    /// The place behind the events that were returned.
    Place place() const noexcept { return {source_.offset(), tick_, time_ns_, levels_}; }

    const TraceStart& start() const noexcept override { return start_; }
    const std::string& name() const noexcept override { return source_.name(); }
    Result<std::size_t> read(std::span<TraceEvent> events) override;
    std::size_t jobs_begun() const noexcept override { return jobs_begun_; }

    /// A job that the trace carries.
    struct Job {
        std::uint64_t checksum = 0;
        std::vector<std::byte> blob;  ///< as the trace holds it: only its checksum was compared
    };
    /// Skips events up to the next job; nothing: the trace ends without one. bad_input when the job is
    /// damaged; else as read(). `keeps_blob` false: skips the blob without checking it.
    enum class WhenDamaged : std::uint8_t { refuses, returns };
    Result<std::optional<Job>> next_job(bool keeps_blob, WhenDamaged when_damaged = WhenDamaged::refuses);

private:
    enum class Decoded { event, incomplete, end, garbage, job };

    explicit BinaryReader(ByteSource source) : source_(std::move(source)) {}
    Result<void> read_header();
    Result<void> read_crossed();
    Decoded decode(TraceEvent& event);
    Decoded fail(const char* text);
    Result<void> pass_job(Job& job, bool keeps_blob);
    Result<std::uint64_t> pass_job_head(Job& job);
    Result<std::size_t> check_nothing_follows();
    Error cut_off() const;

    ByteSource source_;
    TraceStart start_;
    std::int64_t tick_ = 0;
    std::int64_t time_ns_ = 0;
    SignalWord levels_ = 0;
    std::size_t jobs_begun_ = 0;
    std::uint64_t job_checksum_ = 0;  ///< of the last job
    bool ended_ = false;
    const char* garbage_ = nullptr;  ///< the fault of the record at the source's front
};

}  // namespace psicarve::verify
