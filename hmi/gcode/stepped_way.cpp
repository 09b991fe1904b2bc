// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/stepped_way.hpp"

#include <algorithm>
#include <cmath>

#include "hmi/gcode/arc.hpp"
#include "hmi/phrase/phrase.hpp"
#include "shared/base/units.hpp"

namespace psicarve::gcode {
namespace {

/// Ends that are nearer might change places when they are rounded, and a short arc become a whole turn.
constexpr double kLeastGapPulses = 16.0;
/// Of a smaller circle the judge of pins cannot tell how much was gone along.
constexpr double kLeastRadiusPulses = 16.0;
constexpr double kMostRadiusPulses = 1 << 29;
/// By which the core lets both ends' radii differ, less a rounding.
constexpr double kMostApartPulses = 0.999;
constexpr double kSameAngleRad = 1e-9;
constexpr int kSamples = 16;
constexpr const char* kEndsAreNear =
    PSICARVE_TEXT("an arc stays chords: its ends differ and are within 16 pulses of each other");

using PulsePoint = std::array<double, 2>;

double apart(const PulsePoint& a, const PulsePoint& b) noexcept {
    return std::hypot(a[0] - b[0], a[1] - b[1]);
}

PulsePoint rounded(const PulsePoint& at) noexcept {
    return {static_cast<double>(round_to_pulse(at[0])), static_cast<double>(round_to_pulse(at[1]))};
}

/// The circle's centre on whole pulses: that of those around it from which both ends are alike far, whose
/// circle is nearest to the true one all along the arc.
std::optional<PulsePoint> centre_on_pulses(const PulsePoint& from, const PulsePoint& to,
                                           const PulsePoint& centre, double sweep_rad) noexcept {
    const PulsePoint begin = rounded(from);
    const PulsePoint end = rounded(to);
    const PulsePoint middle = rounded(centre);
    const double radius = apart(from, centre);
    const double start_rad = std::atan2(from[1] - centre[1], from[0] - centre[0]);
    std::optional<PulsePoint> best;
    double least = INFINITY;
    for (int n = 0; n < 9; ++n) {
        const int column = n % 3 - 1;
        const int row = n / 3 - 1;
        const PulsePoint at{middle[0] + column, middle[1] + row};
        const double around = apart(begin, at);
        if (std::abs(apart(end, at) - around) > kMostApartPulses) continue;
        double off = 0.0;
        for (int i = 0; i <= kSamples; ++i) {
            const double angle_rad = start_rad + sweep_rad * i / kSamples;
            const PulsePoint place{centre[0] + radius * std::cos(angle_rad),
                                   centre[1] + radius * std::sin(angle_rad)};
            off = std::max(off, std::abs(apart(place, at) - around));
        }
        if (off >= least) continue;
        least = off;
        best = at;
    }
    return best;
}

}  // namespace

AxisMask changed_letters(const CanonRecord& record) noexcept {
    AxisMask changed = static_cast<AxisMask>(record.placed & ~record.start_placed);
    for (std::size_t letter = 0; letter < kLetterCount; ++letter)
        if (record.start[letter] != record.end[letter]) changed |= mask_of(letter);
    return changed;
}

SteppedWays::SteppedWays(const Profile& profile) noexcept
    : is_on_(profile.gcode.is_stepwise),
      letters_(profile.gcode),
      core_pulses_{core_radius_pulses(profile, Axis::r1), core_radius_pulses(profile, Axis::r2)} {
    for (const Axis axis : kAllAxes) axes_[index_of(axis)] = axis_motion(profile, axis);
}

std::uint8_t SteppedWays::line_axes(const CanonRecord& record, AxisMask letters) const noexcept {
    if (!is_on_ || record.kind != CanonKind::feed || record.is_drawn) return 0;
    const AxisMask changed = static_cast<AxisMask>(changed_letters(record) & letters);
    unsigned axes = 0;
    for (const Axis axis : kAllAxes)
        if ((changed & letters_.mask_of_axis(axis)) != 0) axes |= 1U << index_of(axis);
    constexpr unsigned kHeadBits = 1U << index_of(Axis::r1) | 1U << index_of(Axis::r2);
    const bool has_both = (axes & kHeadBits) == kHeadBits;
    return has_both || (axes >> index_of(Axis::psi) & 1U) != 0 ? 0 : static_cast<std::uint8_t>(axes);
}

std::optional<SteppedArc> SteppedWays::arc(const CanonRecord& record) const noexcept {
    if (!is_on_ || record.kind != CanonKind::arc || !letters_.has_arcs_in(*record.plane)) return {};
    SteppedArc found;
    if (*find_arc(record, found) != '\0') return {};
    return found;
}

const char* SteppedWays::find_arc(const CanonRecord& record, SteppedArc& found) const noexcept {
    const Plane& plane = *record.plane;
    if ((changed_letters(record) & letters_.all() & ~mask_of(plane.first) & ~mask_of(plane.second)) != 0)
        return PSICARVE_TEXT("an arc stays chords: another axis moves with it");
    const bool is_y_first = plane.first == letters_.letter_of(Axis::y);
    const std::size_t head_letter = is_y_first ? plane.second : plane.first;
    if (letters_.letter_of(Axis::r1) == letters_.letter_of(Axis::r2))
        return PSICARVE_TEXT("an arc stays chords: both heads draw it");
    found.head = letters_.letter_of(Axis::r1) == head_letter ? Axis::r1 : Axis::r2;
    const double scale = axes_[index_of(found.head)].pulses_per_unit;
    if (scale != axes_[index_of(Axis::y)].pulses_per_unit)
        return PSICARVE_TEXT("an arc stays chords: its head and y differ in pulses per mm");
    if (!has_room(record, found.head))
        return PSICARVE_TEXT(
            "an arc stays chords: it comes within two pulses of the end of a travel or of the core");

    const auto point = [&](double first_mm, double second_mm) {
        return PulsePoint{(is_y_first ? second_mm : first_mm) * scale,
                          (is_y_first ? first_mm : second_mm) * scale};
    };
    const PulsePoint from = point(record.start[plane.first], record.start[plane.second]);
    const PulsePoint to = point(record.end[plane.first], record.end[plane.second]);
    const PulsePoint centre = point(record.centre_first_mm, record.centre_second_mm);
    const int turns = is_y_first ? -record.turns : record.turns;
    const double signed_rad = sweep_rad({from[0], from[1]}, {to[0], to[1]}, {centre[0], centre[1]}, turns);
    const double radius = apart(from, centre);
    if (radius < kLeastRadiusPulses)
        return PSICARVE_TEXT("an arc stays chords: its radius is below 16 pulses");
    if (radius > kMostRadiusPulses) return PSICARVE_TEXT("an arc stays chords: its radius is too large");
    found.is_counterclockwise = signed_rad > 0.0;
    found.sweep_rad = std::abs(signed_rad);
    found.whole_turns = static_cast<int>((found.sweep_rad + kSameAngleRad) / (2.0 * kPi));
    found.rest_rad = std::max(0.0, found.sweep_rad - 2.0 * kPi * found.whole_turns);
    if (found.rest_rad <= kSameAngleRad) {
        found.rest_rad = 0.0;
        if (rounded(from) != rounded(to)) return kEndsAreNear;
    } else if (const double gap_rad = kLeastGapPulses / radius;
               found.rest_rad < gap_rad || found.rest_rad > 2.0 * kPi - gap_rad) {
        return kEndsAreNear;
    }
    const auto at = centre_on_pulses(from, to, centre, signed_rad);
    if (!at)
        return PSICARVE_TEXT(
            "an arc stays chords: its ends are not, to a pulse, as far from the centre as each other");
    found.centre_mm = {(*at)[0] / scale, (*at)[1] / scale};
    return "";
}

const char* SteppedWays::why_not(const CanonRecord& record) const noexcept {
    if (!is_on_ || record.feed_per_min <= 0.0) return "";
    if (record.kind == CanonKind::feed) return why_no_line(record);
    if (record.kind != CanonKind::arc || !letters_.has_arcs_in(*record.plane)) return "";
    const AxisMask drawn =
        static_cast<AxisMask>(mask_of(record.plane->first) | mask_of(record.plane->second));
    SteppedArc found;
    if ((record.start_placed & record.placed & drawn) != drawn) return "";
    return find_arc(record, found);
}

const char* SteppedWays::why_no_line(const CanonRecord& record) const noexcept {
    // Of a drawn way once.
    if (record.is_drawn)
        return record.begins_within ? "" : PSICARVE_TEXT("a drawn way is carved as with \"path\"");
    AxisMask moved = 0;
    for (std::size_t letter = 0; letter < kLetterCount; ++letter)
        if ((record.start_placed & mask_of(letter)) != 0 && record.start[letter] != record.end[letter])
            moved |= mask_of(letter);
    const bool moves_r1 = (moved & letters_.mask_of_axis(Axis::r1)) != 0;
    const bool moves_r2 = (moved & letters_.mask_of_axis(Axis::r2)) != 0;
    if ((moved & letters_.mask_of_axis(Axis::psi)) != 0)
        return PSICARVE_TEXT("a line is carved as with \"path\": psi turns");
    if (moves_r1 && moves_r2) return PSICARVE_TEXT("a line is carved as with \"path\": both heads move");
    return "";
}

/// Steps may be a pulse off the arc, and the core lets none be where an axis may not.
bool SteppedWays::has_room(const CanonRecord& record, Axis head) const noexcept {
    constexpr double kRoomPulses = 2.0;
    const Plane& plane = *record.plane;
    const ArcExtents extents = arc_extents({record.start[plane.first], record.start[plane.second]},
                                           {record.end[plane.first], record.end[plane.second]},
                                           {record.centre_first_mm, record.centre_second_mm}, record.turns);
    const bool is_y_first = plane.first == letters_.letter_of(Axis::y);
    for (std::size_t i = 0; i < 2; ++i) {
        const Axis axis = (i == 0) == is_y_first ? Axis::y : head;
        const AxisMotion& motion = axes_[index_of(axis)];
        const double least = extents.least_mm[i] * motion.pulses_per_unit - kRoomPulses;
        const double most = extents.most_mm[i] * motion.pulses_per_unit + kRoomPulses;
        if (axis == head && least < static_cast<double>(core_pulses_[index_of(head)])) return false;
        if (!motion.has_travel) continue;
        if (least < static_cast<double>(motion.travel_min_pulses) ||
            most > static_cast<double>(motion.travel_max_pulses))
            return false;
    }
    return true;
}

}  // namespace psicarve::gcode
