// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "shared/machine/status.hpp"

namespace psicarve::report {

/// The data of an alarm "steps lost".
struct LostSteps {
    std::int64_t off_pulses = 0;  ///< where the table stands minus where it was counted: negative, it has not
                                  ///< come as far as it should
    std::optional<double> off_deg;
    struct Layers {
        std::uint32_t first = 0;  ///< the last in which the table was where it should be; counted from 0
        std::uint32_t last = 0;   ///< the one in which it was found not to be
    };
    std::optional<Layers> layers;  ///< the layers that can be wrong; nothing: none was carved
};

/// Nothing: the alarm has another cause. `pulses_per_rev`: of the table; 0: not known.
std::optional<LostSteps> lost_steps_of(const AlarmRecord& alarm, std::int64_t pulses_per_rev);

/// "the table stands -1.350 degrees (-3 pulses) off; layers 3 to 5 can be wrong"; without degrees where these
/// are not known.
std::string lost_steps_text(const LostSteps& lost);

}  // namespace psicarve::report
