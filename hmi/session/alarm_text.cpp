// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/alarm_text.hpp"

#include <cstdlib>
#include <string>

#include "hmi/phrase/axis_letter.hpp"
#include "hmi/report/lost_steps.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/session/program_phrase.hpp"
#include "hmi/session/start_place.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

Axis axis_of(const CoreStatus& status) {
    return status.alarm_axis < kAxisCount ? static_cast<Axis>(status.alarm_axis) : Axis::psi;
}

/// "21.21 mm", or in pulses when the machine's profile is not known.
std::string shown_position(const MachineView& machine, Axis axis) {
    const AxisReadout readout = axis_readout(machine, axis);
    return readout.value + " " + readout.unit;
}

Phrase limit_title(const MachineView& machine, Axis axis) {
    // A job's profile may have other pins.
    if (!machine.profile || machine.is_profile_of_job)
        return phrase("Limit switch %1 closed", axis_letter(axis));
    const std::string pin = std::to_string(std::abs(machine.profile->port.pins[index_of(sensor_of(axis))]));
    const HomeSensor end = axis_motion(*machine.profile, axis).home;
    if (axis == Axis::y) {
        return end == HomeSensor::max ? phrase("Limit switch Y closed (upper end, pin %1)", pin)
                                      : phrase("Limit switch Y closed (lower end, pin %1)", pin);
    }
    return end == HomeSensor::min
               ? phrase("Limit switch %1 closed (inner end, pin %2)", axis_letter(axis), pin)
               : phrase("Limit switch %1 closed (outer end, pin %2)", axis_letter(axis), pin);
}

Phrase limit_detail(const MachineView& machine, Axis axis) {
    const std::string letter = axis_letter(axis);
    if (!machine.profile) {
        return phrase("Axis %1 stopped at %2. Likely a chip or a broken wire at the switch, or lost steps.",
                      letter, shown_position(machine, axis));
    }
    const AxisMotion motion = axis_motion(*machine.profile, axis);
    const double switch_mm = mm_from_pulses(motion.home_position_pulses, motion.pulses_per_unit);
    return phrase(
        "Axis %1 stopped at %2; its switch stands at %3 mm. Likely a chip or a broken wire at the switch, or "
        "%1 "
        "has lost steps.",
        letter, shown_position(machine, axis), number_text(switch_mm, 2));
}

/// The axes whose position is no longer certain.
std::vector<Axis> unsure_axes(const MachineView& machine) {
    std::vector<Axis> unsure;
    for (const Axis axis : kAllAxes) {
        if (!machine.is_homed(axis)) unsure.push_back(axis);
    }
    return unsure;
}

void add_way_back(const MachineView& machine, AlarmText& text) {
    text.steps.push_back(phrase("Reset alarm"));
    const auto unsure = unsure_axes(machine);
    if (unsure.size() == 1) {
        text.steps.push_back(phrase("Home %1", axis_letter(unsure.front())));
    } else if (!unsure.empty()) {
        text.steps.push_back(phrase("Home all"));
    }
    if (machine.is_alarm_of_program) return text.steps.push_back(program_way_on(machine.program));
    const CoreStatus& status = *machine.status;
    if (status.points_done == 0 || status.points_done >= status.points_total) return;
    if (const auto place = place_to_go_on(machine); place && status.is_dry == 0) {
        text.steps.push_back(continue_text(*place));
    } else {
        text.steps.push_back(phrase("From layer %1", std::to_string(status.layer + 1)));
    }
}

AlarmText limit_text(const MachineView& machine) {
    const Axis axis = axis_of(*machine.status);
    AlarmText text{limit_title(machine, axis), limit_detail(machine, axis), {}};
    text.steps.push_back(phrase("Clear switch %1, or Back off, until its lamp goes out", axis_letter(axis)));
    add_way_back(machine, text);
    return text;
}

AlarmText estop_text(const MachineView& machine) {
    const bool has_moved = !unsure_axes(machine).empty();
    AlarmText text{
        phrase("Emergency stop"),
        has_moved ? phrase("Drives and spindle are off; the position is not certain any more.")
                  : phrase("The spindle is off. No axis moved, and drives without an enable line stay on."),
        {}};
    if (machine.is_active(Signal::estop)) text.steps.push_back(phrase("Release the emergency stop switch"));
    add_way_back(machine, text);
    return text;
}

