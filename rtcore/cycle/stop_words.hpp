// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "rtcore/cycle/cycle_io.hpp"

namespace psicarve::cycle {

/// Of one kind of stop, how both words stood at the last one that was acted on. RT: yes.
class StopsTaken {
public:
    /// True when either word has changed.
    bool take(const std::atomic<std::uint32_t>& own_word,
              const std::atomic<std::uint64_t>& asked_word) noexcept {
        const std::uint32_t own = own_word.load(std::memory_order_acquire);
        const auto asked = static_cast<std::uint32_t>(asked_word.load(std::memory_order_acquire));
        const bool is_changed = own != own_ || asked != asked_;
        own_ = own;
        asked_ = asked;
        return is_changed;
    }
    /// How many were asked for, and acted on, since a sender saw the word so; negative: that many it saw are
    /// not acted on yet.
    std::int32_t since(std::uint32_t seen) const noexcept { return static_cast<std::int32_t>(asked_ - seen); }

private:
    std::uint32_t own_ = 0;
    std::uint32_t asked_ = 0;
};

/// Which stops and emergency stops are acted on, and which requests they overtake. RT: yes.
class StopWords {
public:
    /// True once for each change: a stop to act on.
    bool take_stop(const UrgentWords& words) noexcept {
        return stops_.take(words.stop_requests, words.stop_word);
    }
    bool take_emergency_stop(const UrgentWords& words) noexcept {
        return emergency_stops_.take(words.estop_requests, words.estop_word);
    }

    /// Its sender knew of a stop that is not acted on yet: that one comes first.
    bool comes_after_one_not_taken(const Request& request) const noexcept {
        return stops_.since(request.stops_seen) < 0 ||
               emergency_stops_.since(request.emergency_stops_seen) < 0;
    }
    /// A stop that its sender did not know of was acted on.
    bool have_overtaken(const Request& request) const noexcept {
        return stops_.since(request.stops_seen) > 0 ||
               emergency_stops_.since(request.emergency_stops_seen) > 0;
    }

private:
    StopsTaken stops_;
    StopsTaken emergency_stops_;
};

}  // namespace psicarve::cycle
