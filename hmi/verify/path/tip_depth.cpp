// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/path/tip_depth.hpp"

#include <algorithm>
#include <vector>

#include "shared/base/units.hpp"

namespace psicarve::verify {

namespace {

/// On the way to and between the roughing layers of a spiral, which are level and sliced for themselves.
std::optional<double> floor_of_way(const JobGeometry& geometry, std::size_t h, const Positions& at,
                                   std::int64_t direction_pulses, std::span<const Positions> way_ends) {
    if (way_ends.empty()) return std::nullopt;
    const HeadGeometry& head = geometry.head(h);
    std::vector<JobGeometry::KnownTip> ends;
    for (const Positions& end : way_ends) {
        if (geometry.direction(h, end[kPsi]) == direction_pulses)
            ends.push_back({end[kY] + head.height_offset_pulses, head.real_mm(end[index_of(kHeads[h])])});
    }
    return geometry.least_around(at[kY] + head.height_offset_pulses, direction_pulses, ends);
}

/// Between two points the path may leave the line; psi is known to a pulse.
double floor_between_points(const JobGeometry& geometry, std::size_t h, std::int64_t y_pulses,
                            std::int64_t direction_pulses, double wanted_mm) {
    const std::int64_t rev = geometry.rev_pulses();
    const auto before = geometry.floor_mm(h, y_pulses, (direction_pulses + rev - 1) % rev);
    const auto after = geometry.floor_mm(h, y_pulses, (direction_pulses + 1) % rev);
    return std::min({wanted_mm, before.value_or(wanted_mm), after.value_or(wanted_mm)}) -
           geometry.tolerance_mm() - 1.0 / geometry.head(h).pulses_per_mm;
}

}  // namespace

std::optional<TipDepth> tip_depth(const JobGeometry& geometry, std::size_t h, const Positions& at,
                                  std::span<const Positions> way_ends) {
    const HeadGeometry& head = geometry.head(h);
    TipDepth tip;
    tip.real_mm = head.real_mm(at[index_of(kHeads[h])]);
    if (tip.real_mm >= geometry.blank_radius_mm()) return std::nullopt;
    const std::int64_t direction = geometry.direction(h, at[kPsi]);
    tip.row = geometry.row_at(at[kY] + head.height_offset_pulses, direction);
    tip.cell = geometry.cell_of(direction);
    const auto wanted_mm = geometry.floor_mm(h, at[kY], direction);
    if (!wanted_mm) return tip;
    double floor_mm = *wanted_mm;
    if (direction != geometry.direction_of(tip.cell))
        floor_mm = floor_between_points(geometry, h, at[kY], direction, floor_mm);
    floor_mm = std::min(floor_mm, floor_of_way(geometry, h, at, direction, way_ends).value_or(floor_mm));
    tip.off_pulses = round_to_pulse((tip.real_mm - *wanted_mm) * head.pulses_per_mm);
    tip.too_deep_pulses = round_to_pulse((floor_mm - tip.real_mm) * head.pulses_per_mm);
    return tip;
}

}  // namespace psicarve::verify
