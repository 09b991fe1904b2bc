// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/record_maker.hpp"

#include <cmath>
#include <string>

#include "hmi/gcode/approach.hpp"
#include "hmi/gcode/arc_chords.hpp"
#include "hmi/gcode/switched_outputs.hpp"
#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

constexpr double kSecondsPerMinute = 60.0;

double furthest_out_mm(const Profile& profile, Axis head) {
    const AxisMotion motion = axis_motion(profile, head);
    return mm_from_pulses(motion.travel_max_pulses, motion.pulses_per_unit);
}

bool is_motion(const CanonRecord& record) noexcept {
    return record.kind == CanonKind::rapid || record.kind == CanonKind::feed || record.kind == CanonKind::arc;
}

}  // namespace

RecordMaker::RecordMaker(const Profile& profile, const RunOptions& options, RecordSink& sink) noexcept
    : options_(options),
      outlet_(options.program, sink),
      letters_(profile.gcode),
      stepped_(profile),
      turns_shortest_(profile.gcode.turns_shortest),
      out_mm_{furthest_out_mm(profile, Axis::r1), furthest_out_mm(profile, Axis::r2)},
      own_tolerance_mm_(profile.job.path_tolerance_mm),
      wired_outputs_(wired_outputs(profile)),
      tolerance_mm_(profile.job.path_tolerance_mm),
      has_come_(options.from_line <= 1) {}

void RecordMaker::begin_line(const ReachedLine& line) {
    has_come_ = has_come_ || line.is_at_or_behind(options_.from_line);
}

void RecordMaker::take(const CanonRecord& record) {
    if (outlet_.has_failed()) return;
    if (!has_begun_ && has_come_) begin(record);
    if (turns_shortest_ && record.kind == CanonKind::rapid && !record.is_drawn) shorten_turn(record);
    if (has_begun_) carry_out(record);
    note(record);
}

Result<void> RecordMaker::finish() {
    if (!has_begun_ && options_.from_line > 1) outlet_.fail(ends_before(options_.from_line));
    if (!has_ended_) put(MotionKind::end, line_, 0, 0.0);
    outlet_.flush();
    if (outlet_.failure()) return *outlet_.failure();
    return {};
}

void RecordMaker::begin(const CanonRecord& record) {
    has_begun_ = true;
    const bool is_within = has_moved_ || is_spindle_on_ || outputs_on_ != 0;
    const std::uint64_t line = is_within ? options_.from_line : record.line;
    if (is_within) approach(line);
    if (options_.is_dry && !has_moved_) put_heads_out(line);
    outlet_.end_block();
}

/// From here on psi is counted so that it has at most half a turn to go.
void RecordMaker::shorten_turn(const CanonRecord& record) noexcept {
    if ((record.start_placed & record.placed & letters_.mask_of_axis(Axis::psi)) == 0) return;
    const double turned_deg = turn_deg(record);
    psi_shift_deg_ -= turned_deg - std::remainder(turned_deg, kDegPerRev);
}

double RecordMaker::turn_deg(const CanonRecord& record) const noexcept {
    const std::size_t letter = letters_.letter_of(Axis::psi);
    return record.end[letter] - record.start[letter];
}

/// Whether whole turns are all that the rapid way asks of psi, and it need not do them.
bool RecordMaker::stays_turned(const CanonRecord& record) const noexcept {
    return turns_shortest_ && !record.is_drawn &&
           (record.start_placed & letters_.mask_of_axis(Axis::psi)) != 0 &&
           std::remainder(turn_deg(record), kDegPerRev) == 0.0;
}

/// To where the program stands by now, from anywhere.
void RecordMaker::approach(std::uint64_t line) {
    if (is_spindle_on_ && !options_.is_dry) put(MotionKind::spindle, line, 1, 0.0);
    put_outputs(line, outputs_on_, true);
    if (!has_moved_) return;
    put_heads_out(line);
    for (const AxisMask letters :
         {letters_.mask_of_axis(Axis::psi), letters_.mask_of_axis(Axis::y), letters_.of_heads()})
        put_way(line, place_, static_cast<AxisMask>(letters & placed_ & moving_letters()), 0.0, 0.0, true);
}

void RecordMaker::note(const CanonRecord& record) noexcept {
    line_ = record.line;
    if (record.kind == CanonKind::path) {
        is_exact_ = record.code != 640;
        tolerance_mm_ = record.value > 0.0 ? record.value : own_tolerance_mm_;
    }
    if (record.kind == CanonKind::spindle) is_spindle_on_ = record.code != 5;
    outputs_on_ = outputs_behind(record, outputs_on_, wired_outputs_);
    if (record.kind == CanonKind::end) has_ended_ = true;
    if (!is_motion(record)) return;
    place_ = record.end;
    placed_ = record.placed;
    has_moved_ = true;
}

