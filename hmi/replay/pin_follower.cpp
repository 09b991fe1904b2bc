// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/pin_follower.hpp"

#include <bit>

namespace psicarve::replay {

using verify::TraceEvent;

PinFollower::PinFollower(const verify::TraceStart& start, const Profile& profile) : backlash_(profile) {
    moment_.levels = start.initial_levels;
    moment_.position_pulses = start.position_pulses;
    // With another machine's profile it is shown as well as that allows; a judge refuses it.
    (void)backlash_.begin(start);
}

void PinFollower::take(const TraceEvent& event) noexcept {
    moment_.time_ns = event.time_ns;
    if (event.kind == TraceEvent::Kind::position) {
        moment_.position_pulses = event.position_pulses;
        ++moment_.definitions;
        return;
    }
    SignalWord rose = ~moment_.levels & event.levels & kStepMask;
    moment_.levels = event.levels;
    for (; rose != 0; rose &= rose - 1) pulse(static_cast<Axis>(std::countr_zero(rose)));
}

void PinFollower::pulse(Axis axis) noexcept {
    const std::size_t k = index_of(axis);
    ++moment_.pulses[k];
    if ((moment_.levels & bit_of(enable_of(axis))) == 0) return;  // a disabled driver ignores it
    moment_.position_pulses[k] += backlash_.step(axis, (moment_.levels & bit_of(dir_of(axis))) != 0);
}

}  // namespace psicarve::replay
