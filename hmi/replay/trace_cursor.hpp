// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "hmi/replay/trace_index.hpp"

namespace psicarve::replay {

/// A movable place in a trace. One thread; any number of cursors on one index.
class TraceCursor {
public:
    explicit TraceCursor(std::shared_ptr<const TraceIndex> index);

    /// The pins after everything up to and with `time_ns`; the moment's own time is `time_ns`.
    Result<PinMoment> at(std::int64_t time_ns);

    /// Called with the moments before and after each event.
    using Visit = std::function<void(const PinMoment& before, const PinMoment& after)>;
    /// The same, forwards from the present place, event by event. Requires position_ns() <= time_ns.
    Result<PinMoment> go_on(std::int64_t time_ns, const Visit& visit);
    std::int64_t position_ns() const noexcept { return position_ns_; }

private:
    Result<void> jump(const TraceIndex::Keyframe& keyframe);
    Result<bool> refill();
    template <typename Take>
    Result<PinMoment> run(std::int64_t time_ns, Take take);

    std::shared_ptr<const TraceIndex> index_;
    std::unique_ptr<verify::BinaryReader> reader_;
    PinFollower follower_;
    std::int64_t position_ns_ = 0;
    std::vector<verify::TraceEvent> events_;  ///< read ahead
    std::size_t next_ = 0;
    std::size_t count_ = 0;
    bool is_at_end_ = false;
};

}  // namespace psicarve::replay
