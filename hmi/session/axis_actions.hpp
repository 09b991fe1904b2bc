// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_sight.hpp"

namespace psicarve::session {

/// What stands in the way of homing one axis alone; nothing when it can be asked for.
std::optional<Phrase> home_lock(const MachineSight& machine, Axis axis);
/// Likewise of taking its present position as the operator's zero.
std::optional<Phrase> zero_lock(const MachineSight& machine, Axis axis);
/// Likewise of switching the drives off.
std::optional<Phrase> drives_off_lock(const MachineSight& machine);

/// The operator's own zero of each axis, in the machine's mm and degrees. It is for the eye alone: positions
/// are shown from it, and no motion knows of it.
class WorkZero {
public:
    std::optional<double> of(Axis axis) const noexcept { return zeros_[index_of(axis)]; }
    void set(Axis axis, std::optional<double> position) noexcept { zeros_[index_of(axis)] = position; }

private:
    std::array<std::optional<double>, kAxisCount> zeros_;
};

/// Of the machine [mm; psi: 0 to 360 deg]; nothing without a known profile.
std::optional<double> position_of(const MachineSight& machine, Axis axis);
/// How far the axis stands from the zero [mm; psi: 0 to 360 deg]; nothing when one of them is not known.
std::optional<double> from_zero(const MachineSight& machine, Axis axis, std::optional<double> zero);
/// To the last digit shown.
bool is_at_zero(std::optional<double> distance);

}  // namespace psicarve::session
