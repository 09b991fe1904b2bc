// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// How a motor's pulses move its tip: after a reversal they first cross the screw's backlash. At the begin of
/// a trace the tips are taken to rest against the flank that pushes them up, as the core takes it; where that
/// is wrong, the way to the first home sensor corrects it.
class Backlash {
public:
    explicit Backlash(const Profile& profile) {
        for (const Axis axis : kAllAxes) gap_[index_of(axis)] = axis_motion(profile, axis).backlash_pulses;
    }

    /// +1, -1, or 0 while the gap is crossed.
    std::int64_t step(Axis axis, bool positive) noexcept {
        std::int64_t& crossed = crossed_[index_of(axis)];
        if (positive ? crossed == 0 : crossed == gap_[index_of(axis)]) return positive ? 1 : -1;
        crossed += positive ? -1 : 1;
        return 0;
    }

private:
    std::array<std::int64_t, kAxisCount> gap_{};
    std::array<std::int64_t, kAxisCount> crossed_{};  ///< downwards
};

}  // namespace psicarve::verify
