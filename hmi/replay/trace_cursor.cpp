// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/trace_cursor.hpp"

#include <utility>

namespace psicarve::replay {
namespace {

constexpr std::size_t kEventsOfAStep = 1024;

}  // namespace

TraceCursor::TraceCursor(std::shared_ptr<const TraceIndex> index)
    : index_(std::move(index)), follower_(index_->keyframes().front().follower), events_(kEventsOfAStep) {}

Result<void> TraceCursor::jump(const TraceIndex::Keyframe& keyframe) {
    auto reader = index_->read_from(keyframe);
    if (!reader) return reader.error();
    reader_ = std::move(reader).value();
    follower_ = keyframe.follower;
    position_ns_ = keyframe.place.time_ns;
    next_ = count_ = 0;
    is_at_end_ = false;
    return {};
}

/// False at the end of the readable part.
Result<bool> TraceCursor::refill() {
    if (is_at_end_) return false;
    const auto count = reader_->read(events_);
    // Where the index met damage, this reader meets it again: it was reported when the trace was opened.
    if (!count && index_->damage().empty()) return count.error();
    next_ = 0;
    count_ = count ? *count : 0;
    is_at_end_ = count_ == 0;
    return !is_at_end_;
}

template <typename Take>
Result<PinMoment> TraceCursor::run(std::int64_t time_ns, Take take) {
    while (true) {
        if (next_ == count_) {
            const auto more = refill();
            if (!more) return more.error();
            if (!*more) break;
        }
        if (events_[next_].time_ns > time_ns) break;
        take(events_[next_++]);
    }
    position_ns_ = time_ns;
    PinMoment moment = follower_.moment();
    moment.time_ns = time_ns;
    return moment;
}

Result<PinMoment> TraceCursor::at(std::int64_t time_ns) {
    const TraceIndex::Keyframe& keyframe = index_->keyframe_at(time_ns);
    const bool is_ahead = reader_ && position_ns_ <= time_ns && keyframe.place.time_ns <= position_ns_;
    if (!is_ahead) {
        if (const auto there = jump(keyframe); !there) return there.error();
    }
    return run(time_ns, [this](const verify::TraceEvent& event) { follower_.take(event); });
}

Result<PinMoment> TraceCursor::go_on(std::int64_t time_ns, const Visit& visit) {
    if (!reader_) {
        if (const auto there = at(position_ns_); !there) return there.error();
    }
    return run(time_ns, [&](const verify::TraceEvent& event) {
        const PinMoment before = follower_.moment();
        follower_.take(event);
        visit(before, follower_.moment());
    });
}

}  // namespace psicarve::replay
