// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/program/way_reader.hpp"

#include <bit>
#include <cmath>
#include <utility>

#include "hmi/gcode/arc.hpp"
#include "hmi/gcode/arc_chords.hpp"
#include "hmi/gcode/switched_outputs.hpp"
#include "shared/base/units.hpp"

namespace psicarve::verify {
namespace {

using gcode::CanonKind;
using gcode::CanonRecord;

constexpr double kSecondsPerMinute = 60.0;
constexpr int kBlendCode = 640;
constexpr int kSpindleOffCode = 5;
/// An arc's steps are within a pulse of a circle in whole pulses: its centre, too, is rounded.
constexpr double kSteppedArcSlackPulses = 2.5;
constexpr int kOptionalStopCode = 1;

bool is_motion(const CanonRecord& record) noexcept {
    return record.kind == CanonKind::rapid || record.kind == CanonKind::feed || record.kind == CanonKind::arc;
}

/// Whether the machine rests for it, whatever the operator has chosen.
bool asks_for_rest(const CanonRecord& record, SwitchedOutputs wired) noexcept {
    switch (record.kind) {
        case CanonKind::dwell:
        case CanonKind::spindle:
        case CanonKind::tool_change:
        case CanonKind::end:
            return true;
        case CanonKind::stop:
            return record.code != kOptionalStopCode;
        case CanonKind::coolant:
        case CanonKind::output:
            return (gcode::outputs_of(record) & wired) != 0;
        default:
            return false;
    }
}

Place rounded(const Place& place) noexcept {
    Place whole;
    for (std::size_t k = 0; k < kAxisCount; ++k) whole[k] = static_cast<double>(round_to_pulse(place[k]));
    return whole;
}

gcode::InterpreterOptions language_from(const JudgedProgram& program, const gcode::AxisLetters& letters,
                                        const WayScale& scale, const Positions& start) {
    gcode::InterpreterOptions language = program.language;
    language.is_start_known = true;
    // r1 last: where r2 follows it, one letter stands for both.
    for (const Axis axis : {Axis::r2, Axis::psi, Axis::y, Axis::r1})
        language.start[letters.letter_of(axis)] =
            static_cast<double>(start[index_of(axis)]) / scale.pulses_per_unit[index_of(axis)];
    return language;
}

}  // namespace

WayReader::WayReader(const JudgedProgram& program, const Profile& profile, const WayScale& scale,
                     const Positions& start)
    : stream_(program.open, language_from(program, gcode::AxisLetters{profile.gcode}, scale, start), profile),
      scale_(scale),
      letters_(profile.gcode),
      stepped_(profile),
      turns_shortest_(profile.gcode.turns_shortest),
      wired_outputs_(wired_outputs(profile)),
      own_tolerance_mm_(profile.job.path_tolerance_mm),
      tolerance_mm_(profile.job.path_tolerance_mm),
      at_{} {
    for (std::size_t k = 0; k < kAxisCount; ++k) at_[k] = static_cast<double>(start[k]);
    switches_.judged = levels_of(wired_outputs_);
}

std::optional<WayDemand> WayReader::next() {
    while (auto record = stream_.next()) {
        if (is_motion(*record)) {
            auto way = way_of(*record);
            if (!way) continue;
            // It begins at rest.
            if (held_ && way->is_stepped) held_->is_exact = true;
            std::swap(held_, way);
            if (way) return way;
            continue;
        }
        if (asks_for_rest(*record, wired_outputs_)) rest(*record);
        note_mode(*record);
        note_switch(*record);
    }
    return std::exchange(held_, std::nullopt);
}

void WayReader::pass_rest() {
    while (stream_.next()) {
    }
}

void WayReader::rest(const CanonRecord& record) {
    if (!held_) return;
    held_->is_exact = true;
    held_->asks_for_rest = true;
    if (record.kind == CanonKind::dwell) held_->dwell_s += record.value;
}

void WayReader::note_mode(const CanonRecord& record) noexcept {
    if (record.kind == CanonKind::path) {
        is_exact_ = record.code != kBlendCode;
        tolerance_mm_ = record.value > 0.0 ? record.value : own_tolerance_mm_;
    }
}

void WayReader::note_switch(const CanonRecord& record) {
    if (record.kind == CanonKind::spindle)
        turn(bit_of(Signal::spindle), record.code != kSpindleOffCode, record.line);
    if (record.kind == CanonKind::coolant || record.kind == CanonKind::output)
        turn(levels_of(gcode::outputs_of(record) & wired_outputs_), gcode::switches_on(record), record.line);
    if (record.kind == CanonKind::end) turn(bit_of(Signal::spindle) | kSwitchedMask, false, record.line);
}

void WayReader::turn(SignalWord wires, bool is_on, std::uint64_t line) {
    if (held_) held_->switches.turned_behind |= wires;
    switches_.judged |= wires & ~kSwitchedMask;
    switches_.on = is_on ? switches_.on | wires : switches_.on & ~wires;
    for (SignalWord left = wires; left != 0; left &= left - 1)
        switches_.lines[index_of_switch(static_cast<Signal>(std::countr_zero(left)))] = line;
}

/// Nothing: no axis has a pulse to go.
std::optional<WayDemand> WayReader::way_of(const CanonRecord& record) {
    const std::size_t psi_letter = letters_.letter_of(Axis::psi);
    const auto psi_mask = letters_.mask_of_axis(Axis::psi);
    if (turns_shortest_ && record.kind == CanonKind::rapid && !record.is_drawn &&
        (record.start_placed & record.placed & psi_mask) != 0) {
        const double turned_deg = record.end[psi_letter] - record.start[psi_letter];
        psi_shift_deg_ += std::remainder(turned_deg, kDegPerRev) - turned_deg;
    }
    const Place to = place_of(at_, record.placed, record.end);
    const Place from = std::exchange(at_, to);
    const double seconds =
        record.feed_per_min > 0.0 ? record.length / record.feed_per_min * kSecondsPerMinute : 0.0;
    const double share = stepped_share(record, from, to);
    if (share <= 0.0) {
        without_pulse_s_ += seconds;
        return std::nullopt;
    }
    const auto arc = arc_of(record);
    WayDemand demand{.way = ProgrammedWay{scale_, from, to, arc}, .line = record.line};
    demand.time = {seconds, share * seconds, std::exchange(without_pulse_s_, 0.0)};
    demand.is_exact = is_exact_ && !record.ends_within;
    const bool has_corners = arc || record.begins_within || record.ends_within;
    demand.tolerance_mm = is_exact_ && !has_corners ? 0.0 : tolerance_mm_;
    // Chords of what is drawn have used up their share of it.
    if (record.is_drawn) demand.tolerance_mm *= 1.0 - gcode::kChordShare;
    const bool is_stepped_arc = stepped_.arc(record).has_value();
    demand.is_stepped = is_stepped_arc || stepped_.line_axes(record, letters_.all()) != 0;
    if (demand.is_stepped) {
        demand.is_exact = true;
        demand.tolerance_mm = 0.0;
    }
    if (is_stepped_arc) demand.slack_pulses = kSteppedArcSlackPulses;
    demand.switches = switches_;
    demand.goes_on = record.begins_within;
    return demand;
}

Place WayReader::place_of(const Place& from, gcode::AxisMask placed,
                          const gcode::Position& at) const noexcept {
    Place place = from;
    for (const Axis axis : kAllAxes) {
        const std::size_t letter = letters_.letter_of(axis);
        if ((placed & gcode::mask_of(letter)) == 0) continue;
        const double shift = axis == Axis::psi ? psi_shift_deg_ : 0.0;
        place[index_of(axis)] = scale_.pulses(axis, at[letter] + shift);
    }
    return place;
}

/// How long the way is in whole pulses, as a share of its length; 0: no axis has a pulse to go.
double WayReader::stepped_share(const CanonRecord& record, const Place& from, const Place& to) const {
    if (record.kind == CanonKind::arc) return stepped_.arc(record) ? 1.0 : share_on_chords(record, from);
    const double stepped = scale_.seconds_along(rounded(from), rounded(to));
    const double length = scale_.seconds_along(from, to);
    return stepped > 0.0 && length > 0.0 ? stepped / length : 0.0;
}

/// An arc's time is shared out among chords evenly.
double WayReader::share_on_chords(const CanonRecord& record, const Place& from) const {
    const gcode::ArcChords chords{record, gcode::kChordShare * tolerance_mm_};
    Place before = from;
    double share = 0.0;
    for (std::uint64_t n = 1; n <= chords.count(); ++n) {
        const Place place = place_of(from, record.placed, chords.end_of(n));
        const double length = scale_.seconds_along(before, place);
        if (length > 0.0) share += scale_.seconds_along(rounded(before), rounded(place)) / length;
        before = place;
    }
    return share / static_cast<double>(chords.count());
}

std::optional<WayArc> WayReader::arc_of(const CanonRecord& record) const {
    if (record.kind != CanonKind::arc) return std::nullopt;
    const gcode::Plane& plane = *record.plane;
    const gcode::PlanePoint from{record.start[plane.first], record.start[plane.second]};
    const gcode::PlanePoint to{record.end[plane.first], record.end[plane.second]};
    const gcode::PlanePoint centre{record.centre_first_mm, record.centre_second_mm};
    const auto radius_mm = [&](const gcode::PlanePoint& point) {
        return std::hypot(point.first_mm - centre.first_mm, point.second_mm - centre.second_mm);
    };
    const double first_mm = from.first_mm - centre.first_mm;
    const double second_mm = from.second_mm - centre.second_mm;
    const double sweep_rad = gcode::sweep_rad(from, to, centre, record.turns);
    const bool is_y_first = plane.first == letters_.letter_of(Axis::y);
    const std::size_t head_letter = is_y_first ? plane.second : plane.first;
    WayArc arc{};
    for (std::size_t head = 0; head < kHeadCount; ++head)
        arc.moves_head[head] = letters_.letter_of(kHeads[head]) == head_letter;
    arc.start_radius_mm = radius_mm(from);
    arc.end_radius_mm = radius_mm(to);
    // From R to Y, whichever of the two stands first in the plane.
    arc.centre_r_mm = is_y_first ? centre.second_mm : centre.first_mm;
    arc.centre_y_mm = is_y_first ? centre.first_mm : centre.second_mm;
    arc.start_rad = is_y_first ? std::atan2(first_mm, second_mm) : std::atan2(second_mm, first_mm);
    arc.sweep_rad = is_y_first ? -sweep_rad : sweep_rad;
    return arc;
}

}  // namespace psicarve::verify
