// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

/// Why one axis alone cannot be homed; nothing when it can.
std::optional<Phrase> home_lock(const MachineView& machine, Axis axis);
/// Why its present position cannot become the operator's zero.
std::optional<Phrase> zero_lock(const MachineView& machine, Axis axis);
/// Why the drives cannot be switched off.
std::optional<Phrase> drives_off_lock(const MachineView& machine);

/// The operator's own zero of each axis, in the machine's mm and degrees. It is only for the display:
/// positions are shown from it, no motion uses it.
class WorkZero {
public:
    std::optional<double> of(Axis axis) const noexcept { return zeros_[index_of(axis)]; }
    void set(Axis axis, std::optional<double> position) noexcept { zeros_[index_of(axis)] = position; }

private:
    std::array<std::optional<double>, kAxisCount> zeros_;
};

/// The machine's position [mm; psi: 0 to 360 deg]; nothing without a known profile.
std::optional<double> position_of(const MachineView& machine, Axis axis);
/// The axis' distance from the zero [mm; psi: 0 to 360 deg]; nothing when one of them is not known.
std::optional<double> from_zero(const MachineView& machine, Axis axis, std::optional<double> zero);
/// Whether it is zero to the last digit shown.
bool is_at_zero(std::optional<double> distance);

}  // namespace psicarve::session
