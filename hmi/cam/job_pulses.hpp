// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

using PulseCounts = std::array<std::uint64_t, kAxisCount>;  ///< by axis

/// Pulses of the way to each layer from the one before, none to the first: straight; to a layer that begins a
/// pass, out to where the heads clear the blank and in again.
std::vector<PulseCounts> link_pulses(const JobView& job, const Profile& profile);

/// Pulses from each layer's first point to the job's last: straight from point to point of the tables, and
/// between two passes out to where the heads clear the blank and in again. One entry a layer. Some
/// nanoseconds a point.
std::vector<PulseCounts> pulses_to_end(const JobView& job, const Profile& profile);

/// From a point to the job's last. `to_end`: the result of pulses_to_end(job). Requires a layer and a point
/// of the job.
PulseCounts pulses_to_go(const JobView& job, const std::vector<PulseCounts>& to_end, std::uint32_t layer,
                         std::uint32_t point);

}  // namespace psicarve::cam
