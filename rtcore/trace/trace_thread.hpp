// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>

#include "rtcore/trace/trace_entry.hpp"
#include "rtcore/trace/trace_writer.hpp"
#include "shared/computer/event.hpp"

namespace psicarve::trace {

/// One trace, written by a low-priority thread of its own: when a disk or a pipe's reader stands still, or
/// the computer is busy, only this trace waits; it has no mutex to hold. One thread calls all methods: the
/// one that hands over entries.
///
///     tick ── TraceRing ──> supervisor ── TraceRing of each trace ──> its thread ── write() ──> file, pipe
///                                         full: room() says so
class TraceThread {
public:
    explicit TraceThread(std::unique_ptr<TraceWriter> writer);
    /// Without finish() the trace is left without its end. Waits briefly at most: a thread that hangs is left
    /// to the end of the process.
    ~TraceThread();
    TraceThread(const TraceThread&) = delete;
    TraceThread& operator=(const TraceThread&) = delete;

    std::size_t room() const noexcept { return TraceRing::capacity() - shared_->ring.size(); }
    /// False when there is no room. The entry may stay unwritten until wake().
    bool put(const TraceEntry& entry) noexcept { return shared_->ring.push(entry); }
    /// True while few enough jobs wait to be written.
    bool takes_job() const noexcept { return !shared_->jobs[next_job_place_].is_full.load(); }
    /// False when there is no room, or not takes_job(). As put().
    bool put_job(const TracedJob& job) noexcept;
    void wake();
    /// Hands what has gathered to the operating system, too, once all is written.
    void flush();

    /// Ends the trace; one that is not whole is left without its end record. Then wait, as often as needed.
    void finish(std::uint64_t end_tick, bool is_whole);
    bool wait_until_finished(std::chrono::milliseconds limit);
    /// Entries not written yet.
    std::size_t left() const noexcept { return shared_->ring.size(); }
    /// Bytes written that the operating system has taken.
    std::uint64_t written_bytes() const noexcept { return written_bytes_->load(std::memory_order_relaxed); }

    /// The first failed write, once.
    std::optional<Error> take_error();

private:
    /// The jobs among the ring's entries. Each place belongs to the writer while it is full.
    struct JobPlace {
        TracedJob job{};  ///< written before is_full
        std::atomic<bool> is_full{false};
    };
    static constexpr std::size_t kJobPlaces = 4;
    struct Shared {
        std::array<JobPlace, kJobPlaces> jobs;
        TraceRing ring;
        std::unique_ptr<TraceWriter> writer;  ///< used by the thread alone
        EventWord told;                       ///< signals each of the following four
        std::atomic<bool> must_flush{false};
        std::atomic<bool> must_finish{false};
        std::atomic<bool> must_drop{false};
        std::uint64_t end_tick = 0;  ///< as is_whole, written before must_finish
        bool is_whole = true;
        std::optional<Error> error;  ///< the first one, written before has_error
        std::atomic<bool> has_error{false};
        std::atomic<bool> has_finished{false};
        EventWord finished;
    };
    static void run(Shared& shared);
    static void write(Shared& shared, const TraceEntry& entry);
    static void note_error(Shared& shared);

    std::shared_ptr<Shared> shared_;
    TraceWriter::WrittenBytes written_bytes_;
    std::uint32_t next_job_place_ = 0;
    bool is_error_taken_ = false;
    std::thread thread_;
};

}  // namespace psicarve::trace
