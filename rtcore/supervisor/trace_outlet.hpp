// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "rtcore/trace/trace_entry.hpp"
#include "rtcore/trace/trace_writer.hpp"
#include "shared/result.hpp"

namespace psicarve::supervisor {

/// All traces of a run and the recording that goes on: empties the tick's ring into each. One thread's; may
/// block on a disk or pipe.
class TraceOutlet {
public:
    Result<void> open(const std::vector<std::string>& paths, const trace::TraceStart& start);
    bool is_open() const noexcept { return !writers_.empty(); }

    /// Takes the bytes of a recording; without bytes: it has ended.
    using RecordingTaker = std::function<void(std::uint32_t token, std::span<const std::uint8_t> bytes)>;
    /// Whoever carries recordings to the processes that asked for them; nothing: nobody does any more.
    void set_recording_taker(RecordingTaker taker);
    /// What goes on is not carried any further.
    void drop_recording() noexcept { const auto dropped = std::exchange(recording_, std::nullopt); }

    /// Everything the ring holds now.
    void drain(trace::TraceRing& ring);
    void flush();
    void finish(std::uint64_t end_tick);
    /// Writing failed since the last call: one line for each trace that did, the first time only.
    std::vector<std::string> take_errors();

private:
    struct Named {
        std::string path;
        std::unique_ptr<trace::TraceWriter> writer;
    };
    /// The trace that another process asked for; its tick 0 is the one in which it was asked for.
    struct Recording {
        std::uint32_t token;
        std::uint64_t first_tick;
        std::unique_ptr<trace::TraceWriter> writer;
    };
    void add(const trace::TraceEntry& entry);
    void begin_recording(const trace::TraceEntry& entry);
    void end_recording(std::uint64_t tick);

    std::vector<Named> writers_;
    std::int64_t period_ns_ = 0;
    RecordingTaker recording_taker_;
    std::optional<Recording> recording_;
};

}  // namespace psicarve::supervisor
