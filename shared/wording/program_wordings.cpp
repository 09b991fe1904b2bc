// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "shared/wording/wording_tables.hpp"

namespace psicarve {
namespace {

using Id = MessageId;
using K = ArgumentKind;

constexpr ArgumentName kProgramLine{K::count, "line"};
constexpr ArgumentName kProgramAxis{K::axis, "axis"};
constexpr ArgumentName kProgramPosition{K::mm, "position_mm"};
constexpr ArgumentName kTipsApart{K::mm, "apart_mm"};
constexpr ArgumentName kTipClearance{K::mm, "head_clearance_mm"};

constexpr const char* kAgain = "start the program again";

constexpr std::array kProgramWordings{
    Wording{Id::program_has_writer,
            "program_has_writer",
            "process %1 is writing a program",
            "wait for its end, or end that process",
            {{K::count, "pid"}}},
    Wording{Id::program_is_over, "program_is_over", "the core takes no more of this program", kAgain, {}},
    Wording{Id::program_ring_full,
            "program_ring_full",
            "the core has not taken enough of the program in time for one record more",
            "",
            {}},
    Wording{Id::program_ring_damaged,
            "program_ring_damaged",
            "the words of the program's queue are overwritten",
            kAgain,
            {}},
    Wording{Id::program_record_torn,
            "program_record_torn",
            "the record behind line %1 is damaged: its check does not bear it out",
            kAgain,
            {kProgramLine}},
    Wording{Id::program_record_foreign,
            "program_record_foreign",
            "line %1: the record is of program %2, and program %3 is running",
            kAgain,
            {kProgramLine, {K::count, "program"}, {K::count, "running"}}},
    Wording{Id::program_record_out_of_order,
            "program_record_out_of_order",
            "line %1: the record has the number %2, and %3 was to come",
            kAgain,
            {kProgramLine, {K::count, "sequence"}, {K::count, "expected"}}},
    Wording{Id::program_record_unknown,
            "program_record_unknown",
            "line %1: the record of kind %2 says something that this core does not know",
            "are core and program reader of one version?",
            {kProgramLine, {K::count, "kind"}}},
    Wording{Id::program_number_not_finite,
            "program_number_not_finite",
            "line %1: the record has a number that is none",
            kAgain,
            {kProgramLine}},
    Wording{Id::program_time_out_of_range,
            "program_time_out_of_range",
            "line %1: a way or dwell takes no time below zero, and at most %2 ms",
            "change the line's feed, or its dwell",
            {kProgramLine, {K::ms, "most_ms"}}},
    Wording{Id::program_tolerance_out_of_range,
            "program_tolerance_out_of_range",
            "line %1: a tolerance of %2 is not between 0 and %3",
            "change the P of G64",
            {kProgramLine, {K::mm, "tolerance_mm"}, {K::mm, "most_mm"}}},
    Wording{Id::program_outside_travel,
            "program_outside_travel",
            "line %1: %2 would come to %3, its travel is %4 to %5",
            "move the work offset, or the part",
            {kProgramLine, kProgramAxis, kProgramPosition, {K::mm, "from_mm"}, {K::mm, "to_mm"}},
            4},
    Wording{Id::program_inside_core_radius,
            "program_inside_core_radius",
            "line %1: %2 would come to %3, inside the core radius, which ends at %4",
            "carve less deep, or lower core_radius_mm",
            {kProgramLine, kProgramAxis, kProgramPosition, {K::mm, "core_mm"}},
            4},
    Wording{Id::program_cannot_count_so_far,
            "program_cannot_count_so_far",
            "line %1: %2 cannot count so far",
            "",
            {kProgramLine, kProgramAxis}},
    Wording{Id::program_tips_too_close,
            "program_tips_too_close",
            "line %1: the tips of r1 and r2 would be %2 apart, closer than head_clearance_mm = %3",
            "carve less deep with one of the heads",
            {kProgramLine, kTipsApart, kTipClearance},
            4},
    Wording{Id::program_tips_pass_too_close,
            "program_tips_pass_too_close",
            "line %1: one head goes in while the other goes out, and their tips, %2 apart at one end, would "
            "come a pulse closer than head_clearance_mm = %3 on the way",
            "move one head after the other, or carve less deep",
            {kProgramLine, kTipsApart, kTipClearance},
            4},
    Wording{Id::program_goes_on_after_end,
            "program_goes_on_after_end",
            "line %1: a record comes after the program's end",
            kAgain,
            {kProgramLine}},
    Wording{Id::program_lost,
            "program_lost",
            "the program breaks off behind line %1: who read it is gone, without its end",
            kAgain,
            {kProgramLine}},
    Wording{Id::no_such_program,
            "no_such_program",
            "program %1 is not the one that waits to be run",
            kAgain,
            {{K::count, "program"}}},
    Wording{Id::program_start_moved,
            "program_start_moved",
            "the machine has moved since the program was read",
            kAgain,
            {}},
    Wording{
        Id::program_arc_unsound,
        "program_arc_unsound",
        "line %1: no arc to step along: its head and y have as many pulses per mm, and its ends are as far "
        "from the centre as each other, to a pulse, 2 pulses or more",
        kAgain,
        {kProgramLine}},
    Wording{Id::program_output_not_wired,
            "program_output_not_wired",
            "line %1: %2 is not wired to any pin",
            "give its pin in [port.pins] of the profile, and start the core and the program again",
            {kProgramLine, {K::signal, "output"}}},
};

}  // namespace

std::span<const Wording> program_wordings() noexcept {
    return kProgramWordings;
}

}  // namespace psicarve
