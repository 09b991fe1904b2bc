// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hmi/cam/least_time.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cam {

/// The length of R1's and R2's tip's way in one layer, or in several together.
struct LayerPath {
    std::array<double, 2> cutting_mm{};  ///< over the surface, from the layer's first point to its last
    std::array<double, 2> link_mm{};     ///< from the layer before to this one's first point

    LayerPath& operator+=(const LayerPath& more) noexcept {
        for (std::size_t head = 0; head < cutting_mm.size(); ++head) {
            cutting_mm[head] += more.cutting_mm[head];
            link_mm[head] += more.link_mm[head];
        }
        return *this;
    }
    /// Cutting and links together.
    std::array<double, 2> total_mm() const noexcept {
        return {cutting_mm[0] + link_mm[0], cutting_mm[1] + link_mm[1]};
    }
};

/// The paths of each layer. In a link a head that goes out, Y, and a head that goes in move one after the
/// other, and between two passes both heads go out to where they clear the blank; the look-ahead planner
/// shortens this by moving axes at once. `least`: of this job. Approach and retraction are left out.
std::vector<LayerPath> layer_paths(const JobView& job, const Profile& profile, const LeastTime& least);

}  // namespace psicarve::cam
