// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "shared/machine/status.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// One bar of the lateness histogram.
struct LatenessBar {
    std::string label;  ///< "≤ 2 µs": no tick of the bar was later
    std::uint64_t ticks = 0;
    double height = 0.0;  ///< 0 to 1, by the logarithm of the ticks: one late tick in millions stays visible
};

/// How punctual the core's ticks have been since it started. Percentiles are upper edges of histogram bins.
struct TickHealth {
    std::uint64_t ticks = 0;
    std::uint64_t missed = 0;
    std::int64_t period_ns = 0;
    std::int64_t median_ns = 0;
    std::int64_t p99_ns = 0;
    std::int64_t p999_ns = 0;
    std::int64_t greatest_ns = 0;
    std::vector<LatenessBar> bars;  ///< up to the greatest that holds a tick, at least as far as the period
    std::size_t period_bar = 0;     ///< the first whose ticks may have been a whole period late
};
TickHealth tick_health(const CoreStatus& status);
/// The lateness that 99 % of the ticks do not exceed, as above; 0 before the first tick.
std::int64_t late_p99_ns(const CoreStatus& status);

/// "850 ns", "61 µs", "1.2 ms".
std::string duration_text(std::int64_t duration_ns);

/// Ticks missed per second, over the last five: the count that the alarm of missed ticks uses, at rest, too.
class MissedMeter {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds kLength{5};

    /// Call it at screen rate. The most that were missed in any second of the last five. A count that has
    /// gone down is another core's.
    std::uint64_t note(std::uint64_t missed_ticks, Clock::time_point now);
    void forget() noexcept { samples_.clear(); }

private:
    struct Sample {
        Clock::time_point time;
        std::uint64_t missed;
    };
    std::uint64_t missed_in_second_before(std::size_t last) const;

    std::deque<Sample> samples_;  ///< by time
};

class RateMeter;
/// Speed of the faster head's tool over the surface: sqrt((r ψ')² + r'²), from the last second's mean speeds.
/// [mm/s]
double surface_speed_mm_s(const RateMeter& rates, const CoreStatus& status, const Profile& profile);

/// Speeds of the status' counts, over about the last second.
class RateMeter {
public:
    using Clock = std::chrono::steady_clock;

    /// Call it at screen rate. A count that has gone down begins anew: another core, or another job.
    void note(const CoreStatus& status, Clock::time_point now);
    void forget() noexcept { samples_.clear(); }

    double ticks_per_s() const noexcept { return ticks_per_s_; }
    double pulses_per_s(Axis axis) const noexcept { return pulses_per_s_[index_of(axis)]; }
    /// By the machine's clock, which differs from the wall's if it is virtual.
    double pulses_per_machine_s(Axis axis) const noexcept { return pulses_per_machine_s_[index_of(axis)]; }
    /// Ticks missed in the last second.
    std::uint64_t missed_lately() const noexcept { return missed_lately_; }

private:
    struct Sample {
        Clock::time_point time;
        std::uint64_t tick;
        std::uint64_t missed;
        std::int64_t period_ns;
        std::array<std::uint64_t, kAxisCount> pulses;
    };
    void measure();

    std::deque<Sample> samples_;
    double ticks_per_s_ = 0.0;
    std::uint64_t missed_lately_ = 0;
    std::array<double, kAxisCount> pulses_per_s_{};
    std::array<double, kAxisCount> pulses_per_machine_s_{};
};

}  // namespace psicarve::session