void RecordMaker::carry_out(const CanonRecord& record) {
    switch (record.kind) {
        case CanonKind::rapid:
        case CanonKind::feed:
        case CanonKind::arc:
            if (can_move(record)) move(record);
            return;
        case CanonKind::dwell:
            return put(MotionKind::dwell, record.line, 0, record.value);
        case CanonKind::spindle:
            if (record.code == 4) return refuse(record, "the machine's spindle does not turn back");
            if (!options_.is_dry) put(MotionKind::spindle, record.line, record.code == 3 ? 1 : 0, 0.0);
            return;
        case CanonKind::tool_change:
            return put(MotionKind::stop, record.line, static_cast<std::uint8_t>(StopReason::tool_change),
                       0.0);
        case CanonKind::stop:
            return stop(record);
        case CanonKind::end:
            return put(MotionKind::end, record.line, 0, 0.0);
        case CanonKind::coolant:
        case CanonKind::output:
            return switch_outputs(record);
        case CanonKind::input:
            return refuse(record, "the machine has no such output or input");
        case CanonKind::path:
        case CanonKind::speed:
        case CanonKind::tool_select:
        case CanonKind::override_set:
            return;  // a mode, or MachineCheck has warned that it does nothing here
    }
}

void RecordMaker::stop(const CanonRecord& record) {
    StopReason reason = StopReason::program;
    if (record.code == 1) {
        if (!options_.stops_at_optional) return put_optional_stop(record.line);
        reason = options_.has_optional_stops ? StopReason::optional_at_rest : StopReason::optional;
    }
    put(MotionKind::stop, record.line, static_cast<std::uint8_t>(reason), 0.0);
}

/// Where nothing moves for it the way before it ends the block, as it would without it.
void RecordMaker::put_optional_stop(std::uint64_t line) {
    if (!options_.has_optional_stops) return;
    outlet_.end_block();
    put(MotionKind::stop, line, static_cast<std::uint8_t>(StopReason::optional_on_way), 0.0);
}

/// Whether a way can say it.
bool RecordMaker::can_move(const CanonRecord& record) {
    const AxisMask changed = changed_letters(record);
    AxisMask wanted = changed;
    if (record.kind == CanonKind::arc)
        for (const std::size_t letter : {record.plane->first, record.plane->second})
            wanted |= mask_of(letter);
    // A rapid way may come from anywhere; one with a feed has a length.
    const AxisMask unsaid = static_cast<AxisMask>(
        wanted & ~(record.kind == CanonKind::rapid ? record.placed : record.start_placed));
    for (std::size_t letter = 0; letter < kLetterCount; ++letter) {
        const std::string name{kAxisLetters[letter]};
        if ((changed & ~letters_.all() & mask_of(letter)) != 0 &&
            record.start[letter] != record.end[letter]) {
            refuse(record, "the machine has no axis " + name);
            return false;
        }
        if ((unsaid & letters_.all() & mask_of(letter)) == 0) continue;
        refuse(record, "it is not known where " + name + " begins");
        return false;
    }
    if (record.kind != CanonKind::arc || letters_.has_arcs_in(*record.plane)) return true;
    refuse(record, "an arc in " + std::string{record.plane->name} + " does not move Y and one head");
    return false;
}

AxisMask RecordMaker::moving_letters() const noexcept {
    const AxisMask all = letters_.all();
    return options_.is_dry ? static_cast<AxisMask>(all & ~letters_.of_heads()) : all;
}

void RecordMaker::move(const CanonRecord& record) {
    const double seconds =
        record.feed_per_min > 0.0 ? record.length / record.feed_per_min * kSecondsPerMinute : 0.0;
    if (move_by_steps(record, seconds)) return;
    // An arc that ends where it begins is a whole circle.
    if (record.kind == CanonKind::arc) return move_on_chords(record, seconds);
    AxisMask changed = changed_letters(record);
    if (record.kind == CanonKind::rapid && stays_turned(record))
        changed = static_cast<AxisMask>(changed & ~letters_.mask_of_axis(Axis::psi));
    if ((changed & moving_letters()) == 0) return;
    put_way(record.line, record.end, static_cast<AxisMask>(record.placed & moving_letters()), seconds,
            record.ends_within ? corner_tolerance_mm() : end_tolerance_mm(), record.kind == CanonKind::rapid);
}

/// Where the profile says so. A dry run moves y alone along what was an arc: as ever, on chords.
bool RecordMaker::move_by_steps(const CanonRecord& record, double seconds) {
    if (const auto arc = stepped_.arc(record); arc && !options_.is_dry) {
        put_arcs(record, *arc, seconds);
        return true;
    }
    const std::uint8_t axes = stepped_.line_axes(record, moving_letters());
    if (axes == 0) return false;
    MotionRecord way{};
    way.kind = MotionKind::way;
    way.line = record.line;
    way.axes = axes;
    way.flags = kIsStepped;
    way.seconds = seconds;
    for (const Axis axis : kAllAxes)
        if ((axes >> index_of(axis) & 1U) != 0)
            way.target[index_of(axis)] = record.end[letters_.letter_of(axis)];
    outlet_.put(way);
    return true;
}

