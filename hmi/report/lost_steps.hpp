// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "shared/machine/status.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::report {

/// What makes degrees and mm of the table's pulses; 0: not known.
struct TableSize {
    std::int64_t pulses_per_rev = 0;
    double reach_mm = 0.0;  ///< how far the blank reaches out from the table's axis

    static TableSize of(const Profile& profile) {
        return {profile.psi.pulses_per_rev, profile.blank.reach_mm()};
    }
};

/// The data of an alarm "steps lost".
struct LostSteps {
    std::int64_t off_pulses = 0;  ///< where the table stands minus where it was counted: negative, it has not
                                  ///< come as far as it should
    std::optional<double> off_deg;
    std::optional<double> most_off_mm;  ///< the same along the surface, where the blank reaches furthest
    struct Layers {
        std::uint32_t first = 0;  ///< the last in which the table was where it should be; counted from 0
        std::uint32_t last = 0;   ///< the one in which it was found not to be
    };
    std::optional<Layers> layers;  ///< the layers that can be wrong; nothing: none was carved
};

/// Nothing: the alarm has another cause.
std::optional<LostSteps> lost_steps_of(const AlarmRecord& alarm, const TableSize& table);

/// "the table stands -1.350 degrees (-3 pulses, up to 0.471 mm at the blank's surface) off; layers 3 to 5 can
/// be wrong"; without degrees and mm where these are not known.
std::string lost_steps_text(const LostSteps& lost);

}  // namespace psicarve::report
