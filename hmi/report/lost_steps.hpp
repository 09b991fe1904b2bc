// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "shared/machine/status.hpp"

namespace psicarve::report {

/// What an alarm "steps lost" says.
struct LostSteps {
    std::int64_t off_pulses = 0;  ///< where the table stands less where it was counted to be: negative, it
                                  ///< has not come so far as it should
    std::optional<double> off_deg;
    struct Layers {
        std::uint32_t first = 0;  ///< in which the table was last where it should be; counted from 0
        std::uint32_t last = 0;   ///< in which it was found not to be
    };
    std::optional<Layers> layers;  ///< that can be wrong; nothing: none was carved
};

/// Nothing: the alarm is another one. `pulses_per_rev` of the table; 0: not known.
std::optional<LostSteps> lost_steps_of(const AlarmRecord& alarm, std::int64_t pulses_per_rev);

/// "the table stands -1.350 degrees (-3 pulses) off; layers 3 to 5 can be wrong"; without degrees where these
/// are not known.
std::string lost_steps_text(const LostSteps& lost);

}  // namespace psicarve::report
