// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/axis_actions.hpp"

#include <algorithm>
#include <cmath>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/session/action_lock.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

constexpr double kTurn_deg = 360.0;
constexpr double kHalfDigit = 0.005;

double within_a_turn(double angle_deg) {
    const double rest = std::fmod(angle_deg, kTurn_deg);
    return rest < 0.0 ? rest + kTurn_deg : rest;
}

}  // namespace

std::optional<Phrase> home_lock(const MachineView& machine, Axis axis) {
    if (auto lock = lock_of(Action::home, machine, OpenJobView{})) return lock;
    if (axis != Axis::psi || (machine.is_homed(Axis::r1) && machine.is_homed(Axis::r2))) return std::nullopt;
    return phrase("Home Ψ: home R1 and R2 first");
}

std::optional<Phrase> zero_lock(const MachineView& machine, Axis axis) {
    if (auto lock = lock_of(Action::home, machine, OpenJobView{})) return lock;
    if (!machine.is_homed(axis)) return phrase("Zero: axis %1 is not homed", axis_letter(axis));
    if (!machine.profile) return phrase("Zero: the machine's profile is not known here");
    return std::nullopt;
}

std::optional<Phrase> drives_off_lock(const MachineView& machine) {
    if (auto lock = lock_of(Action::home, machine, OpenJobView{})) return lock;
    const auto is_on = [&machine](Axis axis) { return machine.is_active(enable_of(axis)); };
    // In state off a drive may hold an axis that was homed alone.
    if (machine.state() == MachineState::off && std::none_of(kAllAxes.begin(), kAllAxes.end(), is_on))
        return phrase("Drives off: they are off");
    return std::nullopt;
}

std::optional<double> position_of(const MachineView& machine, Axis axis) {
    if (!machine.status || !machine.profile) return std::nullopt;
    const std::int64_t pulses = machine.status->position_pulses[index_of(axis)];
    if (axis == Axis::psi) return within_a_turn(deg_from_pulses(pulses, machine.profile->psi.pulses_per_rev));
    return mm_from_pulses(pulses, axis_motion(*machine.profile, axis).pulses_per_unit);
}

std::optional<double> from_zero(const MachineView& machine, Axis axis, std::optional<double> zero) {
    const auto position = position_of(machine, axis);
    if (!position || !zero || !machine.is_homed(axis)) return std::nullopt;
    return axis == Axis::psi ? within_a_turn(*position - *zero) : *position - *zero;
}

bool is_at_zero(std::optional<double> distance) {
    return distance && std::fabs(*distance) < kHalfDigit;
}

}  // namespace psicarve::session
