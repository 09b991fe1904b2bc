// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shared/base/units.hpp"
#include "shared/job/job.hpp"

namespace psicarve {

/// A job that the profile's machine can carve: every radius `radius_mm` as the real tip stands.
inline JobTable small_job(const Profile& profile = {}, std::uint32_t layers = 3, std::uint32_t points = 5,
                          double radius_mm = 10.0) {
    JobTable table;
    table.layer_count = layers;
    table.point_count = points;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.feed_mm_s = 20.0;
    const std::size_t cells = std::size_t{layers} * points;
    const auto counted = [&](const LinearAxisProfile& head) {
        return static_cast<std::int32_t>(pulses_from_mm(radius_mm - head.tip_offset_mm, head.pulses_per_mm));
    };
    table.r_left_pulses.assign(cells, counted(profile.r1));
    table.r_right_pulses.assign(cells, counted(profile.r2));
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        table.layer_height_pulses.push_back(100 + 10 * std::int64_t{layer});
    }
    table.source_name = "model.stl";
    table.source_hash = 0x1234'5678'9abc'def0ULL;
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    return table;
}

}  // namespace psicarve
