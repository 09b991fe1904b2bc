// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// The dual-head DDA: spreads the pulses of all axes evenly over S iterations, S being the long axis' pulses.
///
///     acc_k = S/2;   one iteration: acc_k += |d_k|; if acc_k >= S: acc_k -= S, axis k emits one pulse
///
/// After S iterations every axis has emitted exactly |d_k| pulses, at every iteration each is within half a
/// pulse of the straight line, and each iteration emits at least one pulse. Whole numbers only, so that the
/// order of pulses is the same whatever the speed. All four axes: a table's lines leave Y at 0.
/// Source: the original's dual-head scheme, docs/interpolation.md. RT: yes.
class DualHeadDda {
public:
    /// Requires |delta| < 2^62.
    void start(const std::array<std::int64_t, kAxisCount>& delta_pulses) noexcept {
        capacity_ = 0;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            step_[k] = delta_pulses[k] < 0 ? -delta_pulses[k] : delta_pulses[k];
            capacity_ = std::max(capacity_, step_[k]);
        }
        accumulator_.fill(capacity_ / 2);
        left_ = capacity_;
    }

    /// A part of a longer line, in the very order of pulses that the whole line would have: the iterations
    /// `done` to `done + count` of `line_pulses`. Requires done + count <= S and S * |d| < 2^62.
    void start_within(const std::array<std::int64_t, kAxisCount>& line_pulses, std::int64_t done,
                      std::int64_t count) noexcept {
        start(line_pulses);
        left_ = count;
        if (done == 0) return;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            accumulator_[k] = (accumulator_[k] + done * step_[k]) % capacity_;
        }
    }

    std::int64_t iterations_left() const noexcept { return left_; }

    /// One iteration: the axes that emit a pulse, bit by axis. Requires iterations_left() > 0.
    std::uint32_t iterate() noexcept {
        --left_;
        std::uint32_t mask = 0;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const std::int64_t sum = accumulator_[k] + step_[k];
            const bool overflows = sum >= capacity_;
            accumulator_[k] = overflows ? sum - capacity_ : sum;
            mask |= static_cast<std::uint32_t>(overflows) << k;
        }
        return mask;
    }

private:
    std::array<std::int64_t, kAxisCount> step_{};
    std::array<std::int64_t, kAxisCount> accumulator_{};
    std::int64_t capacity_ = 0;
    std::int64_t left_ = 0;
};

}  // namespace psicarve::cycle
