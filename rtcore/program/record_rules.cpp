// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/program/record_rules.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "rtcore/cycle/arc_order.hpp"
#include "rtcore/cycle/motion_order.hpp"
#include "shared/base/units.hpp"
#include "shared/machine/message_argument.hpp"

namespace psicarve::program {
namespace {

constexpr std::uint8_t kAllAxesMask = (1U << kAxisCount) - 1U;
constexpr double kMsPerS = 1000.0;
constexpr std::uint8_t kYMask = 1U << index_of(Axis::y);
/// Of one head, y, or both: point-by-point comparison has two axes.
constexpr std::uint8_t kHeadMasks[]{1U << index_of(Axis::r1), 1U << index_of(Axis::r2)};
/// Of a line by point-by-point comparison: it multiplies the ways of both axes.
constexpr double kLongestSteppedPulses = 1 << 30;

bool are_stepped_axes(std::uint8_t axes) noexcept {
    return axes == kYMask || axes == kHeadMasks[0] || axes == kHeadMasks[1] ||
           axes == (kHeadMasks[0] | kYMask) || axes == (kHeadMasks[1] | kYMask);
}
bool are_arc_axes(std::uint8_t axes) noexcept {
    return are_stepped_axes(axes) && (axes & kYMask) != 0 && axes != kYMask;
}
bool is_known_way(const MotionRecord& record) noexcept {
    if ((record.axes & ~kAllAxesMask) != 0 || record.code != 0) return false;
    if ((record.flags & kIsStepped) == 0) return true;
    return are_stepped_axes(record.axes) && (record.flags & kIsRapid) == 0 && record.tolerance_mm == 0.0;
}
bool is_known_arc(const MotionRecord& record) noexcept {
    const bool has_sense = record.code == static_cast<std::uint8_t>(ArcSense::clockwise) ||
                           record.code == static_cast<std::uint8_t>(ArcSense::counterclockwise);
    return has_sense && are_arc_axes(record.axes) && (record.flags & (kIsRapid | kIsStepped)) == 0 &&
           record.tolerance_mm == 0.0;
}

/// What may stand in a record of its kind: flags, axes and codes that are not known mean something else to
/// their writer than to us.
bool is_known(const MotionRecord& record) noexcept {
    for (const std::uint8_t byte : record.reserved)
        if (byte != 0) return false;
    if (record.line == 0 || (record.flags & ~kKnownFlags) != 0) return false;
    if (record.kind == MotionKind::arc) return record.outputs == 0 && is_known_arc(record);
    if (record.centre_mm != std::array<double, 2>{}) return false;
    if ((record.outputs != 0) != (record.kind == MotionKind::output)) return false;
    if (record.kind == MotionKind::way) return is_known_way(record);
    if (record.axes != 0 || (record.flags & (kIsRapid | kIsStepped)) != 0) return false;
    switch (record.kind) {
        case MotionKind::dwell:
        case MotionKind::end:
            return record.code == 0;
        case MotionKind::spindle:
            return record.code <= 1;
        case MotionKind::output:
            return record.code <= 1 && (record.outputs & ~kAllSwitchedOutputs) == 0;
        case MotionKind::stop:
            return record.code >= static_cast<std::uint8_t>(StopReason::program) &&
                   record.code <= static_cast<std::uint8_t>(StopReason::optional_on_way);
        default:
            return false;
    }
}

bool has_numbers(const MotionRecord& record) noexcept {
    return std::ranges::all_of(record.target, [](double value) { return std::isfinite(value); }) &&
           std::ranges::all_of(record.centre_mm, [](double value) { return std::isfinite(value); }) &&
           std::isfinite(record.seconds) && std::isfinite(record.tolerance_mm);
}

bool moves_inwards_and_outwards(const plan::Pulses4& at, const plan::Pulses4& to) noexcept {
    return (to[0] > at[0] && to[1] < at[1]) || (to[0] < at[0] && to[1] > at[1]);
}

}  // namespace

RecordRules::RecordRules(const Profile& profile)
    : wired_outputs_(wired_outputs(profile)),
      core_pulses_{core_radius_pulses(profile, Axis::r1), core_radius_pulses(profile, Axis::r2)},
      pulses_per_rev_(static_cast<double>(profile.psi.pulses_per_rev)),
      tips_mm_(profile.r1.tip_mm() + profile.r2.tip_mm()),
      clearance_mm_(profile.head_clearance_mm) {
    for (const Axis axis : kAllAxes) axes_[index_of(axis)] = axis_motion(profile, axis);
    rounding_mm_ = 0.5 * (1.0 / axes_[0].pulses_per_unit + 1.0 / axes_[1].pulses_per_unit) * (1.0 + 1e-9);
}

Message RecordRules::judge(const MotionRecord& record, const plan::Pulses4& at,
                           plan::ProgramStep& step) const noexcept {
    const Argument line = count_argument(record.line);
    if (!is_known(record)) {
        return message_of(MessageId::program_record_unknown, line,
                          count_argument(static_cast<std::uint64_t>(record.kind)));
    }
    if (!has_numbers(record)) return message_of(MessageId::program_number_not_finite, line);
    if (record.seconds < 0.0 || record.seconds > kMostSeconds) {
        return message_of(MessageId::program_time_out_of_range, line,
                          ms_argument(static_cast<std::uint64_t>(kMostSeconds * kMsPerS)));
    }
    if (record.tolerance_mm < 0.0 || record.tolerance_mm > kMostTolerance_mm) {
        // What is shown has a length that can be written.
        const double shown_mm = std::clamp(record.tolerance_mm, -1e15, 1e15);
        return message_of(MessageId::program_tolerance_out_of_range, line, mm_argument(shown_mm),
                          mm_argument(kMostTolerance_mm));
    }
    step = plan::ProgramStep{
        .kind = record.kind,
        .is_rapid = (record.flags & kIsRapid) != 0,
        .ends_block = (record.flags & kEndsBlock) != 0,
        .is_on =
            (record.kind == MotionKind::spindle || record.kind == MotionKind::output) && record.code == 1,
        .outputs = record.outputs,
        .line = record.line,
        .sequence = record.sequence,
        .target_pulses = at,
        .seconds = record.seconds,
        .tolerance_mm = record.tolerance_mm};
    if (record.kind == MotionKind::stop) step.reason = static_cast<StopReason>(record.code);
    if (record.kind == MotionKind::output) return judge_outputs(record);
    if (record.kind != MotionKind::way && record.kind != MotionKind::arc) return {};
    if (const Message wrong = judge_way(record, at, step); !wrong.is_none()) return wrong;
    if (record.kind == MotionKind::way && (record.flags & kIsStepped) == 0) return {};
    return judge_stepped(record, at, step);
}

// None of several goes on where one of them is not wired.
Message RecordRules::judge_outputs(const MotionRecord& record) const noexcept {
    const unsigned unwired = record.outputs & ~static_cast<unsigned>(wired_outputs_);
    if (unwired == 0) return {};
    const auto first = kFirstSwitchedOutput + static_cast<std::size_t>(std::countr_zero(unwired));
    return message_of(MessageId::program_output_not_wired, count_argument(record.line),
                      argument_of(static_cast<Signal>(first)));
}

Message RecordRules::judge_stepped(const MotionRecord& record, const plan::Pulses4& at,
                                   plan::ProgramStep& step) const noexcept {
    step.stepped_axes = record.axes;
    step.shape = cycle::OrderShape::stepped;
    for (const Axis axis : kAllAxes) {
        const std::size_t k = index_of(axis);
        const auto way = static_cast<double>(step.target_pulses[k]) - static_cast<double>(at[k]);
        if (std::fabs(way) <= kLongestSteppedPulses) continue;
        return message_of(MessageId::program_cannot_count_so_far, count_argument(record.line),
                          argument_of(axis));
    }
    return record.kind == MotionKind::arc ? judge_arc(record, at, step) : Message{};
}

// An arc in millimetres is one in pulses only where both axes have as many of them; so it is for moves by
// hand. Its steps wind round a circle in pulses and are within one of it: nowhere further than R, rounded up,
// at the circle's four ends, and elsewhere between its own.
Message RecordRules::judge_arc(const MotionRecord& record, const plan::Pulses4& at,
                               plan::ProgramStep& step) const noexcept {
    const Message unsound = message_of(MessageId::program_arc_unsound, count_argument(record.line));
    const Axis head = (record.axes & kHeadMasks[0]) != 0 ? Axis::r1 : Axis::r2;
    const std::array<Axis, 2> plane{head, Axis::y};
    if (axes_[index_of(head)].pulses_per_unit != axes_[index_of(Axis::y)].pulses_per_unit) return unsound;
    cycle::MotionOrder order{};
    order.axes = record.axes;
    order.shape = record.code == static_cast<std::uint8_t>(ArcSense::clockwise) ? cycle::OrderShape::clockwise
                                                                                : cycle::OrderShape::arc;
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const double pulses = pulses_of(plane[i], record.centre_mm[i]);
        if (std::fabs(pulses) > static_cast<double>(cycle::kFurthestPulses)) {
            return message_of(MessageId::program_cannot_count_so_far, count_argument(record.line),
                              argument_of(plane[i]));
        }
        order.centre_pulses[i] = round_to_pulse(pulses);
    }
    const cycle::ArcInPlane arc = cycle::arc_of(order, at, step.target_pulses);
    if (!arc.is_arc) return unsound;
    step.shape = order.shape;
    step.centre_pulses = order.centre_pulses;
    const auto way = cycle::PointByPoint::arc(arc.begin, arc.end, arc.counter_clockwise);
    for (std::size_t i = 0; i < plane.size(); ++i) {
        for (const int sign : {-1, 1}) {
            if (!way.passes(i == 0 ? sign : 0, i == 0 ? 0 : sign)) continue;
            plan::Pulses4 furthest = at;
            std::int64_t& place = furthest[index_of(plane[i])];
            place = arc.centre_pulses[i] + sign * arc.radius_pulses;
            Message wrong = judge_place(record.line, plane[i], place);
            if (wrong.is_none()) wrong = judge_tips(record.line, at, furthest);
            if (!wrong.is_none()) return wrong;
        }
    }
    return {};
}

