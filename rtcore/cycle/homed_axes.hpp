// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "shared/machine/signal.hpp"

namespace psicarve::cycle {

/// The axes whose position is known, bit by axis. Homing makes it known; whatever may have turned a rotor
/// without being counted takes it away. RT: yes.
class HomedAxes {
public:
    static constexpr std::uint32_t kAll = (1U << kAxisCount) - 1;
    static constexpr std::uint32_t kHeadsMask = (1U << kHeads) - 1;

    std::uint8_t mask() const noexcept { return static_cast<std::uint8_t>(mask_); }
    /// Requires axis < kAxisCount.
    bool has(std::size_t axis) const noexcept { return (mask_ >> axis & 1U) != 0; }
    bool has_all() const noexcept { return mask_ == kAll; }
    bool has_heads() const noexcept { return (mask_ & kHeadsMask) == kHeadsMask; }

    /// Requires axis < kAxisCount.
    void add(std::size_t axis) noexcept { mask_ |= 1U << axis; }
    void add_all() noexcept { mask_ = kAll; }
    void lose(std::uint32_t axes) noexcept { mask_ &= ~axes; }
    void lose_all() noexcept { mask_ = 0; }

    /// Y and psi only move where the heads are known to be out of their way, or go out first: whether these
    /// axes may be homed together.
    bool may_home(std::uint32_t axes) const noexcept {
        const bool has_others = (axes & ~kHeadsMask) != 0;
        return !has_others || ((mask_ | axes) & kHeadsMask) == kHeadsMask;
    }

private:
    std::uint32_t mask_ = 0;
};

}  // namespace psicarve::cycle
