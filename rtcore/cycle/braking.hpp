// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "rtcore/cycle/motion_block.hpp"

namespace psicarve::cycle {

/// Of the acceleration that is left, so much is used to get to the target. The rest pays for the pulses'
/// being whole and on ticks, which a plan that goes to the limit has spent already.
inline constexpr double kSteeringShare = 0.97;

/// (du/dt)^2 at a segment's begin from which it is known that every axis can brake to `end_speed2` at its
/// end, as hard as they may [u^2/s^2]. Along either profile scaled down it may, too; that alone is known
/// where bending takes more than an axis has already at the end. No plan ends faster than [1]: what is asked
/// beyond that is no bound. RT: yes.
inline double braked_speed2(const PathTiming& timing, double end_speed2) noexcept {
    end_speed2 = std::min(end_speed2, timing.end_speed2[1]);
    const double way = 2.0 * kSteeringShare * timing.length;
    double speed2 = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        const double free = double{timing.accel_free[k]};
        const double bend = double{timing.accel_bend[k]};
        // x = end + way * (free - bend * x)
        const double axis2 = free < bend * end_speed2 ? 0.0 : (end_speed2 + way * free) / (1.0 + way * bend);
        speed2 = std::min(speed2, axis2);
    }
    for (std::size_t i = 0; i < timing.start_speed2.size(); ++i) {
        if (timing.end_speed2[i] <= 0.0 || end_speed2 > timing.end_speed2[i]) continue;
        speed2 = std::max(speed2, timing.start_speed2[i] * (end_speed2 / timing.end_speed2[i]));
    }
    return speed2;
}

}  // namespace psicarve::cycle
