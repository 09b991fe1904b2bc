// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "shared/machine/status.hpp"

namespace psicarve::rtcore {

/// Bins of one microsecond besides the coarse ones; the last also holds all later ticks.
inline constexpr std::size_t kFineBins = 10'000;

struct PeriodicReport {
    std::uint64_t ticks_run = 0;
    std::uint64_t ticks_missed = 0;
    std::int64_t max_lateness_ns = 0;
    std::array<std::uint64_t, kLatenessBins> lateness_histogram{};  ///< bins as in CoreStatus
};

/// How late ticks were and how many were missed: written by the loop, read by any thread. RT: yes.
class PeriodicStats {
public:
    void note_tick(std::int64_t lateness_ns) noexcept {
        bump(ticks_run_, 1);
        bump(bins_[bin_of(lateness_ns)], 1);
        bump(fine_bins_[fine_bin_of(lateness_ns)], 1);
        if (lateness_ns > max_lateness_ns_.load(kRelaxed)) max_lateness_ns_.store(lateness_ns, kRelaxed);
    }
    void note_missed(std::uint64_t ticks) noexcept { bump(ticks_missed_, ticks); }
    PeriodicReport report() const noexcept {
        PeriodicReport report{.ticks_run = ticks_run_.load(kRelaxed),
                              .ticks_missed = ticks_missed_.load(kRelaxed),
                              .max_lateness_ns = max_lateness_ns_.load(kRelaxed)};
        for (std::size_t bin = 0; bin < kLatenessBins; ++bin) {
            report.lateness_histogram[bin] = bins_[bin].load(kRelaxed);
        }
        return report;
    }
    /// Ticks that were so many whole microseconds late. Requires late_us < kFineBins.
    std::uint64_t ticks_at_us(std::size_t late_us) const noexcept {
        return fine_bins_[late_us].load(kRelaxed);
    }
    static std::size_t fine_bin_of(std::int64_t lateness_ns) noexcept {
        constexpr std::int64_t kNsPerBin = 1000;
        if (lateness_ns < kNsPerBin) return 0;
        return std::min(static_cast<std::size_t>(lateness_ns / kNsPerBin), kFineBins - 1);
    }
    /// Bin n holds 2^n .. 2^(n+1) ns; bin 0 also ticks that came early, the last bin also all later ones.
    static std::size_t bin_of(std::int64_t lateness_ns) noexcept {
        if (lateness_ns < 2) return 0;
        const auto width = static_cast<std::size_t>(std::bit_width(static_cast<std::uint64_t>(lateness_ns)));
        return width - 1 < kLatenessBins ? width - 1 : kLatenessBins - 1;
    }

private:
    static constexpr auto kRelaxed = std::memory_order_relaxed;
    // One writer: a plain addition, made visible whole.
    static void bump(std::atomic<std::uint64_t>& counter, std::uint64_t by) noexcept {
        counter.store(counter.load(kRelaxed) + by, kRelaxed);
    }
    std::atomic<std::uint64_t> ticks_run_{0};
    std::atomic<std::uint64_t> ticks_missed_{0};
    std::atomic<std::int64_t> max_lateness_ns_{0};
    std::array<std::atomic<std::uint64_t>, kLatenessBins> bins_{};
    std::array<std::atomic<std::uint64_t>, kFineBins> fine_bins_{};
};

struct PeriodicTick {
    std::uint64_t tick;           ///< since the loop began; missed ticks are numbered too
    std::uint64_t missed_before;  ///< ticks skipped since the last one that ran
    std::int64_t lateness_ns;
    std::int64_t deadline_ns;  ///< on the loop's clock
};

struct PeriodicOptions {
    std::int64_t period_ns = 0;
};

/// Runs `step(PeriodicTick)` at absolute deadlines until it returns false.
///
///     deadline     |----0----|----1----|----2----|----3----|----4----|
///     runs at       0         1 . . . . . . late . >3       4            tick 2 is missed, counted, gone
///
/// Ticks are numbered by their deadline. A late tick runs late; when whole deadlines have passed only the
/// newest of them runs, the others are skipped and counted. Nothing is made up for: at most one step a
/// period. The port keeps the times between two edges on the pins (PulseTimes). RT: yes, as far as `clock`
/// and `step` are.
template <typename Clock, typename Step>
void run_periodic(Clock& clock, const PeriodicOptions& options, PeriodicStats& stats, Step&& step) noexcept {
    std::int64_t deadline_ns = clock.now_ns();
    std::uint64_t tick = 0;
    std::uint64_t missed = 0;
    for (;;) {
        clock.sleep_until_ns(deadline_ns);
        const std::int64_t lateness_ns = clock.now_ns() - deadline_ns;
        const std::int64_t skipped = lateness_ns > 0 ? lateness_ns / options.period_ns : 0;
        if (skipped > 0) stats.note_missed(static_cast<std::uint64_t>(skipped));
        missed += static_cast<std::uint64_t>(skipped);
        tick += static_cast<std::uint64_t>(skipped);
        deadline_ns += skipped * options.period_ns;
        stats.note_tick(lateness_ns);
        if (!step(PeriodicTick{.tick = tick,
                               .missed_before = missed,
                               .lateness_ns = lateness_ns,
                               .deadline_ns = deadline_ns})) {
            return;
        }
        missed = 0;
        ++tick;
        deadline_ns += options.period_ns;
    }
}

}  // namespace psicarve::rtcore