Message RecordRules::judge_way(const MotionRecord& record, const plan::Pulses4& at,
                               plan::ProgramStep& step) const noexcept {
    for (const Axis axis : kAllAxes) {
        const std::size_t k = index_of(axis);
        if ((record.axes & (1U << k)) == 0) continue;
        const double pulses = pulses_of(axis, record.target[k]);
        if (std::fabs(pulses) > static_cast<double>(cycle::kFurthestPulses)) {
            return message_of(MessageId::program_cannot_count_so_far, count_argument(record.line),
                              argument_of(axis));
        }
        step.target_pulses[k] = round_to_pulse(pulses);
        step.rounded_off_pulses[k] = pulses - static_cast<double>(step.target_pulses[k]);
        // On its way each axis stays between begin and end: it never turns round.
        const Message wrong = judge_place(record.line, axis, step.target_pulses[k]);
        if (!wrong.is_none()) return wrong;
    }
    return judge_tips(record.line, at, step.target_pulses);
}

Message RecordRules::judge_place(std::uint64_t line, Axis axis, std::int64_t position) const noexcept {
    const std::size_t k = index_of(axis);
    const AxisMotion& motion = axes_[k];
    if (!motion.has_travel) return {};
    const auto mm_of = [&](std::int64_t pulses) {
        return mm_argument(mm_from_pulses(pulses, motion.pulses_per_unit));
    };
    if (position < motion.travel_min_pulses || position > motion.travel_max_pulses) {
        return message_of(MessageId::program_outside_travel, count_argument(line), argument_of(axis),
                          mm_of(position), mm_of(motion.travel_min_pulses), mm_of(motion.travel_max_pulses));
    }
    if (k < core_pulses_.size() && position < core_pulses_[k]) {
        return message_of(MessageId::program_inside_core_radius, count_argument(line), argument_of(axis),
                          mm_of(position), mm_of(core_pulses_[k]));
    }
    return {};
}

