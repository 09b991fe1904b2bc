// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/cycle/cycle_config.hpp"

namespace psicarve::cycle {

/// Where psi stood when its index changed, against where the index is. The index is tripped from its position
/// on: turning positive it begins to trip there; turning negative it ceases one pulse below.
struct IndexCheck {
    std::int64_t seen_pulses;  ///< the position at which it was, by the count
    std::int64_t off_pulses;   ///< so far from where it should be, at most half a turn either way
    bool is_right;             ///< within the tolerance
};

/// Requires a positive count of pulses in a turn. RT: yes.
constexpr IndexCheck check_index(const CycleConfig& config, std::int64_t position_pulses,
                                 bool is_positive) noexcept {
    const std::int64_t seen = position_pulses + (is_positive ? 0 : 1);
    std::int64_t off = (seen - config.index_position_pulses) % config.pulses_per_rev;
    if (off > config.pulses_per_rev / 2) off -= config.pulses_per_rev;
    if (off < -config.pulses_per_rev / 2) off += config.pulses_per_rev;
    return {seen, off, off <= config.index_tolerance_pulses && off >= -config.index_tolerance_pulses};
}

}  // namespace psicarve::cycle
