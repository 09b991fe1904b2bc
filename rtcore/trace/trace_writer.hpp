// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "rtcore/trace/trace_entry.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::trace {

/// The state before the first entry.
struct TraceStart {
    std::int64_t period_ns = 0;
    SignalWord levels = 0;  ///< all signals at tick 0
    std::array<std::int64_t, kAxisCount> position_pulses{};
    /// Of each axis' gap, crossed downwards. Told only where some axis has.
    std::array<std::int64_t, kAxisCount> crossed_pulses{};

    bool has_crossed() const noexcept { return crossed_pulses != decltype(crossed_pulses){}; }
};

/// A job in memory that does not change.
struct TracedJob {
    std::shared_ptr<const void> owner;  ///< of the blob
    std::span<const std::byte> blob;
    std::uint64_t checksum;  ///< job_checksum() of it
    std::uint64_t generation = 0;
};

/// Writes what the pins do to a file or pipe. Used by one thread; not for the tick (it may block on the
/// disk). After the first failed write it writes nothing more and reports it once.
class TraceWriter {
public:
    TraceWriter() = default;
    TraceWriter(const TraceWriter&) = delete;
    TraceWriter& operator=(const TraceWriter&) = delete;
    virtual ~TraceWriter() = default;

    /// In the order in which things happened: ticks never go back, nor offsets within a tick.
    virtual void add(const TraceEntry& entry) noexcept = 0;
    /// From here on the pins carve this job. A form that has no place for it leaves it out.
    virtual void add_job(const TracedJob& job) noexcept = 0;
    /// Hands what has gathered to the operating system, so that a reader of a live trace sees it.
    virtual void flush() noexcept = 0;
    /// Completes the trace, which covers all ticks before `end_tick`. Without it a trace reads as cut off.
    virtual void finish(std::uint64_t end_tick) noexcept = 0;
    /// A count of the bytes that the operating system has taken, for any thread to read; outlives this.
    using WrittenBytes = std::shared_ptr<const std::atomic<std::uint64_t>>;
    virtual WrittenBytes written_bytes() const noexcept = 0;
    /// The first failed write, once; else nothing.
    virtual std::optional<Error> take_error() = 0;
};

/// `path` is a file (`.vcd` makes a value-change dump, anything else the compact binary form), "-" for
/// standard output or "fd:N" for a descriptor that is already open and becomes ours (both binary). An
/// existing file is overwritten; a symbolic link is refused.
Result<std::unique_ptr<TraceWriter>> open_trace(const std::string& path, const TraceStart& start);

}  // namespace psicarve::trace
