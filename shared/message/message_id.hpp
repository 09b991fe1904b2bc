// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve {

/// What a message says. Numbers and names are for good: one that is given up is never used again, for
/// programs, journals and older segments have it. docs/messages.md lists them with their words.
enum class MessageId : std::uint16_t {
    none = 0,  ///< there is no message

    // What the core answers to any command.
    refused = 1,
    no_reason = 2,
    unknown_command = 3,
    wrong_state = 4,
    no_alarm = 5,
    output_tested = 6,
    no_job = 7,
    not_homed = 8,
    overtaken = 9,
    replaying = 10,
    core_replaced = 11,
    not_at_rest = 12,

    // Alarms, sensors, the port.
    switch_was_tripped = 20,
    still_tripped = 21,
    sensor_not_tripped = 22,
    no_sensor = 23,
    port_failed = 24,
    port_reset_first = 25,
    guard_ended = 26,
    no_such_sensor = 27,
    heads_not_homed = 28,

    // Motion by hand.
    heads_too_close = 40,
    inside_core_radius = 41,
    at_the_end = 42,
    cannot_count_so_far = 43,
    outside_travel = 44,
    beyond_limits = 45,
    too_far = 46,
    centre_too_far = 47,
    no_jog_axis = 48,
    jog_speed_not_positive = 49,
    jog_unleased = 50,
    speed_limited = 51,
    speed_limited_turning = 52,
    no_move_axis = 53,
    unknown_shape = 54,
    arc_axes = 55,
    arc_scales_differ = 56,
    not_an_arc = 57,
    stepped_axes = 58,

    // Starting, and going on.
    no_such_layer = 70,
    no_such_first_layer = 71,
    layers_not_whole = 72,
    job_looked_at = 73,
    nothing_carved = 74,
    checkpoint_damaged = 75,
    checkpoint_of_other_job = 76,
    no_layer_finished = 77,
    no_layer_finished_but_earlier = 78,
    carved_to_its_end = 79,
    bad_override = 80,
    bad_rapid_override = 81,
    no_program_runs = 82,
    no_such_point = 83,
    no_program_for_optional_stop = 84,

    // Outputs by hand, recordings, records of pieces.
    pins_need_drives_off = 90,
    no_such_output = 91,
    output_not_wired = 92,
    pins_unleased = 93,
    pins_pulse_bounds = 94,
    recording_taken = 95,
    no_recording_form = 96,
    forget_not_at_rest = 97,
    record_of_other_kind = 98,
    record_is_another = 99,
    forget_disk_silent = 100,

    // What the operator's side finds when it asks.
    no_core = 120,
    no_core_for_command = 121,
    core_silent = 122,
    core_ended = 123,
    no_answer_in_time = 124,
    slots_in_use = 125,
    alarm = 126,
    alarm_of_axis = 127,
    stopped_by_somebody = 128,
    still_in_state = 129,

    // What the core, and a publisher, say of a published job.
    job_unsound = 140,
    job_for_other_machine = 141,
    blank_too_wide = 142,
    blank_beside = 143,
    blank_beside_in_the_way = 144,
    blank_radius_differs = 145,
    blank_radius_in_the_way = 146,
    blank_height_differs = 147,
    blank_height_in_the_way = 148,
    begun_with_other_profile = 149,
    segment_and_disk_disagree = 150,
    busy_for_a_job = 151,
    job_runs = 152,
    other_job_published = 153,
    job_refused_without_reason = 154,
    published_without_core = 155,
    job_not_judged = 156,
    published_by_nobody = 157,
    published_too_large = 158,
    published_checksum_wrong = 159,

    // What of a job this machine cannot carve.
    sweep_of_other_machine = 170,
    more_points_than_pulses = 171,
    direction_reversed = 172,
    radius_inside_core = 173,
    radius_below_travel = 174,
    radius_above_travel = 175,
    tips_too_close = 176,
    height_outside_travel = 177,
    ring_not_closed = 178,
    layer_not_higher = 179,
    spiral_not_joined = 180,

    // What of a program, record by record, the core does not take, and who may write one.
    program_has_writer = 200,
    program_is_over = 201,
    program_ring_full = 202,
    program_ring_damaged = 203,
    program_record_torn = 204,
    program_record_foreign = 205,
    program_record_out_of_order = 206,
    program_record_unknown = 207,
    program_number_not_finite = 208,
    program_time_out_of_range = 209,
    program_tolerance_out_of_range = 210,
    program_outside_travel = 211,
    program_inside_core_radius = 212,
    program_cannot_count_so_far = 213,
    program_tips_too_close = 214,
    program_tips_pass_too_close = 215,
    program_goes_on_after_end = 216,
    program_lost = 217,
    no_such_program = 218,
    program_start_moved = 219,
    program_arc_unsound = 220,
    program_output_not_wired = 221,
};

}  // namespace psicarve