/// How much was lost, and which layers that has ruined.
Phrase lost_detail(const MachineView& machine, const AlarmRecord& alarm) {
    const auto lost = report::lost_steps_of(
        alarm, machine.profile ? report::TableSize::of(*machine.profile) : report::TableSize{});
    if (!lost) return phrase("The Ψ index did not come where it was expected.");
    const std::string expected = count_text(alarm.expected);
    const std::string seen = count_text(alarm.seen);
    if (!lost->off_deg) {
        return phrase(
            "The Ψ index was expected at %1 pulses and came at %2. Likely the table was held or braked.",
            expected, seen);
    }
    const char* const sign = lost->off_pulses < 0 ? "\u2212" : "+";
    std::string amount = sign + number_text(std::abs(*lost->off_deg), 3) + "°";
    if (lost->most_off_mm) amount += " (≤ " + number_text(std::abs(*lost->most_off_mm), 3) + " mm)";
    if (!lost->layers) {
        return phrase(
            "The Ψ index was expected at %1 pulses and came at %2: the table stands %3 off. Likely it was "
            "held "
            "or braked.",
            expected, seen, amount);
    }
    const std::string first = std::to_string(std::uint64_t{lost->layers->first} + 1);
    const std::string last = std::to_string(std::uint64_t{lost->layers->last} + 1);
    if (first == last) {
        return phrase(
            "The Ψ index was expected at %1 pulses and came at %2: the table stands %3 off. Likely it was "
            "held "
            "or braked. Layer %4 can be wrong.",
            expected, seen, amount, first);
    }
    return phrase(
        "The Ψ index was expected at %1 pulses and came at %2: the table stands %3 off. Likely it was held "
        "or "
        "braked. Layers %4 to %5 can be wrong.",
        expected, seen, amount, first, last);
}

AlarmText steps_lost_text(const MachineView& machine) {
    const CoreStatus& status = *machine.status;
    AlarmText text{
        phrase("The table has lost steps"), phrase("The Ψ index did not come where it was expected."), {}};
    if (status.alarm_count > 0)
        text.detail = lost_detail(machine, status.alarms[(status.alarm_count - 1) % kAlarmHistory]);
    text.steps.push_back(phrase("Look for what holds the table"));
    add_way_back(machine, text);
    return text;
}

AlarmText home_failed_text(const MachineView& machine) {
    const Axis axis = axis_of(*machine.status);
    AlarmText text{
        phrase("Homing of axis %1 failed", axis_letter(axis)),
        phrase("Its sensor was not found, or did not clear. Likely a broken wire or a sensor out of place."),
        {}};
    text.steps.push_back(phrase("Check the sensor of axis %1", axis_letter(axis)));
    add_way_back(machine, text);
    return text;
}

AlarmText gap_text(const MachineView& machine) {
    const std::string letter = axis_letter(axis_of(*machine.status));
    AlarmText text{
        phrase("The computer paused while axis %1 moved", letter),
        phrase("Axis %1 stood at %2. The pause was longer than its motor coasts: it may have lost steps.",
               letter, shown_position(machine, axis_of(*machine.status))),
        {}};
    text.steps.push_back(phrase("Close other programs, or give the core real-time rights"));
    add_way_back(machine, text);
    return text;
}

AlarmText late_text(const MachineView& machine) {
    AlarmText text{phrase("The computer was too busy for the machine"),
                   phrase("Ticks were missed (%1 since the core started); motors may have lost steps.",
                          count_text(static_cast<std::int64_t>(machine.missed_ticks_at_alarm))),
                   {}};
    text.steps.push_back(phrase("Close other programs, or give the core real-time rights"));
    add_way_back(machine, text);
    return text;
}

AlarmText other_text(const MachineView& machine) {
    const AlarmCause cause = machine.status->alarm_cause;
    AlarmText text{phrase("Alarm: %1", name_of(cause)), phrase("%1", remedy_of(cause)), {}};
    add_way_back(machine, text);
    return text;
}

AlarmText silent_port_text(const MachineView& machine) {
    AlarmText text{phrase("The port does not answer"),
                   phrase("Drives and spindle may still be on: the port has not taken the order to switch "
                          "them off. It is repeated until it does."),
                   {}};
    text.steps.push_back(phrase("Switch the machine off by its own switch"));
    text.steps.push_back(phrase("See to the port's card, cable and driver"));
    add_way_back(machine, text);
    return text;
}

}  // namespace

std::vector<Axis> alarm_heads(const MachineView& machine) {
    const MachineState state = machine.state();
    if (state != MachineState::alarm && state != MachineState::backing_off) return {};
    if (machine.status->alarm_axis >= kAxisCount) return {};
    switch (const Axis axis = axis_of(*machine.status)) {
        case Axis::r1:
        case Axis::r2:
            return {axis};
        case Axis::y:
            return {Axis::r1, Axis::r2};
        case Axis::psi:
            break;
    }
    return {};
}

AlarmText alarm_text(const MachineView& machine) {
    if (machine.status->is_port_silent != 0) return silent_port_text(machine);
    switch (machine.status->alarm_cause) {
        case AlarmCause::limit:
            return limit_text(machine);
        case AlarmCause::emergency_stop:
            return estop_text(machine);
        case AlarmCause::steps_lost:
            return steps_lost_text(machine);
        case AlarmCause::home_failed:
            return home_failed_text(machine);
        case AlarmCause::tick_gap:
            return gap_text(machine);
        case AlarmCause::missed_ticks:
            return late_text(machine);
        default:
            return other_text(machine);
    }
}

}  // namespace psicarve::session
