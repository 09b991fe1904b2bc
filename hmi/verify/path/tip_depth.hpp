// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hmi/surface/job_geometry.hpp"

namespace psicarve::verify {

/// A tip somewhere off the lines between points, against the job's surface there.
struct TipDepth {
    std::optional<std::uint32_t> row;  ///< of the surface, at the tip's height
    std::uint32_t cell = 0;
    double real_mm = 0.0;                    ///< radius at which the tip stands
    std::optional<std::int64_t> off_pulses;  ///< beyond the wanted radius; nothing where the job has none
    std::int64_t too_deep_pulses = 0;        ///< below what is allowed; 0 or less: it may stand there
};

/// Nothing where the tip is outside the blank. `way_ends`: both ends of the way that the axes are on, where
/// they are level roughing layers of a job whose finishing is a spiral; there the job's radii for this head
/// are known as well.
std::optional<TipDepth> tip_depth(const JobGeometry& geometry, std::size_t h, const Positions& at,
                                  std::span<const Positions> way_ends);

}  // namespace psicarve::verify
