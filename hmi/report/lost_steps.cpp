// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/lost_steps.hpp"

#include <cmath>
#include <cstdio>

#include "shared/base/units.hpp"

namespace psicarve::report {

std::optional<LostSteps> lost_steps_of(const AlarmRecord& alarm, const TableSize& table) {
    if (alarm.cause != AlarmCause::steps_lost) return std::nullopt;
    LostSteps lost;
    // The index does not move: a count that is further by this much means that the table is not.
    lost.off_pulses = static_cast<std::int64_t>(static_cast<std::uint64_t>(alarm.expected) -
                                                static_cast<std::uint64_t>(alarm.seen));
    if (table.pulses_per_rev > 0) {
        lost.off_deg = deg_from_pulses(lost.off_pulses, table.pulses_per_rev);
        const double off_rad = rad_from_pulses(lost.off_pulses, table.pulses_per_rev);
        if (table.reach_mm > 0.0) lost.most_off_mm = off_rad * table.reach_mm;
    }
    if (alarm.layer_count > 0)
        lost.layers = LostSteps::Layers{alarm.first_layer, alarm.first_layer + alarm.layer_count - 1U};
    return lost;
}

std::string lost_steps_text(const LostSteps& lost) {
    char amount[128];
    const auto pulses = static_cast<long long>(lost.off_pulses);
    if (lost.off_deg && lost.most_off_mm) {
        std::snprintf(amount, sizeof amount,
                      "%+.3f degrees (%+lld pulses, up to %.3f mm at the blank's surface)", *lost.off_deg,
                      pulses, std::abs(*lost.most_off_mm));
    } else if (lost.off_deg) {
        std::snprintf(amount, sizeof amount, "%+.3f degrees (%+lld pulses)", *lost.off_deg, pulses);
    } else {
        std::snprintf(amount, sizeof amount, "%+lld pulses", pulses);
    }
    const std::string text = "the table stands " + std::string{amount} + " off";
    if (!lost.layers) return text;
    const std::string first = std::to_string(lost.layers->first);
    if (lost.layers->first == lost.layers->last) return text + "; layer " + first + " can be wrong";
    return text + "; layers " + first + " to " + std::to_string(lost.layers->last) + " can be wrong";
}

}  // namespace psicarve::report
