// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "rtcore/trace/trace_entry.hpp"
#include "rtcore/trace/trace_thread.hpp"
#include "rtcore/trace/trace_writer.hpp"
#include "shared/base/result.hpp"

namespace psicarve::supervisor {

/// Feeds all traces of a run and the current recording: empties the tick's ring into each. Never waits for a
/// disk or a reader: each trace has a thread of its own. Used by one thread.
class TraceOutlet {
public:
    /// What happens to a pin change that a trace has no room for, because its reader is slower than the
    /// machine.
    enum class WhenFull : std::uint8_t {
        loses,  ///< it is counted and reported
        waits,  ///< it stays in the tick's ring: the ring's owner must stop the virtual clock
    };
    explicit TraceOutlet(WhenFull when_full = WhenFull::waits) : when_full_(when_full) {}

    Result<void> open(const std::vector<std::string>& paths, const trace::TraceStart& start);
    bool is_open() const noexcept { return !files_.empty(); }

    /// The job that goes to the traces when the next one begins. A job that a trace carries already is not
    /// written twice in a row.
    void set_job(trace::TracedJob job) { job_ = std::move(job); }

    /// Takes the bytes of a recording; without bytes: it has ended.
    using RecordingTaker = std::function<void(std::uint32_t token, std::span<const std::uint8_t> bytes)>;
    /// The function that brings recordings to the processes that asked for them; nothing: no recording is
    /// carried any more.
    void set_recording_taker(RecordingTaker taker);
    /// Ends the current recording.
    void drop_recording() noexcept { const auto dropped = std::exchange(recording_, std::nullopt); }

    /// Takes all entries from the ring; with `waits`: as many as there is room for.
    void drain(trace::TraceRing& ring);
    void flush();
    /// Ends the traces; `lost_before`: pin changes lost on the way here. Then call wait_until_finished().
    void finish(std::uint64_t end_tick, std::uint64_t lost_before = 0);
    /// Waits for all traces; asks again and again whether the limit has passed.
    bool wait_until_finished(std::chrono::milliseconds limit);
    /// Entries not written yet: shrinks as long as the readers take what is written.
    std::size_t left() const noexcept;
    std::uint64_t written_bytes() const noexcept;
    /// Gives up the traces that have not finished.
    void give_up();

    /// Pin changes that some trace had no room for.
    std::uint64_t lost() const noexcept { return lost_; }
    /// A line for each trace that could not be written or lost something, the first time only, and the sum of
    /// what is missing at the end.
    std::vector<std::string> take_errors();

private:
    struct File {
        std::string path;
        std::unique_ptr<trace::TraceThread> thread;
        std::uint64_t lost = 0;
        std::optional<std::uint64_t> carried_checksum{};  ///< of the last job in it
    };
    /// The trace that another process asked for; its tick 0 is the tick of the request.
    struct Recording {
        std::uint32_t token;
        std::uint64_t first_tick;
        std::unique_ptr<trace::TraceWriter> writer;
    };
    bool has_room() const noexcept;
    void add(const trace::TraceEntry& entry);
    void add_job(std::uint32_t generation);
    void lose(File& file, const trace::TraceEntry& entry);
    void begin_recording(const trace::TraceEntry& entry);
    void end_recording(std::uint64_t tick);

    WhenFull when_full_;
    std::vector<File> files_;
    std::vector<std::string> errors_;
    std::optional<trace::TracedJob> job_;  ///< goes to the traces when its kind job entry comes
    std::uint64_t lost_ = 0;
    bool has_unflushed_ = true;  ///< at first the traces' heads
    std::int64_t period_ns_ = 0;
    RecordingTaker recording_taker_;
    std::optional<Recording> recording_;
};

}  // namespace psicarve::supervisor