// The sum s of both heads' positions is how far their tips are apart. With w from 0 to 1 along the way,
// s(w) = s(0) + w * (s(1) - s(0)): a straight line, so for every w between the ends s(w) >= min(s(0), s(1)),
// and if both ends keep a distance, all of the straight way does. What moves are pulses, though. A head's
// position is its straight one rounded to a pulse, and rounding keeps the order of two numbers. Where both
// heads go the same way, or one stands, the rounded sum therefore rises or falls all along, and is least at
// an end. Where one goes in and the other out, each may be half a pulse further in than its straight position
// (DualHeadDda), and the sum by half a pulse of each head less than at either end. So such a way has to keep
// half a pulse of each more at its ends, and no pulse of any way stands closer than what a table may ask for:
// the clearance, less the rounding of its two radii.
Message RecordRules::judge_tips(std::uint64_t line, const plan::Pulses4& at,
                                const plan::Pulses4& to) const noexcept {
    if (to[0] == at[0] && to[1] == at[1]) return {};
    const double end_mm = tips_apart_mm(to);
    if (end_mm < clearance_mm_ - rounding_mm_) {
        return message_of(MessageId::program_tips_too_close, count_argument(line), mm_argument(end_mm),
                          mm_argument(clearance_mm_));
    }
    if (!moves_inwards_and_outwards(at, to)) return {};
    const double least_mm = std::min(end_mm, tips_apart_mm(at));
    // A millionth of half a pulse, for sums of decimal numbers are not exact.
    if (least_mm >= clearance_mm_ - 1e-6 * rounding_mm_) return {};
    return message_of(MessageId::program_tips_pass_too_close, count_argument(line), mm_argument(least_mm),
                      mm_argument(clearance_mm_));
}

double RecordRules::pulses_of(Axis axis, double position) const noexcept {
    if (axis == Axis::psi) return position * pulses_per_rev_ / kDegPerRev;
    return position * axes_[index_of(axis)].pulses_per_unit;
}

double RecordRules::tips_apart_mm(const plan::Pulses4& at) const noexcept {
    return mm_from_pulses(at[0], axes_[0].pulses_per_unit) + mm_from_pulses(at[1], axes_[1].pulses_per_unit) +
           tips_mm_;
}

}  // namespace psicarve::program
