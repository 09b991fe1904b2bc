// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/message_phrase.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/phrase/axis_letter.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/machine_state.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::session {
namespace {

using Id = MessageId;

/// Which of a message's arguments stand for %1, %2 ...: all but a command's.
constexpr const char* kAllButCommands = "all";

struct Row {
    Id id;
    Phrase shown;
    const char* order = kAllButCommands;  ///< or these, by their numbers
};

std::vector<Row> of_commands() {
    return {
        {Id::refused, phrase("the core refuses it and gives no reason")},
        {Id::no_reason, phrase("the core refuses it and gives no reason")},
        {Id::unknown_command, phrase("the core does not know this command; is it another version?")},
        {Id::wrong_state, phrase("not while %1; %2"), "2"},
        {Id::no_alarm, phrase("there is no alarm")},
        {Id::output_tested, phrase("an output is being tested; end the test first")},
        {Id::no_job, phrase("no job is published; publish one first")},
        {Id::not_homed, phrase("the machine is not homed; home first")},
        {Id::overtaken, phrase("a stop came after it; ask again")},
        {Id::replaying, phrase("a recorded run is being replayed")},
        {Id::core_replaced, phrase("the core was replaced before it did this")},
        {Id::not_at_rest, phrase("the machine is not at rest; stop first")},
        {Id::switch_was_tripped, phrase("a switch was tripped until just now; try again")},
        {Id::still_tripped, phrase("still tripped: %1; release it or back off")},
        {Id::sensor_not_tripped, phrase("the switch of the axis is open; there is nothing to back off from")},
        {Id::no_sensor, phrase("the axis has no sensor")},
        {Id::port_failed, phrase("the port does not answer: switch the machine off by its own switch")},
        {Id::port_reset_first, phrase("the port has failed; reset the alarm, then home")},
        {Id::guard_ended, phrase("the guard process ended; start the core again")},
        {Id::no_such_sensor, phrase("no such axis")},
        {Id::heads_not_homed, phrase("Ψ and Y after R1 and R2, or with them; home R1 and R2 first")},
    };
}

std::vector<Row> of_motion() {
    return {
        {Id::heads_too_close, phrase("%1 would bring the tips closer than head_clearance_mm, %2")},
        {Id::inside_core_radius, phrase("%1 would go inside the core radius, %2")},
        {Id::at_the_end, phrase("%1 has no way left in this direction")},
        {Id::cannot_count_so_far, phrase("%1 cannot count so far")},
        {Id::outside_travel, phrase("%1 would leave its travel, %2 to %3")},
        {Id::beyond_limits, phrase("beyond the machine's limits")},
        {Id::too_far, phrase("no axis goes so far (%1)")},
        {Id::centre_too_far, phrase("the centre: no axis goes so far (%1)")},
        {Id::no_jog_axis, phrase("no such axis")},
        {Id::jog_speed_not_positive, phrase("the speed must be above 0")},
        {Id::jog_unleased, phrase("nobody holds its lease")},
        {Id::speed_limited, phrase("%1 goes at %2 at most, and so it does")},
        {Id::speed_limited_turning, phrase("%1 goes at %2 at most, and so it does")},
        {Id::no_move_axis, phrase("no axis to move")},
        {Id::unknown_shape, phrase("the core does not know this command; is it another version?")},
        {Id::arc_axes, phrase("an arc takes R1 and Y, or R2 and Y")},
        {Id::arc_scales_differ, phrase("no arc, %1 and Y differ in pulses_per_mm")},
        {Id::not_an_arc,
         phrase("begin and end of the arc are not equally far from its centre, or it is too small")},
        {Id::stepped_axes, phrase("point by point takes one or two of R1, R2 and Y")},
    };
}

std::vector<Row> of_jobs() {
    return {
        {Id::no_such_layer, phrase("the job has not so many layers, but %1")},
        {Id::no_such_first_layer, phrase("the job has no such layer")},
        {Id::no_such_point,
         phrase("a layer has %1 points: no carving begins beyond them, nor with its last")},
        {Id::layers_not_whole, phrase("a layer is a whole number")},
        {Id::job_looked_at, phrase("a published job is being looked at; start once it is accepted")},
        {Id::nothing_carved, phrase("nothing was carved yet")},
        {Id::checkpoint_damaged,
         phrase("nobody knows how far it was carved; look at the piece and choose the layer")},
        {Id::checkpoint_of_other_job, phrase("another job was carved last")},
        {Id::no_layer_finished, phrase("no layer was finished")},
        {Id::no_layer_finished_but_earlier,
         phrase("no layer was finished; start from the beginning, or with layer %1 for the piece of before")},
        {Id::carved_to_its_end, phrase("the job is carved to its end")},
        {Id::bad_override, phrase("10 to 200 per cent of the planned feed, whole")},
        {Id::bad_rapid_override, phrase("10 to 100 per cent of the speed of rapid ways, whole")},
        {Id::no_program_runs, phrase("no program runs")},
        {Id::no_program_for_optional_stop, phrase("no program runs")},
    };
}

std::vector<Row> of_outputs_and_records() {
    return {
        {Id::pins_need_drives_off, phrase("only with the drives off")},
        {Id::no_such_output, phrase("no such output")},
        {Id::output_not_wired, phrase("%1 is not wired to any pin")},
        {Id::pins_unleased, phrase("nobody holds its lease")},
        {Id::pins_pulse_bounds, phrase("1 to 10000 pulses, 1 to 500 in a second")},
        {Id::recording_taken,
         phrase("another process has the pins recorded, or this core cannot record them")},
        {Id::no_recording_form, phrase("the core cannot record so, or knows nobody to record for")},
        {Id::forget_not_at_rest, phrase("the machine is not at rest; stop first")},
        {Id::record_of_other_kind,
         phrase("that is a record of the other kind of machine; this core keeps none")},
        {Id::record_is_another, phrase("the core's disk has another record of this piece; look again")},
        {Id::forget_disk_silent, phrase("the disk does not answer, and too much waits for it")},
    };
}

std::vector<Row> of_asking() {
    return {
        {Id::no_core, phrase("no core serves segment %1")},
        {Id::no_core_for_command, phrase("no core serves segment %1")},
        {Id::core_silent, phrase("the core of segment %1 (process %2) is silent"), "21"},
        {Id::core_ended, phrase("the core ended before it answered")},
        {Id::no_answer_in_time, phrase("the core did not answer within %1 ms")},
        {Id::slots_in_use, phrase("too many commands at once; wait for the others"), ""},
        // The banner says what to do.
        {Id::alarm, phrase("alarm: %1"), "1"},
        {Id::alarm_of_axis, phrase("alarm: %1, axis %2"), "12"},
        {Id::stopped_by_somebody, phrase("the machine came to rest (%1), somebody stopped it"), "1"},
        {Id::still_in_state, phrase("the machine has not come to rest yet (%1)"), "1"},
    };
}

std::vector<Row> of_published_jobs() {
    const Phrase damaged = phrase("the published job is damaged; publish it again");
    return {
        {Id::job_unsound, phrase("the job is unsound: %1")},
        {Id::job_for_other_machine,
         phrase(
             "the job was made for another machine (%1 differ); slice it again with the machine's profile")},
        {Id::blank_too_wide,
         phrase("the blank reaches out to %1, but head %2 only to %3: it would stand in the blank before the "
                "carving begins; take a smaller blank")},
        {Id::blank_beside,
         phrase("the job's blank stands %1 beside the profile's: a part of the job is air")},
        {Id::blank_beside_in_the_way,
         phrase("the job's blank stands %1 beside the profile's, which is in the heads' way")},
        {Id::blank_radius_differs,
         phrase("the job's blank has a radius of %1, the profile's %2: a part of the job is air")},
        {Id::blank_radius_in_the_way,
         phrase("the job's blank has a radius of %1, the profile's %2, which is in the heads' way")},
        {Id::blank_height_differs,
         phrase("the job's blank has a height of %1, the profile's %2: a part of the job is air")},
        {Id::blank_height_in_the_way,
         phrase("the job's blank has a height of %1, the profile's %2, which is in the heads' way")},
        {Id::begun_with_other_profile, phrase("It was begun with another profile of the machine.")},
        {Id::segment_and_disk_disagree,
         phrase("The computer's memory says %1 layers, its disk %2: the lower number is taken.")},
        {Id::busy_for_a_job, phrase("the machine is busy; try again")},
        {Id::job_runs, phrase("a job runs (%1); stop it or wait for its end")},
        {Id::other_job_published, phrase("another job was published meanwhile; publish this one again")},
        {Id::job_refused_without_reason, phrase("the core refuses it and gives no reason")},
        {Id::published_without_core, phrase("the job is published, but no core serves segment %1")},
        {Id::job_not_judged, phrase("the core did not judge the job within %1 ms")},
        {Id::published_by_nobody, damaged, ""},
        {Id::published_too_large, damaged, ""},
        {Id::published_checksum_wrong, damaged, ""},
    };
}

std::vector<Row> of_tables() {
    const Phrase beyond = phrase(
        "layer %1, point %2: the radius of %3, %4, is beyond the travel, which ends at %5; make the model "
        "smaller");
    return {
        {Id::sweep_of_other_machine,
         phrase("a layer sweeps %1 pulses of Ψ, half a revolution of this machine is %2; slice the model for "
                "this machine's profile")},
        {Id::more_points_than_pulses,
         phrase("%1 points in a layer of %2 pulses of Ψ; slice with at most %3 points")},
        {Id::direction_reversed,
         phrase("the job's direction of axis %1 is the other way round on this machine; slice the model for "
                "this machine's profile")},
        {Id::radius_inside_core,
         phrase("layer %1, point %2: the radius of %3, %4, is inside the core radius of %5; carve less deep, "
                "or lower core_radius_mm"),
         "12346"},
        {Id::radius_below_travel, beyond, "12346"},
        {Id::radius_above_travel, beyond, "12346"},
        {Id::tips_too_close,
         phrase("layer %1, point %2: the tips are %3 apart, closer than head_clearance_mm, %4; raise "
                "core_radius_mm and slice again"),
         "1278"},
        {Id::height_outside_travel,
         phrase("layer %1: the height of %2 lies outside the travel of Y, %3 to %4; make the model smaller"),
         "1357"},
        {Id::ring_not_closed,
         phrase("layer %1: the height of %2 is not that of the layer below, %3, as in the ring that closes a "
                "spiral; slice the model again"),
         "135"},
        {Id::layer_not_higher,
         phrase("layer %1: the height of %2 does not lie above the layer below, %3; use fewer layers"),
         "135"},
        {Id::spiral_not_joined,
         phrase("layer %1, point %2: the radius of %3 is not that in which the layer below ends; slice the "
                "model again"),
         "123"},
    };
}

std::vector<Row> of_programs() {
    const Phrase damaged =
        phrase("line %1: the program does not reach the core as it was read; start it again");
    return {
        {Id::program_has_writer, phrase("another program is being sent (process %1); wait for its end")},
        {Id::program_is_over, phrase("the core takes no more of this program; start it again")},
        {Id::program_ring_full, phrase("the core did not take the program's next step in time")},
        {Id::program_ring_damaged,
         phrase("the program does not reach the core as it was read; start it again")},
        {Id::program_record_torn, damaged},
        {Id::program_record_foreign, damaged, "1"},
        {Id::program_record_out_of_order, damaged, "1"},
        {Id::program_record_unknown,
         phrase("line %1: the core does not know what this line asks for; is it another version?"), "1"},
        {Id::program_number_not_finite, damaged},
        {Id::program_time_out_of_range,
         phrase("line %1: it would take more than %2 ms; change its feed or its dwell")},
        {Id::program_tolerance_out_of_range,
         phrase("line %1: the tolerance %2 is not between 0 and %3; change the P of G64")},
        {Id::program_outside_travel,
         phrase("line %1: %2 would come to %3, its travel is %4 to %5; move the work offset")},
        {Id::program_inside_core_radius,
         phrase("line %1: %2 would come to %3, inside the core radius of %4; carve less deep")},
        {Id::program_cannot_count_so_far, phrase("line %1: %2 cannot count so far")},
        {Id::program_tips_too_close,
         phrase("line %1: the tips would be %2 apart, closer than head_clearance_mm, %3; carve less deep")},
        {Id::program_tips_pass_too_close,
         phrase(
             "line %1: the tips, %2 apart at one end, would pass each other closer than head_clearance_mm, "
             "%3; move one head after the other")},
        {Id::program_goes_on_after_end, phrase("line %1: the program goes on after its end")},
        {Id::program_lost,
         phrase("the program breaks off behind line %1: who read it is gone; start it again")},
        {Id::program_arc_unsound,
         phrase("line %1: its ends are not as far from the arc's centre as each other; start it again")},
        {Id::program_output_not_wired,
         phrase("line %1: %2 is not wired to any pin; give its pin in the profile")},
        {Id::program_start_moved, phrase("the machine has moved since the program was read; start it again")},
        {Id::no_such_program, phrase("program %1 is not the one that waits to be run; start it again")},
    };
}

std::optional<Row> row_of(Id id) {
    for (const auto& rows : {of_commands(), of_motion(), of_jobs(), of_outputs_and_records(), of_asking(),
                             of_published_jobs(), of_tables(), of_programs()}) {
        const auto found = std::ranges::find(rows, id, &Row::id);
        if (found != rows.end()) return *found;
    }
    return std::nullopt;
}

Phrase way_out(MachineState state) {
    using S = MachineState;
    switch (state) {
        case S::off:
            return phrase("home first");
        case S::ready:
            return phrase("start first");
        case S::waiting:
            return phrase("start, or stop");
        case S::held:
            return phrase("resume, or stop");
        case S::alarm:
            return phrase("reset the alarm first");
        default:
            return phrase("wait, or stop");
    }
}

/// As the window writes it: it counts layers and points from 1, the core from 0.
std::string shown_argument(const Argument& argument, const std::string& words) {
    switch (argument.kind) {
        case ArgumentKind::axis:
            return axis_letter(static_cast<Axis>(argument.bits));
        case ArgumentKind::layer:
        case ArgumentKind::point:
            return std::to_string(argument.bits + 1);
        default:
            return words;
    }
}

/// What an error without a message says, without "hold: " and the like.
std::string_view without_command(std::string_view reason) {
    for (std::uint32_t k = 0; k < kCommandKindCount; ++k) {
        const std::string_view name = name_of(static_cast<CommandKind>(k));
        if (reason.starts_with(name) && reason.substr(name.size()).starts_with(": "))
            return reason.substr(name.size() + 2);
    }
    return reason;
}

}  // namespace

Phrase message_phrase(const psicarve::Message& message) {
    const auto row = row_of(message.id);
    if (!row || !is_sound(message)) return phrase("%1", in_words(message));
    Phrase shown = row->shown;
    const std::vector<std::string> words = argument_words(message);
    const std::string_view order{row->order};
    if (order == kAllButCommands) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (message.arguments[i].kind != ArgumentKind::command)
                shown.arguments.push_back(shown_argument(message.arguments[i], words[i]));
        }
    } else {
        for (const char which : order) {
            const auto i = static_cast<std::size_t>(which - '1');
            shown.arguments.push_back(shown_argument(message.arguments[i], words[i]));
        }
    }
    if (message.id == Id::wrong_state)
        shown.inner.push_back(way_out(static_cast<MachineState>(message.arguments[2].bits)));
    return shown;
}

Phrase core_phrase(const Error& error) {
    if (is_sound(error.said)) return message_phrase(error.said);
    return phrase("%1", without_command(error.message));
}

}  // namespace psicarve::session
