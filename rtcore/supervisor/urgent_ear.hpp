// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

#include "rtcore/cycle/cycle_io.hpp"
#include "shared/segment.hpp"

namespace psicarve::supervisor {

/// Hands a segment's stops and emergency stops on to the tick: each change of a word once, whoever looks.
class UrgentEar {
public:
    /// How the words stood when they were looked at last.
    struct Seen {
        std::uint32_t stops = 0;
        std::uint32_t emergency_stops = 0;
    };
    static Seen as_they_stand(const Segment& segment) noexcept;

    UrgentEar(std::shared_ptr<Segment> segment, cycle::UrgentWords& urgent, Seen seen) noexcept;
    /// Ends listening; takes a few milliseconds.
    ~UrgentEar();
    UrgentEar(const UrgentEar&) = delete;
    UrgentEar& operator=(const UrgentEar&) = delete;

    /// True when something was handed on. Any thread's; not for the tick.
    bool look() noexcept;
    /// Looks from now on in a thread of its own, too, which runs before everything ordinary and after every
    /// tick (promptness.hpp): whoever takes commands hears a stop sooner as long as nothing keeps it, but
    /// however many commands wait, and whatever keeps their reader, a stop waits for neither. It looks every
    /// 2 ms, in a crowd every 0.04 ms. It waits for no event: two threads woken by the same one are both
    /// later for it. Once.
    void listen();
    /// Several commands came at one time: for a while a stop may have to pass many. Any thread's.
    void note_crowd() noexcept;
    bool is_listening() const noexcept { return thread_.joinable(); }

private:
    void run() noexcept;

    std::shared_ptr<Segment> segment_;
    cycle::UrgentWords* urgent_;
    std::atomic<std::uint32_t> stops_seen_;
    std::atomic<std::uint32_t> emergency_stops_seen_;
    std::atomic<std::int64_t> crowded_until_ns_{0};  ///< RealClock
    std::atomic<bool> must_end_{false};
    std::thread thread_;
};

}  // namespace psicarve::supervisor
