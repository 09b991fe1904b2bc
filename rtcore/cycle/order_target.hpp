// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "rtcore/cycle/cycle_io.hpp"
#include "rtcore/cycle/soft_limits.hpp"
#include "rtcore/cycle/verdict.hpp"

namespace psicarve::cycle {

/// Where a jog or a move ends, of all axes, or why it must not go there. Unless it is refused the way there
/// breaks no soft limit.
struct OrderTarget {
    Verdict verdict;
    std::array<std::int64_t, kAxisCount> pulses{};
};

/// Of a request of kind jog, jog_on or move, from where the tips stand. A continuous jog goes as far as the
/// soft limits let it, both heads together equally far. RT: yes.
OrderTarget target_of(const Request& request, const std::array<std::int64_t, kAxisCount>& from_pulses,
                      const SoftLimits& limits) noexcept;

}  // namespace psicarve::cycle
