// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <memory>

#include "hmi/replay/trace_cursor.hpp"
#include "hmi/session/level_history.hpp"

namespace psicarve::replay {

/// The last seconds before an instant of a trace, for the timing diagram: a sample every few milliseconds,
/// and one at each change that is not a step. A small move forward reads only the new part. One thread.
class PinLooks {
public:
    using Looks = std::deque<session::LevelHistory::Look>;

    explicit PinLooks(std::shared_ptr<const TraceIndex> index) : cursor_(std::move(index)) {}

    /// Times are the trace's own, as time points of a clock that began with it.
    Result<Looks> until(std::int64_t time_ns);

    static session::LevelHistory::Clock::time_point time_point(std::int64_t time_ns) {
        return session::LevelHistory::Clock::time_point{std::chrono::nanoseconds{time_ns}};
    }

private:
    Result<void> begin_at(std::int64_t time_ns);
    void look(std::int64_t time_ns, const PinMoment& moment);

    TraceCursor cursor_;
    Looks looks_;
    PinMoment last_;
    std::int64_t next_look_ns_ = 0;
    bool has_begun_ = false;
};

}  // namespace psicarve::replay
