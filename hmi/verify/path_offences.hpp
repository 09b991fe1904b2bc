// SPDX-License-Identifier: GPL-3.0-or-later
// Words for rule 1's findings. Time and place are added where they are reported.
#pragma once

#include <cstdint>

#include "hmi/verify/path/path_line.hpp"
#include "hmi/verify/path/point_way.hpp"
#include "hmi/verify/path/tip_depth.hpp"
#include "hmi/verify/verify_report.hpp"

namespace psicarve::verify {

/// An axis stood elsewhere when the others met at the point, or psi went past it.
Offence point_missed(Axis axis, std::int64_t measured_pulses, std::int64_t wanted_pulses);
/// Every axis was at the point, but at no instant all of them.
Offence point_not_met_at_once(Axis axis, std::int64_t measured_pulses, std::int64_t wanted_pulses);
Offence off_the_line(Axis head, const PathLine::Distance& distance);
Offence off_the_height(bool is_spiral, std::int64_t y_pulses, double wanted_pulses);
/// Y goes to a layer where another one is due.
Offence wrong_layer(std::uint32_t layer, std::uint32_t due, std::int64_t y_pulses,
                    std::int64_t wanted_pulses);
/// `layer`: of the job, at the tip's height, if there is one.
Offence too_deep(Axis head, std::int64_t radius_pulses, std::int64_t too_deep_pulses,
                 std::optional<std::uint32_t> layer);
/// Carving begins with a layer, though another is the first that has not been carved.
Offence layers_left_out(std::uint32_t layer, std::uint32_t due);
/// Carving begins with a point of a layer of which fewer have been carved.
Offence points_left_out(CarvePoint begin, std::uint32_t carved);
Offence nothing_carved(std::uint64_t points_total);
Offence ends_early(std::uint64_t points, std::uint64_t points_total, const Nearest& nearest);

}  // namespace psicarve::verify