/// A record for each turn, the one that is not whole last.
void RecordMaker::put_arcs(const CanonRecord& record, const SteppedArc& arc, double seconds) {
    MotionRecord turn{};
    turn.kind = MotionKind::arc;
    turn.line = record.line;
    turn.axes = static_cast<std::uint8_t>(1U << index_of(arc.head) | 1U << index_of(Axis::y));
    turn.code =
        static_cast<std::uint8_t>(arc.is_counterclockwise ? ArcSense::counterclockwise : ArcSense::clockwise);
    turn.centre_mm = arc.centre_mm;
    const auto put = [&](const Position& end, double turned_rad) {
        for (const Axis axis : {arc.head, Axis::y})
            turn.target[index_of(axis)] = end[letters_.letter_of(axis)];
        turn.seconds = seconds * turned_rad / arc.sweep_rad;
        outlet_.put(turn);
    };
    for (int n = 0; n < arc.whole_turns && wants_more(); ++n)
        put(arc.rest_rad > 0.0 ? record.start : record.end, 2.0 * kPi);
    if (arc.rest_rad > 0.0 && wants_more()) put(record.end, arc.rest_rad);
}

void RecordMaker::move_on_chords(const CanonRecord& record, double seconds) {
    const double chord_mm = kChordShare * tolerance_mm_;
    const double corner_mm = corner_tolerance_mm();
    const ArcChords chords{record, chord_mm};
    const AxisMask letters = static_cast<AxisMask>(record.placed & moving_letters());
    const double each_s = seconds / static_cast<double>(chords.count());
    for (std::uint64_t chord = 1; chord <= chords.count() && wants_more(); ++chord) {
        put_way(record.line, chords.end_of(chord), letters, each_s, corner_mm, false);
    }
    // Not the last chord itself: before an exact way the machine rests.
    if (is_exact_ && wants_more()) put_way(record.line, record.end, letters, 0.0, 0.0, false);
}

double RecordMaker::corner_tolerance_mm() const noexcept {
    return tolerance_mm_ - kChordShare * tolerance_mm_;
}

void RecordMaker::put_way(std::uint64_t line, const Position& end, AxisMask letters, double seconds,
                          double tolerance_mm, bool is_rapid) {
    MotionRecord way{};
    way.kind = MotionKind::way;
    way.line = line;
    way.flags = is_rapid ? kIsRapid : 0;
    way.seconds = seconds;
    way.tolerance_mm = tolerance_mm;
    for (const Axis axis : kAllAxes) {
        const std::size_t letter = letters_.letter_of(axis);
        if ((letters & mask_of(letter)) == 0) continue;
        way.axes = static_cast<std::uint8_t>(way.axes | 1U << index_of(axis));
        way.target[index_of(axis)] = axis == Axis::psi ? end[letter] + psi_shift_deg_ : end[letter];
    }
    if (way.axes != 0) outlet_.put(way);
}

void RecordMaker::put_heads_out(std::uint64_t line) {
    MotionRecord way{};
    way.kind = MotionKind::way;
    way.line = line;
    way.flags = kIsRapid;
    for (std::size_t head = 0; head < kHeads; ++head) {
        way.axes = static_cast<std::uint8_t>(way.axes | 1U << head);
        way.target[head] = out_mm_[head];
    }
    outlet_.put(way);
}

/// Coolant without an output does nothing here, as MachineCheck has warned.
void RecordMaker::switch_outputs(const CanonRecord& record) {
    const SwitchedOutputs wired = outputs_of(record) & wired_outputs_;
    if (record.kind == CanonKind::output && wired == 0)
        return refuse(record, "the machine has no such output or input");
    put_outputs(record.line, wired, switches_on(record));
}

void RecordMaker::put_outputs(std::uint64_t line, SwitchedOutputs outputs, bool is_on) {
    if (outputs == 0 || options_.is_dry) return;
    MotionRecord record{};
    record.kind = MotionKind::output;
    record.line = line;
    record.code = is_on ? 1 : 0;
    record.outputs = outputs;
    outlet_.put(record);
}

void RecordMaker::put(MotionKind kind, std::uint64_t line, std::uint8_t code, double seconds) {
    MotionRecord record{};
    record.kind = kind;
    record.line = line;
    record.code = code;
    record.seconds = seconds;
    outlet_.put(record);
}

void RecordMaker::refuse(const CanonRecord& record, const std::string& what) {
    outlet_.fail(bad_input("line " + std::to_string(record.line) + ": " + what));
}

}  // namespace psicarve::gcode
