// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/refusal_text.hpp"

#include "shared/base/decimals.hpp"
#include "shared/base/units.hpp"

namespace psicarve::supervisor {
namespace {

std::string remedy_in(MachineState state) {
    using S = MachineState;
    switch (state) {
        case S::off:
            return "home first";
        case S::ready:
            return "start first";
        case S::waiting:
            return "start interpolation, or stop";
        case S::held:
            return "resume, or stop";
        case S::alarm:
            return "reset the alarm first";
        default:
            return "wait, or stop";
    }
}

std::string tripped_inputs(SignalWord signals) {
    std::string names;
    for (std::size_t i = kOutputSignalCount; i < kSignalCount; ++i) {
        const auto signal = static_cast<Signal>(i);
        if (signal == Signal::psi_index || (signals & bit_of(signal)) == 0) continue;
        names += (names.empty() ? "" : ", ");
        names += name_of(signal);
    }
    return names;
}

/// The soft limit that is in the way.
std::string limit_text(const cycle::Report& answer, const Profile& profile) {
    using R = cycle::Refusal;
    if (answer.record.axis >= kAxisCount) return "beyond the machine's limits";
    const auto axis = static_cast<Axis>(answer.record.axis);
    const std::string name{name_of(axis)};
    const AxisMotion motion = axis_motion(profile, axis);
    const auto at = [&](std::int64_t pulses) {
        return mm_text(mm_from_pulses(pulses, motion.pulses_per_unit), 3);
    };
    if (answer.refusal == R::heads_too_close)
        return name + " would bring the tips closer than head_clearance_mm, " +
               mm_text(profile.head_clearance_mm, 3);
    if (answer.refusal == R::inside_core_radius)
        return name + " would go inside the core radius, " + mm_text(profile.core_radius_mm, 3);
    if (answer.refusal == R::at_the_end) return name + " has no way left in this direction";
    if (!motion.has_travel) return name + " cannot count so far";
    return name + " would leave its travel, " + at(motion.travel_min_pulses) + " to " +
           at(motion.travel_max_pulses);
}

}  // namespace

std::string refusal_text(const cycle::Report& answer, CommandKind command, const cycle::Sample& sample,
                         const Profile& profile, std::uint32_t layer_count) {
    using R = cycle::Refusal;
    const cycle::Refusal refusal = answer.refusal;
    const std::string state{name_of(sample.state)};
    switch (refusal) {
        case R::none:
            return {};
        case R::not_in_this_state:
            if (command == CommandKind::reset_alarm || command == CommandKind::back_off) {
                return std::string{name_of(command)} + ": there is no alarm";
            }
            if (command == CommandKind::test_pin && sample.state == MachineState::ready)
                return "pins: only with the drives off; drives-off first, positions are lost then";
            if (sample.state == MachineState::testing) return "an output is being tested; end the test first";
            return std::string{name_of(command)} + ": not while " + state + "; " + remedy_in(sample.state);
        case R::no_job:
            return "no job is published; publish one first";
        case R::not_homed:
            return "the machine is not homed; home first";
        case R::still_tripped:
            // By now it may be free.
            if (tripped_inputs(sample.signals).empty())
                return "a switch was tripped until just now; try again";
            return "still tripped: " + tripped_inputs(sample.signals) + "; release it or back off";
        case R::sensor_not_tripped:
            return "the axis' sensor is not tripped; nothing to back off from";
        case R::no_sensor:
            return "the axis has no sensor";
        case R::not_an_arc:
            return "move: begin and end of the arc are not equally far from its centre, or it is too small";
        case R::outside_travel:
        case R::inside_core_radius:
        case R::heads_too_close:
        case R::at_the_end:
            return std::string{name_of(command)} + ": " + limit_text(answer, profile);
        case R::no_such_layer:
            return "start: the job has not so many layers: " + std::to_string(layer_count) +
                   ", and the first is 0";
        case R::recording:
            return "record: another process has the pins recorded, or this core cannot; wait, or see status";
        case R::heads_not_homed:
            return "home: psi and y after r1 and r2, or with them; home r1 and r2 first";
        case R::port_failed:
            return "the port does not answer: switch the machine off by its own switch, see to card and "
                   "driver, then reset the alarm again";
        case R::port_reset_first:
            return "the port has failed; reset the alarm, then home";
        case R::overtaken:
            return std::string{name_of(command)} + ": a stop came after it; ask again";
        case R::bad_override:
            return "override: 10 to 200 per cent of the planned feed, whole";
    }
    return "refused";
}

}  // namespace psicarve::supervisor
