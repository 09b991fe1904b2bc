// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve::cycle {

/// The tick at hand and its time since the core started. Ticks that did not come are counted and never made
/// up for. RT: yes.
class TickClock {
public:
    explicit TickClock(std::int64_t period_ns) noexcept : period_ns_(period_ns) {}

    std::uint64_t tick() const noexcept { return tick_; }
    std::int64_t time_ns() const noexcept { return time_ns_; }

    void advance(std::int64_t ticks) noexcept {
        tick_ += static_cast<std::uint64_t>(ticks);
        time_ns_ += ticks * period_ns_;
    }
    struct Instant {
        std::uint64_t tick;
        std::int64_t time_ns;
    };
    /// So many ticks ago. Requires that there were as many.
    Instant before(std::int64_t ticks) const noexcept {
        return {tick_ - static_cast<std::uint64_t>(ticks), time_ns_ - ticks * period_ns_};
    }

    /// So many ticks, or steps of the interpolation, did not come. Time passes by advance() alone.
    void count_missed(std::uint64_t count) noexcept { missed_ += count; }
    std::uint64_t missed() const noexcept { return missed_; }

private:
    std::int64_t period_ns_;
    std::uint64_t tick_ = 0;
    std::int64_t time_ns_ = 0;
    std::uint64_t missed_ = 0;
};

}  // namespace psicarve::cycle
