// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/machine_options.hpp"

#include "hmi/gcode/machine_check.hpp"

namespace psicarve::gcode {

InterpreterOptions machine_options(const Profile& profile) noexcept {
    InterpreterOptions options;
    options.reference = MachineCheck::reference_of(profile);
    options.drawing = drawing_machine_of(profile);
    return options;
}

}  // namespace psicarve::gcode
