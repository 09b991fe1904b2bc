// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rtcore/cycle/cycle_config.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

inline constexpr SignalWord kLimitMask =
    bit_of(Signal::r1_limit) | bit_of(Signal::r2_limit) | bit_of(Signal::y_limit);
inline constexpr SignalWord kIndexBit = bit_of(Signal::psi_index);
inline constexpr SignalWord kEstopBit = bit_of(Signal::estop);

/// Input levels and their filter: a limit counts once its raw level stood for filter_ticks; index and
/// emergency stop count at once. RT: yes.
class Inputs {
public:
    explicit Inputs(const CycleConfig& config) noexcept
        : mask_(config.input_mask), filter_ticks_(static_cast<std::uint64_t>(config.filter_ticks)) {}

    /// Whether take() has anything to do.
    bool needs(SignalWord raw) const noexcept { return (raw & mask_) != raw_ || raw_ != accepted_; }

    /// The levels read at this tick, before any of its pulses.
    void take(SignalWord raw, std::uint64_t tick,
              const std::array<std::int64_t, kAxisCount>& positions) noexcept {
        raw &= mask_;
        const SignalWord changed = raw ^ raw_;
        raw_ = raw;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            const SignalWord bit = SignalWord{1} << (kFirst + k);
            if ((changed & bit) == 0) continue;
            since_[k] = tick;
            edge_position_[k] = positions[k];
        }
        accept(tick);
    }

    SignalWord raw() const noexcept { return raw_; }
    /// Limits filtered, the others as they are.
    SignalWord accepted() const noexcept { return accepted_; }
    bool is_tripped(std::size_t axis) const noexcept { return (accepted_ >> (kFirst + axis) & 1U) != 0; }
    bool is_raw_tripped(std::size_t axis) const noexcept { return (raw_ >> (kFirst + axis) & 1U) != 0; }
    /// Where the axis stood when its sensor's raw level last changed.
    std::int64_t edge_position(std::size_t axis) const noexcept { return edge_position_[axis]; }

private:
    static constexpr std::size_t kFirst = index_of(Signal::r1_limit);

    void accept(std::uint64_t tick) noexcept {
        accepted_ = (accepted_ & kLimitMask) | (raw_ & ~kLimitMask);
        SignalWord waiting = (raw_ ^ accepted_) & kLimitMask;
        for (std::size_t k = 0; waiting != 0 && k < kAxisCount; ++k) {
            const SignalWord bit = SignalWord{1} << (kFirst + k);
            if ((waiting & bit) != 0 && tick - since_[k] >= filter_ticks_) accepted_ ^= bit;
            waiting &= ~bit;
        }
    }

    SignalWord mask_;
    std::uint64_t filter_ticks_;
    SignalWord raw_ = 0;
    SignalWord accepted_ = 0;
    std::array<std::uint64_t, kAxisCount> since_{};
    std::array<std::int64_t, kAxisCount> edge_position_{};
};

}  // namespace psicarve::cycle
