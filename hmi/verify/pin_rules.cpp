// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/pin_rules.hpp"

#include <bit>
#include <utility>

namespace psicarve::verify {

namespace {
constexpr SignalWord kPermissionMask = kEnableMask | kInputMask | bit_of(Signal::spindle);
}  // namespace

PinRules::PinRules(const Profile& profile, OffenceLog& log, const CarvePlace& place, PositionJudge& judge)
    : place_(place),
      judge_(judge),
      timing_(profile.port, log),
      motors_(profile, log),
      permission_(profile, log),
      backlash_(profile) {
    log.set_judged(2);
    log.set_judged(4);
}

Result<void> PinRules::begin(const TraceStart& start) {
    levels_ = start.initial_levels;
    spindle_bit_ = start.present & bit_of(Signal::spindle);
    positions_ = start.position_pulses;
    permission_.begin(start.initial_levels, start.present, start.period_ns);
    motors_.begin(start.period_ns);
    return backlash_.begin(start);
}

void PinRules::feed(std::span<const TraceEvent> events) {
    for (const TraceEvent& event : events) {
        if (event.time_ns != instant_ns_) {
            settle();
            instant_ns_ = event.time_ns;
        }
        if (event.kind == TraceEvent::Kind::pins)
            pins(event);
        else
            redefine(event);
    }
}

void PinRules::pulse(Axis axis) {
    const std::size_t a = index_of(axis);
    const bool positive = (levels_ & bit_of(dir_of(axis))) != 0;
    timing_.rising(axis, instant_ns_, place_);
    permission_.rising(axis, positive, instant_ns_, place_);
    motors_.pulse(axis, positive, instant_ns_, place_);
    const std::int64_t moved = backlash_.step(axis, positive);
    positions_[a] += moved;
    ++pulses_[a];
    unsettled_ = unsettled_ || moved != 0;
}

void PinRules::pins(const TraceEvent& event) {
    const SignalWord changed = levels_ ^ event.levels;
    if (changed == 0) return;
    ++events_;
    const SignalWord before = std::exchange(levels_, event.levels);
    if ((changed & kPermissionMask) != 0) {
        permission_.levels_changed(before, levels_, instant_ns_);
        motors_.levels_changed(before, levels_, instant_ns_);
    }
    unsettled_ = unsettled_ || (changed & (spindle_bit_ | kSwitchedMask)) != 0;
    for (SignalWord turned = (changed & kDirMask) >> kAxisCount; turned != 0; turned &= turned - 1)
        timing_.direction_changed(static_cast<Axis>(std::countr_zero(turned)), instant_ns_, place_);
    for (SignalWord fell = changed & ~levels_ & kStepMask; fell != 0; fell &= fell - 1)
        timing_.falling(static_cast<Axis>(std::countr_zero(fell)), instant_ns_, place_);
    for (SignalWord rose = changed & levels_ & kStepMask; rose != 0; rose &= rose - 1)
        pulse(static_cast<Axis>(std::countr_zero(rose)));
}

void PinRules::settle() {
    if (!std::exchange(unsettled_, false)) return;
    judge_.settle(instant_ns_, positions_, levels());
}

void PinRules::redefine(const TraceEvent& event) {
    settle();
    positions_ = event.position_pulses;
    judge_.redefine(event.time_ns, positions_);
    permission_.positions_redefined();
}

void PinRules::point_reached() {
    motors_.point_reached(instant_ns_, place_);
}

void PinRules::finish() {
    permission_.finish();
    motors_.finish(instant_ns_);
}

}  // namespace psicarve::verify
