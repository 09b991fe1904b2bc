// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/move.hpp"

#include "rtcore/plan/approach.hpp"
#include "rtcore/plan/block_list.hpp"

namespace psicarve::plan {

std::vector<cycle::MotionBlock> move_blocks(const MachineLimits& limits, const cycle::MotionOrder& order,
                                            const Pulses4& from_pulses) {
    BlockList list(limits);
    Pulses4 from = from_pulses;
    if (order.drops_turns != 0 && (order.axes >> kPsi & 1U) != 0) {
        const std::int64_t turns =
            turns_to_drop(from[kPsi], order.target_pulses[kPsi], limits.pulses_per_rev);
        from[kPsi] -= turns * limits.pulses_per_rev;
        if (turns != 0) list.define(Axis::psi, from[kPsi]);
    }
    Pulses4 way{};
    SpeedCaps caps{};
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        if ((order.axes >> k & 1U) == 0) continue;
        way[k] = order.target_pulses[k] - from[k];
        caps[k] = order.speed_pps;
    }
    list.move(way, caps);
    list.end();
    return std::move(list.blocks());
}

}  // namespace psicarve::plan
