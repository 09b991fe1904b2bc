// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// The fine interpolator: spreads coarse increments of all axes evenly over ticks.
///
///     once a coarse period of n ticks:  I_k = dL_k / (n * delta_k)     (whole units of 1/2^20 pulse)
///     every tick:                       acc_k += I_k;  acc_k >= 1 pulse: a pulse is due
///
/// What the division leaves is carried into the next period, so nothing is lost or rounded away. acc_k starts
/// empty but for what a last carry could hold back, so that after increments that add up to N pulses, N
/// pulses have become due, and moves of one axis that follow each other keep their distance. Whole numbers
/// only. Source: digital integration, docs/interpolation.md. RT: yes.
class FineDda {
public:
    static constexpr std::int64_t kUnitsPerPulse = std::int64_t{1} << 20;
    using Units4 = std::array<std::int64_t, kAxisCount>;

    /// `most_ticks`: of any period to come.
    void start(std::int64_t most_ticks) noexcept {
        accumulator_.fill(most_ticks);
        carry_.fill(0);
        integrand_.fill(0);
    }

    /// A coarse period begins. Increments [1/2^20 pulse] are at least 0: direction is not this class'
    /// business. Requires ticks > 0.
    void set_increments(const Units4& increments, std::int64_t ticks) noexcept {
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const std::int64_t whole = increments[k] + carry_[k];
            integrand_[k] = whole / ticks;
            carry_[k] = whole - integrand_[k] * ticks;
        }
    }

    /// One tick. Requires that no pulse is due.
    void tick() noexcept {
        for (std::size_t k = 0; k < kAxisCount; ++k) accumulator_[k] += integrand_[k];
    }

    /// The axes with a pulse due, bit by axis.
    std::uint32_t due() const noexcept {
        std::uint32_t mask = 0;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            mask |= static_cast<std::uint32_t>(accumulator_[k] >= kUnitsPerPulse) << k;
        }
        return mask;
    }

    /// The due pulse of this axis goes out.
    void take(std::size_t axis) noexcept { accumulator_[axis] -= kUnitsPerPulse; }

private:
    Units4 accumulator_{};
    Units4 carry_{};
    Units4 integrand_{};
};

}  // namespace psicarve::cycle
