// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/drawing_machine.hpp"

#include "hmi/gcode/axis_letters.hpp"
#include "shared/base/units.hpp"

namespace psicarve::gcode {

DrawingMachine drawing_machine_of(const Profile& profile) noexcept {
    DrawingMachine machine;
    machine.is_known = true;
    machine.is_y_on_z = profile.gcode.letters == AxisNames::turning;
    machine.tolerance_mm = profile.job.path_tolerance_mm;
    machine.feeds_over_surface = profile.gcode.feeds_over_surface;
    const AxisLetters letters{profile.gcode};
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const AxisMotion motion = axis_motion(profile, head);
        machine.head_letters[index_of(head)] = letters.letter_of(head);
        machine.out_mm[index_of(head)] = mm_from_pulses(motion.travel_max_pulses, motion.pulses_per_unit);
        machine.tip_mm[index_of(head)] = (head == Axis::r1 ? profile.r1 : profile.r2).tip_mm();
        machine.half_pulse_mm[index_of(head)] = 0.5 / motion.pulses_per_unit;
    }
    machine.follows = profile.gcode.second_head == SecondHead::follow;
    machine.core_mm = profile.core_radius_mm;
    return machine;
}

}  // namespace psicarve::gcode
