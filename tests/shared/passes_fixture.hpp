// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "shared/job/job.hpp"

namespace psicarve {

/// Entries of a table of passes: so many layers each, the last of them the finishing pass.
inline void set_passes(JobTable& table, std::initializer_list<std::uint32_t> layer_counts) {
    table.passes.clear();
    std::uint32_t first = 0;
    for (const std::uint32_t count : layer_counts) {
        const auto number = static_cast<std::uint32_t>(table.passes.size() + 1);
        const bool is_last = table.passes.size() + 1 == layer_counts.size();
        const PassKind kind = is_last ? PassKind::finishing : PassKind::roughing;
        table.passes.push_back({static_cast<std::uint32_t>(kind), number, first, count, is_last ? 0.0 : 0.3,
                                is_last ? 0.0 : 9.0, 12.0});
        first += count;
    }
}

/// The same layers several times over, each time `step` pulses further out, and then as they are.
inline JobTable with_roughing(const JobTable& finishing, std::uint32_t rough_passes, std::int32_t step) {
    JobTable job = finishing;
    job.passes.clear();
    job.layer_height_pulses.clear();
    job.r_left_pulses.clear();
    job.r_right_pulses.clear();
    for (std::uint32_t pass = 0; pass <= rough_passes; ++pass) {
        const std::int32_t out = static_cast<std::int32_t>(rough_passes - pass) * step;
        const bool is_last = pass == rough_passes;
        // A spiral closes with a ring as high as the row before: none of a roughing pass.
        const bool leaves_one = !is_last && finishing.joining == Joining::spiral && finishing.layer_count > 1;
        const std::uint32_t layers = finishing.layer_count - (leaves_one ? 1 : 0);
        const auto first = static_cast<std::uint32_t>(job.layer_height_pulses.size());
        const PassKind kind = is_last ? PassKind::finishing : PassKind::roughing;
        job.passes.push_back({static_cast<std::uint32_t>(kind), pass + 1, first, layers, 0.0, 0.0, 0.0});
        for (std::uint32_t layer = 0; layer < layers; ++layer) {
            job.layer_height_pulses.push_back(finishing.layer_height_pulses[layer]);
            for (std::size_t point = 0; point < finishing.point_count; ++point) {
                const std::size_t at = std::size_t{layer} * finishing.point_count + point;
                job.r_left_pulses.push_back(finishing.r_left_pulses[at] + out);
                job.r_right_pulses.push_back(finishing.r_right_pulses[at] + out);
            }
        }
    }
    job.layer_count = static_cast<std::uint32_t>(job.layer_height_pulses.size());
    return job;
}

}  // namespace psicarve
