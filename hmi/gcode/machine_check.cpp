// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/machine_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hmi/gcode/arc.hpp"
#include "hmi/gcode/switched_outputs.hpp"
#include "shared/base/units.hpp"
#include "shared/program/motion_record.hpp"

namespace psicarve::gcode {
namespace {

ArcExtents extents_of(const CanonRecord& record) noexcept {
    const Plane& plane = *record.plane;
    return arc_extents({record.start[plane.first], record.start[plane.second]},
                       {record.end[plane.first], record.end[plane.second]},
                       {record.centre_first_mm, record.centre_second_mm}, record.turns);
}

/// Whether the record brings the axis to a place that has not been judged yet.
bool is_new_place(const CanonRecord& record, std::size_t letter) noexcept {
    if ((record.placed & mask_of(letter)) == 0) return false;
    return (record.start_placed & mask_of(letter)) == 0 || record.start[letter] != record.end[letter];
}

}  // namespace

MachineCheck::MachineCheck(const Profile& profile, ProblemList& problems)
    : problems_(problems),
      letters_(profile.gcode),
      stepped_(profile),
      wired_outputs_(wired_outputs(profile)),
      axes_{{{Axis::r1, axis_motion(profile, Axis::r1), core_radius_pulses(profile, Axis::r1), "r1"},
             {Axis::r2, axis_motion(profile, Axis::r2), core_radius_pulses(profile, Axis::r2), "r2"},
             {Axis::y, axis_motion(profile, Axis::y), 0, "y"}}},
      tips_mm_(profile.r1.tip_mm() + profile.r2.tip_mm()),
      clearance_mm_(profile.head_clearance_mm) {}

Position MachineCheck::reference_of(const Profile& profile) noexcept {
    const AxisLetters letters{profile.gcode};
    Position reference{};
    reference[letters.letter_of(Axis::r2)] = profile.r2.home_position_mm;
    reference[letters.letter_of(Axis::r1)] = profile.r1.home_position_mm;
    reference[letters.letter_of(Axis::y)] = profile.y.home_position_mm;
    reference[letters.letter_of(Axis::psi)] = profile.psi.home_position_deg;
    return reference;
}

void MachineCheck::refuse(const CanonRecord& record, ProblemCode code, Phrase what) {
    is_way_refused_ = is_way_refused_ || record.is_drawn;
    problems_.add({record.line, record.column, code, std::move(what)});
}

void MachineCheck::take(const CanonRecord& record) {
    // What is wrong with a drawn way is told once.
    is_way_refused_ = is_way_refused_ && record.begins_within;
    if (is_way_refused_) return;
    if (const char* const why = stepped_.why_not(record); *why != '\0')
        problems_.count(record.line, record.column, ProblemCode::not_stepped, why);
    switch (record.kind) {
        case CanonKind::rapid:
        case CanonKind::feed:
            return judge_motion(record);
        case CanonKind::arc:
            return judge_arc(record);
        default:
            return judge_switches(record);
    }
}

void MachineCheck::judge_switches(const CanonRecord& record) {
    if (record.kind == CanonKind::spindle && record.code == 4)
        refuse(record, ProblemCode::spindle_reverse, phrase("M4: the machine's spindle does not turn back"));
    if (record.kind == CanonKind::speed)
        refuse(record, ProblemCode::speed_unused, phrase("S: the machine's spindle is only switched"));
    if (record.kind == CanonKind::coolant && record.code != 9) judge_coolant(record);
    if (record.kind == CanonKind::dwell) (void)lasts_no_day(record, record.value);
    if (record.kind == CanonKind::override_set) judge_override(record);
    if (record.kind == CanonKind::path) judge_tolerance(record);
    const bool is_missing = record.kind == CanonKind::output && (outputs_of(record) & wired_outputs_) == 0;
    if (is_missing || record.kind == CanonKind::input)
        refuse(record, ProblemCode::output_missing,
               phrase("%1: the machine has no such output or input", "M" + std::to_string(record.code)));
}

void MachineCheck::judge_coolant(const CanonRecord& record) {
    if ((outputs_of(record) & wired_outputs_) != 0) return;
    constexpr SwitchedOutputs kCoolant = switched_bit(Signal::mist) | switched_bit(Signal::flood);
    if ((wired_outputs_ & kCoolant) == 0)
        return refuse(record, ProblemCode::coolant_unused, phrase("the machine has no output for coolant"));
    refuse(record, ProblemCode::coolant_unused,
           record.code == 7 ? phrase("the machine has no output for mist")
                            : phrase("the machine has no output for flood"));
}

/// What asks for the state that holds here anyway is right: no switch is wired, and the operator may always
/// change the feed.
void MachineCheck::judge_override(const CanonRecord& record) {
    const std::string name = "M" + std::to_string(record.code);
    const bool is_on = record.value != 0.0;
    if (record.code == 49 || (record.code == 50 && !is_on))
        refuse(record, ProblemCode::override_kept,
               phrase("%1 would take the feed's override from the operator", name));
    if ((record.code == 52 || record.code == 53) && is_on)
        refuse(record, ProblemCode::output_missing, phrase("%1: the machine has no input for it", name));
}

/// What lasts longer the core refuses, and only when the machine has come so far.
bool MachineCheck::lasts_no_day(const CanonRecord& record, double seconds) {
    if (!(seconds > kMostRecordSeconds)) return true;
    refuse(record, ProblemCode::out_of_range,
           phrase(record.kind == CanonKind::dwell ? "a dwell of %1 s; the machine takes %2 s, a day, at most"
                                                  : "a way of %1 s; the machine takes %2 s, a day, at most",
                  number_as("%.0f", seconds), number_as("%.0f", kMostRecordSeconds)));
    return false;
}

bool MachineCheck::is_way_in_time(const CanonRecord& record) {
    constexpr double kSecondsPerMinute = 60.0;
    if (!(record.feed_per_min > 0.0)) return true;
    return lasts_no_day(record, record.length / record.feed_per_min * kSecondsPerMinute);
}

void MachineCheck::judge_tolerance(const CanonRecord& record) {
    const ProfileBounds bounds = profile_bounds("job.path_tolerance_mm");
    if (record.value == 0.0 || bounds.hold(record.value)) return;
    refuse(record, ProblemCode::out_of_range,
           phrase("G64 P of %1 mm; the machine can have %2 to %3 mm", number_as("%g", record.value),
                  number_as("%g", bounds.least), number_as("%g", bounds.greatest)));
}

bool MachineCheck::has_only_our_letters(const CanonRecord& record) {
    for (std::size_t letter = 0; letter < kLetterCount; ++letter) {
        const bool is_foreign = (letters_.all() & mask_of(letter)) == 0;
        if (!is_foreign || record.start[letter] == record.end[letter]) continue;
        refuse(record, ProblemCode::axis_missing, phrase("the machine has no axis %1", kAxisLetters[letter]));
        return false;
    }
    return true;
}

void MachineCheck::judge_extents(const CanonRecord& record, const LinearAxis& axis, double least_mm,
                                 double most_mm) {
    const double per_mm = axis.motion.pulses_per_unit;
    const std::int64_t least = pulses_from_mm(least_mm, per_mm);
    const std::int64_t most = pulses_from_mm(most_mm, per_mm);
    if (least < axis.motion.travel_min_pulses || most > axis.motion.travel_max_pulses) {
        const bool is_low = least < axis.motion.travel_min_pulses;
        refuse(record, ProblemCode::outside_travel,
               phrase("%1 comes to %2 mm, its travel is %3 mm to %4 mm", axis.name,
                      mm_text(is_low ? least_mm : most_mm),
                      mm_text(mm_from_pulses(axis.motion.travel_min_pulses, per_mm)),
                      mm_text(mm_from_pulses(axis.motion.travel_max_pulses, per_mm))));
    } else if (axis.axis != Axis::y && least < axis.core_pulses) {
        refuse(record, ProblemCode::core_radius,
               phrase("%1 comes to %2 mm, and the core that it must not reach ends at %3 mm", axis.name,
                      mm_text(least_mm), mm_text(mm_from_pulses(axis.core_pulses, per_mm))));
    }
}

void MachineCheck::judge_tips(const CanonRecord& record) {
    const std::size_t first = letters_.letter_of(Axis::r1);
    const std::size_t second = letters_.letter_of(Axis::r2);
    const AxisMask both = letters_.of_heads();
    if ((record.placed & both) != both) return;
    if (!is_new_place(record, first) && !is_new_place(record, second)) return;
    const double apart_mm = record.end[first] + record.end[second] + tips_mm_;
    // Half a micrometre, less than a pulse: sums of decimal numbers are not exact.
    if (apart_mm >= clearance_mm_ - 0.0005) return;
    refuse(record, ProblemCode::heads_meet,
           phrase("the tips of r1 and r2 are %1 mm apart, closer than head_clearance_mm = %2 mm",
                  mm_text(apart_mm), mm_text(clearance_mm_)));
}

void MachineCheck::judge_end(const CanonRecord& record, const LinearAxis& axis) {
    const std::size_t letter = letters_.letter_of(axis.axis);
    if (!is_new_place(record, letter)) return;
    judge_extents(record, axis, record.end[letter], record.end[letter]);
}

void MachineCheck::judge_motion(const CanonRecord& record) {
    if (!is_way_in_time(record)) return;
    if (!has_only_our_letters(record)) return;
    for (const LinearAxis& axis : axes_) judge_end(record, axis);
    judge_tips(record);
}

void MachineCheck::judge_arc(const CanonRecord& record) {
    if (!is_way_in_time(record)) return;
    if (!has_only_our_letters(record)) return;
    const Plane& plane = *record.plane;
    if (!letters_.has_arcs_in(plane))
        return refuse(record, ProblemCode::arc_axes,
                      phrase("an arc in %1 does not move Y and one head", plane.name));
    const AxisMask both = static_cast<AxisMask>(mask_of(plane.first) | mask_of(plane.second));
    const bool is_reach_known = (record.start_placed & record.placed & both) == both;
    const ArcExtents found = extents_of(record);
    for (const LinearAxis& axis : axes_) {
        const std::size_t letter = letters_.letter_of(axis.axis);
        // Where its reach is not known, its end is.
        if (!is_reach_known || (both & mask_of(letter)) == 0) {
            judge_end(record, axis);
        } else {
            const std::size_t which = letter == plane.first ? 0 : 1;
            judge_extents(record, axis, found.least_mm[which], found.most_mm[which]);
        }
    }
    judge_tips(record);
}

}  // namespace psicarve::gcode
