// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/gcode/interpreter.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::gcode {

/// How a program is read for a machine: all that the profile says of it.
InterpreterOptions machine_options(const Profile& profile) noexcept;

}  // namespace psicarve::gcode
