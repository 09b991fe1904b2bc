// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/refusal_message.hpp"

#include "shared/base/units.hpp"
#include "shared/machine/message_argument.hpp"

namespace psicarve::supervisor {
namespace {

SignalWord tripped_inputs(SignalWord signals) noexcept {
    return signals & kInputMask & ~bit_of(Signal::psi_index);
}

/// The soft limit that is in the way.
Message limit_message(const cycle::Report& answer, CommandKind command, const Profile& profile) {
    using R = cycle::Refusal;
    const Argument asked = argument_of(command);
    if (answer.record.axis >= kAxisCount) return message_of(MessageId::beyond_limits, asked);
    const auto axis = static_cast<Axis>(answer.record.axis);
    const AxisMotion motion = axis_motion(profile, axis);
    const auto at = [&](std::int64_t pulses) {
        return mm_argument(mm_from_pulses(pulses, motion.pulses_per_unit));
    };
    const Argument of_axis = argument_of(axis);
    if (answer.refusal == R::heads_too_close)
        return message_of(MessageId::heads_too_close, asked, of_axis, mm_argument(profile.head_clearance_mm));
    if (answer.refusal == R::inside_core_radius)
        return message_of(MessageId::inside_core_radius, asked, of_axis, mm_argument(profile.core_radius_mm));
    if (answer.refusal == R::at_the_end) return message_of(MessageId::at_the_end, asked, of_axis);
    if (!motion.has_travel) return message_of(MessageId::cannot_count_so_far, asked, of_axis);
    return message_of(MessageId::outside_travel, asked, of_axis, at(motion.travel_min_pulses),
                      at(motion.travel_max_pulses));
}

Message state_message(CommandKind command, MachineState state) {
    if (command == CommandKind::reset_alarm || command == CommandKind::back_off)
        return message_of(MessageId::no_alarm, argument_of(command));
    if (command == CommandKind::test_pin && state == MachineState::ready)
        return message_of(MessageId::pins_need_drives_off);
    if (state == MachineState::testing) return message_of(MessageId::output_tested);
    return message_of(MessageId::wrong_state, argument_of(command), argument_of(state), way_out_of(state));
}

}  // namespace

Message refusal_message(const cycle::Report& answer, CommandKind command, const cycle::Sample& sample,
                        const Profile& profile, JobCounts of_job) {
    using R = cycle::Refusal;
    switch (answer.refusal) {
        case R::none:
            return {};
        case R::not_in_this_state:
            return state_message(command, sample.state);
        case R::no_job:
            return message_of(MessageId::no_job);
        case R::not_homed:
            return message_of(MessageId::not_homed);
        case R::still_tripped:
            // By now it may be free.
            if (tripped_inputs(sample.signals) == 0) return message_of(MessageId::switch_was_tripped);
            return message_of(MessageId::still_tripped, signals_argument(tripped_inputs(sample.signals)));
        case R::sensor_not_tripped:
            return message_of(MessageId::sensor_not_tripped);
        case R::no_sensor:
            return message_of(MessageId::no_sensor);
        case R::not_an_arc:
            return message_of(MessageId::not_an_arc);
        case R::outside_travel:
        case R::inside_core_radius:
        case R::heads_too_close:
        case R::at_the_end:
            return limit_message(answer, command, profile);
        case R::no_such_layer:
            return message_of(MessageId::no_such_layer, count_argument(of_job.layers));
        case R::no_such_point:
            return message_of(MessageId::no_such_point, count_argument(of_job.points));
        case R::recording:
            return message_of(MessageId::recording_taken);
        case R::heads_not_homed:
            return message_of(MessageId::heads_not_homed);
        case R::port_failed:
            return message_of(MessageId::port_failed);
        case R::port_reset_first:
            return message_of(MessageId::port_reset_first);
        case R::overtaken:
            return message_of(MessageId::overtaken, argument_of(command));
        case R::bad_override:
            return message_of(MessageId::bad_override);
        case R::bad_rapid_override:
            return message_of(MessageId::bad_rapid_override);
        case R::no_program:
            return command == CommandKind::optional_stop ? message_of(MessageId::no_program_for_optional_stop)
                                                         : message_of(MessageId::no_program_runs);
    }
    return message_of(MessageId::refused);
}

}  // namespace psicarve::supervisor
