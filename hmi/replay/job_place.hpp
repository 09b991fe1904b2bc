// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hmi/surface/job_geometry.hpp"

namespace psicarve::replay {

/// A point of the job, counted from 0, in the order of carving.
struct JobPlace {
    std::uint32_t layer = 0;
    std::uint32_t point = 0;
    friend bool operator==(const JobPlace&, const JobPlace&) = default;
};

/// The point that was reached last when the axes stand here; nothing above and below the job. Found by height
/// and angle alone: on the way from one layer to the next it is the nearer layer's end.
std::optional<JobPlace> job_place(const verify::JobGeometry& geometry,
                                  const verify::Positions& position_pulses) noexcept;

/// The same in a known layer, by the angle alone.
JobPlace place_in_layer(const verify::JobGeometry& geometry, std::uint32_t layer,
                        std::int64_t psi_pulses) noexcept;

}  // namespace psicarve::replay
