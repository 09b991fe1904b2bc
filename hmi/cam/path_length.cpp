// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/path_length.hpp"

#include <cstddef>
#include <cstdint>

#include "hmi/cam/job_pulses.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cam {
namespace {

double way_mm(const PulseCounts& pulses, Axis axis, const LinearAxisProfile& of) {
    return mm_from_pulses(static_cast<std::int64_t>(pulses[index_of(axis)]), of.pulses_per_mm);
}

}  // namespace

std::vector<LayerPath> layer_paths(const JobView& job, const Profile& profile, const LeastTime& least) {
    const std::vector<PulseCounts> links = link_pulses(job, profile);
    std::vector<LayerPath> paths(job.layer_count());
    for (std::size_t layer = 0; layer < paths.size(); ++layer) {
        const double rise_mm = way_mm(links[layer], Axis::y, profile.y);
        paths[layer] = {least.layer_path_mm[layer],
                        {way_mm(links[layer], Axis::r1, profile.r1) + rise_mm,
                         way_mm(links[layer], Axis::r2, profile.r2) + rise_mm}};
    }
    return paths;
}

}  // namespace psicarve::cam
