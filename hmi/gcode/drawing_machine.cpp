// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/drawing_machine.hpp"

#include "hmi/gcode/axis_letters.hpp"
#include "shared/base/units.hpp"

namespace psicarve::gcode {

DrawingMachine drawing_machine_of(const Profile& profile) noexcept {
    DrawingMachine machine;
    machine.is_y_on_z = profile.gcode.letters == AxisNames::turning;
    machine.tolerance_mm = profile.job.path_tolerance_mm;
    machine.feeds_over_surface = profile.gcode.feeds_over_surface;
    const AxisLetters letters{profile.gcode};
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const AxisMotion motion = axis_motion(profile, head);
        machine.head_letters[index_of(head)] = letters.letter_of(head);
        machine.out_mm[index_of(head)] = mm_from_pulses(motion.travel_max_pulses, motion.pulses_per_unit);
    }
    const bool follows = profile.gcode.second_head == SecondHead::follow;
    for (const Axis head : {Axis::r1, Axis::r2}) {
        if (head == Axis::r2 && !follows) continue;
        const double per_mm = axis_motion(profile, head).pulses_per_unit;
        const double core_mm = mm_from_pulses(core_radius_pulses(profile, head), per_mm);
        if (core_mm < machine.core_mm) continue;
        machine.core_mm = core_mm;
        machine.core_half_pulse_mm = 0.5 / per_mm;
    }
    return machine;
}

}  // namespace psicarve::gcode
