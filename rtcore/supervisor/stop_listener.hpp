// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::supervisor {

/// Mirrors a segment's words of stop and emergency stop into those that the tick looks at. But for the thread
/// that it has of its own, one thread's: the one that takes the segment's commands.
class StopListener {
public:
    /// What has been asked for so far was asked of an earlier core. `urgent` outlives the listener, and its
    /// words of stop are written by it alone.
    StopListener(std::shared_ptr<Segment> segment, cycle::UrgentWords& urgent) noexcept;
    /// Ends listening; takes a few milliseconds.
    ~StopListener();
    StopListener(const StopListener&) = delete;
    StopListener& operator=(const StopListener&) = delete;

    /// True when something was handed on. Not for the tick.
    bool look() noexcept;
    /// Looks from now on in a thread of its own, too, which runs before everything ordinary and after every
    /// tick (promptness.hpp): the thread that takes commands hears a stop sooner as long as nothing keeps it,
    /// but however many commands wait, and whatever keeps their reader, a stop waits for neither. It looks
    /// every 2 ms, in a crowd every 0.04 ms. It waits for no event: two threads woken by the same one are
    /// both later for it. Once.
    void listen();
    /// Several commands came at one time: for a while a stop may have to pass many.
    void note_crowd() noexcept;
    /// Another segment, whose words began at 0: whatever has been asked for in it was asked of us. To the
    /// tick its words go on where those of the old one ended.
    void turn_to(std::shared_ptr<Segment> segment) noexcept;
    /// Into a request what its sender had seen, as the tick counts it; and looks: the tick finds a stop that
    /// the sender had seen once it finds the request.
    void note_stops_seen(const ReceivedCommand& command, cycle::Request& request) noexcept;

private:
    /// A segment, and what turns its words into the tick's.
    struct Source {
        std::shared_ptr<Segment> segment;
        std::uint32_t number = 0;  ///< which segment it is: the high half of the mirrored words
        StopsSeen added;
    };
    static bool look_at(const Source& source, cycle::UrgentWords& urgent) noexcept;
    void run(Source source) noexcept;

    cycle::UrgentWords* urgent_;
    Source source_;
    std::atomic<std::int64_t> crowded_until_ns_{0};  ///< RealClock
    std::atomic<bool> must_end_{false};
    std::mutex next_mutex_;                      ///< the own thread never waits for it
    Source next_;                                ///< for the own thread
    std::atomic<std::uint32_t> next_number_{0};  ///< of next_
    std::thread thread_;
};

}  // namespace psicarve::supervisor
