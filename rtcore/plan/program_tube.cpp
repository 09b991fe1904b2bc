// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/program_tube.hpp"

#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"

namespace psicarve::plan {
namespace {

// The tube is looked at in the nodes; between them the curve may go a little further.
constexpr double kProgramTubeShare = 0.93;
// Where an axis hardly turns, it has this much of what the one has that turns most.
constexpr double kLeastTurnShare = 0.5;
// A coarse table leaves at least this much of the tolerance to the other axes.
constexpr double kLeastRoomShare = 0.25;
// What moves so many spans before or after may still move here.
constexpr std::size_t kSpansBeside = 2;

using SpaceVector = std::array<double, kSpaceAxisCount>;

/// Lowers the bands of a head's space to half a box [mm].
void lower_bands(const SpaceVector& pulses_mm, const SpaceVector& half_mm, std::size_t head, Lanes& band) {
    const auto axes = space_axes(head);
    for (std::size_t i = 0; i < kSpaceAxisCount; ++i)
        band[axes[i]] = std::min(band[axes[i]], half_mm[i] / pulses_mm[i]);
}

/// Half a cube around a place of the chord, no corner of which is further than 1 from the chord: the cube has
/// the axes that move, the chord goes this way.
double half_cube(const SpaceVector& way, const std::array<bool, kSpaceAxisCount>& moves) {
    double length2 = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
        length2 += way[i] * way[i];
        count += moves[i] ? 1.0 : 0.0;
    }
    double least2 = 0.0;
    if (length2 > 0.0) {
        const double a = std::abs(way[0]), b = std::abs(way[1]), c = std::abs(way[2]);
        const double least = std::min({std::abs(a + b - c), std::abs(a - b + c), std::abs(b + c - a)});
        least2 = least * least / length2;
    }
    return 1.0 / std::sqrt(std::max(1.0, count - least2));
}

class ProgramTubes {
public:
    ProgramTubes(const MachineLimits& limits, std::span<PathSpan> spans)
        : limits_(limits), spans_(spans), room_mm_(kProgramTubeShare * limits.path_tolerance_mm) {}

    void set() {
        for (std::size_t i = 0; i < spans_.size(); ++i) set_along(i);
        for (std::size_t i = 1; i < spans_.size(); ++i) set_at_corner(spans_[i - 1], spans_[i]);
    }

private:
    bool has_backlash(std::size_t axis) const { return limits_.tick.axes[axis].backlash_pulses > 0; }
    bool is_rounded(const PathSpan& span, std::size_t axis) const {
        return !has_backlash(axis) &&
               (axis != index_of(Axis::psi) || cuts_follow_table(limits_, span.radius_mm));
    }
    bool moves_near(std::size_t at, std::size_t axis) const {
        const std::size_t first = at > kSpansBeside ? at - kSpansBeside : 0;
        const std::size_t last = std::min(at + kSpansBeside, spans_.size() - 1);
        for (std::size_t i = first; i <= last; ++i)
            if (spans_[i].slope[axis] != 0.0) return true;
        return false;
    }

    void set_along(std::size_t at) {
        PathSpan& span = spans_[at];
        for (std::size_t k = 0; k < kAxisCount; ++k)
            span.band[k] = is_rounded(span, k) && moves_near(at, k) ? 1e300 : kLeastBandPulses;
        for (std::size_t head = 0; head < kHeads; ++head) {
            const auto axes = space_axes(head);
            const SpaceVector pulses_mm = space_pulses_mm(limits_, span, head);
            SpaceVector way{};
            std::array<bool, kSpaceAxisCount> moves{};
            for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
                moves[i] = span.band[axes[i]] > kLeastBandPulses;
                if (moves[i]) way[i] = span.slope[axes[i]] * pulses_mm[i];
            }
            SpaceVector half_mm;
            half_mm.fill(room_beside_psi_mm(span, pulses_mm, head) * half_cube(way, moves));
            lower_bands(pulses_mm, half_mm, head, span.band);
        }
        for (double& band : span.band) band = std::max(band, kLeastBandPulses);
    }

    // Where the way is cut on its chord the table is rounded to a pulse of its own, as a rule a coarse one.
    double room_beside_psi_mm(const PathSpan& span, const SpaceVector& pulses_mm, std::size_t head) const {
        if (is_rounded(span, index_of(Axis::psi)) || span.slope[kPsi] == 0.0) return room_mm_;
        const auto axes = space_axes(head);
        double length2 = 0.0;
        double along_psi2 = 0.0;
        for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
            const double part = span.slope[axes[i]] * pulses_mm[i];
            length2 += part * part;
            if (axes[i] == index_of(Axis::psi)) along_psi2 = part * part;
        }
        const double across = std::sqrt(1.0 - along_psi2 / length2);
        return std::max(room_mm_ - 0.5 * across * pulses_mm[1], kLeastRoomShare * room_mm_);
    }

    // A parabola that rounds a corner leaves it the way the slope changes there.
    void set_at_corner(PathSpan& before, PathSpan& after) const {
        Lanes band;
        for (std::size_t k = 0; k < kAxisCount; ++k)
            band[k] = is_rounded(before, k) && is_rounded(after, k) ? std::min(before.band[k], after.band[k])
                                                                    : before.end_band[k];
        for (std::size_t head = 0; head < kHeads; ++head) {
            const auto axes = space_axes(head);
            const SpaceVector pulses_mm = space_pulses_mm(
                limits_, before.radius_mm[head] > after.radius_mm[head] ? before : after, head);
            SpaceVector turn{};
            double most = 0.0;
            for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
                turn[i] = std::abs(after.slope[axes[i]] - before.slope[axes[i]]) * pulses_mm[i];
                most = std::max(most, turn[i]);
            }
            double length2 = 0.0;
            for (std::size_t i = 0; i < kSpaceAxisCount; ++i) {
                if (band[axes[i]] > kLeastBandPulses) turn[i] = std::max(turn[i], kLeastTurnShare * most);
                length2 += turn[i] * turn[i];
            }
            if (length2 <= 0.0) continue;
            for (double& part : turn) part *= room_mm_ / std::sqrt(length2);
            for (std::size_t i = 0; i < kSpaceAxisCount; ++i)
                band[axes[i]] =
                    std::min(band[axes[i]], std::max(turn[i] / pulses_mm[i], before.end_band[axes[i]]));
        }
        before.end_band = band;
        after.begin_band = band;
    }

    const MachineLimits& limits_;
    std::span<PathSpan> spans_;
    double room_mm_;
};

}  // namespace

std::array<double, kSpaceAxisCount> space_pulses_mm(const MachineLimits& limits, const PathSpan& span,
                                                    std::size_t head) {
    const double radius_mm = std::max(span.radius_mm[head], limits.path_tolerance_mm);
    return {1.0 / limits.axes[head].pulses_per_unit, radius_mm * rad_from_pulses(1, limits.pulses_per_rev),
            1.0 / limits.axes[kY].pulses_per_unit};
}

void set_program_tubes(const MachineLimits& limits, std::span<PathSpan> spans) {
    ProgramTubes(limits, spans).set();
}

}  // namespace psicarve::plan
