// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "rtcore/cycle/fine_dda.hpp"
#include "rtcore/cycle/linear_profile.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// A straight move of all axes from rest to rest: a coarse interpolator with linear acceleration along the
/// long axis, once every kCoarseTicks ticks, and the fine interpolator that makes its increments pulses. For
/// all that is not a table: approach, links, homing, retraction. RT: yes.
class FineMove {
public:
    /// So short that slowing down, which begins with a period, begins soon after it was asked for.
    static constexpr std::int64_t kCoarseTicks = 4;

    /// Speeds of the long axis in pulses per tick, as LinearProfile's. Requires |delta| < 2^42.
    void start(const std::array<std::int64_t, kAxisCount>& delta_pulses, double start_speed, double max_speed,
               double accel) noexcept {
        constexpr auto kTicks = static_cast<double>(kCoarseTicks);
        std::int64_t longest_pulses = 0;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            left_pulses_[k] = delta_pulses[k] < 0 ? -delta_pulses[k] : delta_pulses[k];
            way_pulses_[k] = left_pulses_[k];
            longest_pulses = std::max(longest_pulses, left_pulses_[k]);
        }
        reached_.fill(0);
        longest_ = static_cast<double>(longest_pulses);
        profile_.start(start_speed * kTicks, max_speed * kTicks, accel * kTicks * kTicks,
                       static_cast<std::uint64_t>(longest_pulses));
        fine_.start(kCoarseTicks);
        period_ticks_left_ = 0;
    }

    bool is_finished() const noexcept { return left_pulses_ == std::array<std::int64_t, kAxisCount>{}; }
    bool is_slowest() const noexcept { return profile_.is_slowest(); }
    void rest() noexcept { profile_.rest(); }
    /// The planned top speed times this, at most 1, from the next period on.
    void set_ratio(double ratio) noexcept { profile_.set_ratio(ratio); }

    /// The axes with a pulse due, bit by axis; time stands still until they are taken.
    std::uint32_t due() const noexcept { return fine_.due(); }
    void take(std::size_t axis) noexcept {
        fine_.take(axis);
        --left_pulses_[axis];
    }

    /// One tick passes. Requires that no pulse is due.
    void tick(bool must_slow) noexcept {
        if (period_ticks_left_ == 0) begin_period(must_slow);
        --period_ticks_left_;
        fine_.tick();
    }

private:
    void begin_period(bool must_slow) noexcept {
        period_ticks_left_ = kCoarseTicks;
        if (profile_.iterations_left() > 0) profile_.advance(must_slow);
        while (profile_.is_due() && profile_.iterations_left() > 0) profile_.take();
        const double left =
            std::max(0.0, static_cast<double>(profile_.iterations_left()) - profile_.distance());
        const double share_left = profile_.iterations_left() > 0 ? left / longest_ : 0.0;
        FineDda::Units4 increments;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const std::int64_t way = way_pulses_[k] * FineDda::kUnitsPerPulse;
            const std::int64_t target =
                std::max(reached_[k], way - static_cast<std::int64_t>(static_cast<double>(way) * share_left));
            increments[k] = target - reached_[k];
            reached_[k] = target;
        }
        fine_.set_increments(increments, kCoarseTicks);
    }

    LinearProfile profile_;
    FineDda fine_;
    std::array<std::int64_t, kAxisCount> way_pulses_{};
    std::array<std::int64_t, kAxisCount> left_pulses_{};  ///< not emitted yet
    FineDda::Units4 reached_{};                           ///< what the coarse interpolator has given out
    double longest_ = 0.0;                                ///< the long axis' pulses
    std::int64_t period_ticks_left_ = 0;
};

}  // namespace psicarve::cycle
