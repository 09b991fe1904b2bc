// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/job_place.hpp"

#include <cstdlib>

#include "shared/base/units.hpp"

namespace psicarve::replay {

std::optional<JobPlace> job_place(const verify::JobGeometry& geometry,
                                  const verify::Positions& position_pulses) noexcept {
    const std::int64_t psi = position_pulses[index_of(Axis::psi)];
    const auto row = geometry.row_at(position_pulses[index_of(Axis::y)], geometry.direction(0, psi));
    if (!row) return std::nullopt;
    return place_in_layer(geometry, geometry.first_row_layer() + *row, psi);
}

JobPlace place_in_layer(const verify::JobGeometry& geometry, std::uint32_t layer,
                        std::int64_t psi_pulses) noexcept {
    const std::uint32_t last = geometry.point_count() - 1;
    const std::int64_t first_psi = geometry.target(layer, 0)[index_of(Axis::psi)];
    const std::int64_t way = geometry.target(layer, last)[index_of(Axis::psi)] - first_psi;
    if (way == 0) return JobPlace{layer, 0};
    const std::int64_t sweep = std::abs(way);
    const std::int64_t rev = geometry.rev_pulses();
    // How far the table has turned since the layer's first point; whole turns do not count.
    const std::int64_t turned =
        (((way > 0 ? psi_pulses - first_psi : first_psi - psi_pulses) % rev) + rev) % rev;
    if (turned > sweep) return JobPlace{layer, turned - sweep < rev - turned ? last : 0};
    std::int64_t point = turned * last / sweep;
    // Points stand at whole pulses, which may be a little before their even share.
    if (point < last && point_angle_pulses(point + 1, sweep, geometry.point_count()) <= turned) ++point;
    return JobPlace{layer, static_cast<std::uint32_t>(point)};
}

}  // namespace psicarve::replay
