// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/machine/machine_state.hpp"

namespace psicarve {

std::string_view name_of(MachineState state) noexcept {
    switch (state) {
        case MachineState::off:
            return "off";
        case MachineState::homing:
            return "homing";
        case MachineState::ready:
            return "ready";
        case MachineState::moving:
            return "moving";
        case MachineState::positioning:
            return "positioning";
        case MachineState::waiting:
            return "waiting";
        case MachineState::carving:
            return "carving";
        case MachineState::holding:
            return "holding";
        case MachineState::held:
            return "held";
        case MachineState::finishing:
            return "finishing";
        case MachineState::stopping:
            return "stopping";
        case MachineState::alarm:
            return "alarm";
        case MachineState::backing_off:
            return "backing off";
        case MachineState::testing:
            return "testing";
    }
    return "unknown";  // a number from shared memory may be anything
}

std::string_view name_of(MachineEvent event) noexcept {
    switch (event) {
        case MachineEvent::home:
            return "home";
        case MachineEvent::home_done:
            return "home done";
        case MachineEvent::start:
            return "start";
        case MachineEvent::positioned:
            return "positioned";
        case MachineEvent::start_interpolation:
            return "start interpolation";
        case MachineEvent::last_point_done:
            return "last point done";
        case MachineEvent::finished:
            return "finished";
        case MachineEvent::hold:
            return "hold";
        case MachineEvent::at_rest:
            return "at rest";
        case MachineEvent::resume:
            return "resume";
        case MachineEvent::stop:
            return "stop";
        case MachineEvent::stopped:
            return "stopped";
        case MachineEvent::move:
            return "move";
        case MachineEvent::move_done:
            return "move done";
        case MachineEvent::fail:
            return "fail";
        case MachineEvent::reset_alarm_unhomed:
            return "reset alarm, position unknown";
        case MachineEvent::reset_alarm_homed:
            return "reset alarm, position known";
        case MachineEvent::back_off:
            return "back off";
        case MachineEvent::back_off_done:
            return "back off done";
        case MachineEvent::reset_height:
            return "reset height";
        case MachineEvent::home_done_unhomed:
            return "home done, an axis not homed";
        case MachineEvent::stopped_unhomed:
            return "stopped, an axis not homed";
        case MachineEvent::begin_test:
            return "begin test";
        case MachineEvent::end_test:
            return "end test";
        case MachineEvent::drives_off:
            return "drives off";
        case MachineEvent::run_program:
            return "run program";
        case MachineEvent::program_done:
            return "program done";
    }
    return "unknown";
}

std::string_view name_of(AlarmCause cause) noexcept {
    switch (cause) {
        case AlarmCause::none:
            return "none";
        case AlarmCause::limit:
            return "limit";
        case AlarmCause::emergency_stop:
            return "emergency stop";
        case AlarmCause::steps_lost:
            return "steps lost";
        case AlarmCause::tick_gap:
            return "tick gap";
        case AlarmCause::missed_ticks:
            return "missed ticks";
        case AlarmCause::home_failed:
            return "home failed";
        case AlarmCause::segment_lost:
            return "segment lost";
        case AlarmCause::port_error:
            return "port error";
        case AlarmCause::plan_starved:
            return "plan starved";
        case AlarmCause::guard_lost:
            return "guard lost";
        case AlarmCause::core_lost:
            return "core lost";
        case AlarmCause::supervisor_stalled:
            return "supervisor stalled";
    }
    return "unknown";
}

std::string_view remedy_of(AlarmCause cause) noexcept {
    switch (cause) {
        case AlarmCause::none:
            return "Nothing is wrong.";
        case AlarmCause::limit:
            return "Back the axis off its sensor, reset the alarm, then home; check the wire if no axis "
                   "stands at a sensor.";
        case AlarmCause::emergency_stop:
            return "Release the emergency stop once the machine is safe, reset the alarm, then home.";
        case AlarmCause::steps_lost:
            return "Look for what held the table back and lower its speed or acceleration if nothing did; "
                   "reset the alarm, then home.";
        case AlarmCause::tick_gap:
            return "The computer paused too long while an axis moved: give the core real-time rights or a "
                   "quieter machine; reset the alarm, then home.";
        case AlarmCause::missed_ticks:
            return "The computer is too busy: give the core real-time rights, lengthen tick.period_us or "
                   "raise tick.missed_alarm_per_s; then reset the alarm.";
        case AlarmCause::home_failed:
            return "Check the axis' home sensor, its wire and its pin in the profile; reset the alarm, then "
                   "home again.";
        case AlarmCause::segment_lost:
            return "The shared memory was removed or damaged from outside: reset the alarm and publish the "
                   "job again.";
        case AlarmCause::port_error:
            return "Check the port's card, cable and driver; once it answers again, reset the alarm, then "
                   "home.";
        case AlarmCause::plan_starved:
            return "Planning fell behind the motion: free the computer of other work or lower the feed; "
                   "reset "
                   "the alarm, then start again.";
        case AlarmCause::guard_lost:
            return "The guard process ended: start the core again.";
        case AlarmCause::core_lost:
            return "The core ended in the middle of its work and its guard switched drives and spindle off: "
                   "start the core again, home, and carve on from the layer it was in.";
        case AlarmCause::supervisor_stalled:
            return "The core heard no command for a second, no stop either: free the computer of other work, "
                   "look after its memory and disks; reset the alarm, then start again.";
    }
    return "Reset the alarm, then home.";
}

}  // namespace psicarve
