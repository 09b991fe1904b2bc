// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "hmi/trace/trace_reader.hpp"
#include "shared/base/result.hpp"
#include "shared/machine/signal.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// How a motor's pulses move its tip: after a reversal they first cross the screw's backlash. A trace says
/// how much of it was crossed at its begin. Where it does not, the tips are taken to rest against the flank
/// that pushes them up, as a core takes it that begins; where that is wrong, the way to the first home sensor
/// corrects it.
class Backlash {
public:
    explicit Backlash(const Profile& profile) {
        for (const Axis axis : kAllAxes) gap_[index_of(axis)] = axis_motion(profile, axis).backlash_pulses;
    }

    /// As a trace begins. Refused where it has crossed more than there is: then the gap counts as crossed.
    Result<void> begin(const TraceStart& start) {
        Result<void> fits;
        for (const Axis axis : kAllAxes) {
            const std::size_t k = index_of(axis);
            crossed_[k] = std::min(start.crossed_pulses[k], gap_[k]);
            if (fits && start.crossed_pulses[k] > gap_[k])
                fits = bad_input(std::string{name_of(axis)} + " begins " +
                                 std::to_string(start.crossed_pulses[k]) +
                                 " pulses into its backlash, which is " + std::to_string(gap_[k]) +
                                 " by this profile: it is not of the machine that was traced");
        }
        return fits;
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
