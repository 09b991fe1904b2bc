// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/tick_health.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "hmi/session/display_text.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

constexpr std::chrono::milliseconds kWindow{1000};
// Over less than this a rate is mostly chance.
constexpr std::chrono::milliseconds kLeastWindow{200};

std::int64_t upper_edge_ns(std::size_t bin) {
    return std::int64_t{2} << bin;
}

std::int64_t percentile_ns(const CoreStatus& status, std::uint64_t total, double share) {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(total)));
    std::uint64_t seen = 0;
    for (std::size_t bin = 0; bin < kLatenessBins; ++bin) {
        seen += status.lateness_histogram[bin];
        if (seen >= wanted && seen > 0)
            return std::min(upper_edge_ns(bin), std::max<std::int64_t>(status.max_lateness_ns, 0));
    }
    return 0;
}

}  // namespace

std::string duration_text(std::int64_t duration_ns) {
    constexpr double kNsPerUs = 1e3;
    constexpr double kNsPerMs = 1e6;
    const auto ns = static_cast<double>(duration_ns);
    if (ns < kNsPerUs) return number_text(ns, 0) + " ns";
    if (ns < kNsPerMs) return number_text(ns / kNsPerUs, ns < 10 * kNsPerUs ? 1 : 0) + " \u00B5s";
    return number_text(ns / kNsPerMs, ns < 10 * kNsPerMs ? 1 : 0) + " ms";
}

TickHealth tick_health(const CoreStatus& status) {
    TickHealth health;
    health.missed = status.missed_ticks;
    health.period_ns = status.period_ns;
    health.greatest_ns = status.max_lateness_ns;
    std::uint64_t most = 0;
    std::size_t last = 0;
    for (std::size_t bin = 0; bin < kLatenessBins; ++bin) {
        const std::uint64_t ticks = status.lateness_histogram[bin];
        health.ticks += ticks;
        most = std::max(most, ticks);
        if (ticks > 0) last = bin;
    }
    health.median_ns = percentile_ns(status, health.ticks, 0.5);
    health.p99_ns = percentile_ns(status, health.ticks, 0.99);
    health.p999_ns = percentile_ns(status, health.ticks, 0.999);
    const auto period = static_cast<std::uint64_t>(std::max<std::int64_t>(status.period_ns, 1));
    health.period_bar = static_cast<std::size_t>(std::bit_width(period)) - 1;
    const double scale = std::log1p(static_cast<double>(most));
    for (std::size_t bin = 0; bin <= std::min(std::max(last, health.period_bar), kLatenessBins - 1); ++bin) {
        const std::uint64_t ticks = status.lateness_histogram[bin];
        const double height = ticks > 0 ? std::log1p(static_cast<double>(ticks)) / scale : 0.0;
        health.bars.push_back({"\u2264 " + duration_text(upper_edge_ns(bin)), ticks, height});
    }
    return health;
}

std::int64_t late_p99_ns(const CoreStatus& status) {
    std::uint64_t ticks = 0;
    for (const std::uint64_t in_bin : status.lateness_histogram) ticks += in_bin;
    return percentile_ns(status, ticks, 0.99);
}

std::uint64_t MissedMeter::note(std::uint64_t missed_ticks, Clock::time_point now) {
    if (!samples_.empty() && missed_ticks < samples_.back().missed) samples_.clear();
    samples_.push_back({now, missed_ticks});
    while (samples_.size() > 2 && now - samples_[1].time >= kLength) samples_.pop_front();
    std::uint64_t most = 0;
    for (std::size_t last = 1; last < samples_.size(); ++last)
        most = std::max(most, missed_in_second_before(last));
    return most;
}

std::uint64_t MissedMeter::missed_in_second_before(std::size_t last) const {
    constexpr std::chrono::seconds kSecond{1};
    const Sample& end = samples_[last];
    const auto step = end.time - samples_[last - 1].time;
    // After a longer pause: spreads the missed ticks evenly over its seconds.
    if (step > kSecond) {
        const auto missed = static_cast<double>(end.missed - samples_[last - 1].missed);
        return static_cast<std::uint64_t>(missed / std::chrono::duration<double>(step).count());
    }
    std::size_t first = last - 1;
    while (first > 0 && end.time - samples_[first - 1].time <= kSecond) --first;
    return end.missed - samples_[first].missed;
}

void RateMeter::note(const CoreStatus& status, Clock::time_point now) {
    Sample sample{now, status.tick, status.missed_ticks, status.period_ns, {}};
    bool goes_on = !samples_.empty() && status.tick >= samples_.back().tick &&
                   status.missed_ticks >= samples_.back().missed;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        sample.pulses[k] = status.emitted_pulses[k];
        goes_on = goes_on && sample.pulses[k] >= samples_.back().pulses[k];
    }
    if (!goes_on) samples_.clear();
    samples_.push_back(sample);
    while (samples_.size() > 2 && now - samples_[1].time >= kWindow) samples_.pop_front();
    measure();
}

void RateMeter::measure() {
    const Sample& first = samples_.front();
    const Sample& last = samples_.back();
    const double seconds = std::chrono::duration<double>(last.time - first.time).count();
    const bool is_known = last.time - first.time >= kLeastWindow;
    const auto rate = [&](std::uint64_t from, std::uint64_t to) {
        return is_known ? static_cast<double>(to - from) / seconds : 0.0;
    };
    ticks_per_s_ = rate(first.tick, last.tick);
    missed_lately_ = last.missed - first.missed;
    constexpr double kNsPerSecond = 1e9;
    const double machine_s =
        static_cast<double>(last.tick - first.tick) * static_cast<double>(last.period_ns) / kNsPerSecond;
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        pulses_per_s_[k] = rate(first.pulses[k], last.pulses[k]);
        const auto pulses = static_cast<double>(last.pulses[k] - first.pulses[k]);
        pulses_per_machine_s_[k] = is_known && machine_s > 0.0 ? pulses / machine_s : 0.0;
    }
}

double surface_speed_mm_s(const RateMeter& rates, const CoreStatus& status, const Profile& profile) {
    const auto speed_of = [&](Axis axis) {
        return rates.pulses_per_machine_s(axis) / axis_motion(profile, axis).pulses_per_unit;
    };
    const double turn_rad_s = rad_from_deg(speed_of(Axis::psi));
    double fastest_mm_s = 0.0;
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const double radius_mm = mm_from_pulses(status.position_pulses[index_of(head)],
                                                axis_motion(profile, head).pulses_per_unit);
        fastest_mm_s = std::max(fastest_mm_s, std::hypot(radius_mm * turn_rad_s, speed_of(head)));
    }
    return fastest_mm_s;
}

}  // namespace psicarve::session
