// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::plan {

struct OwnedJob {
    std::vector<std::byte> blob;
    JobView view;
};

inline std::shared_ptr<const JobView> owned(const JobTable& table) {
    auto job = std::make_shared<OwnedJob>();
    job->blob = job_blob_from_table(table);
    job->view = JobView::check(job->blob).value();
    return {job, &job->view};
}

/// Rougher from layer to layer: each takes longer than the one below.
inline JobTable rougher_and_rougher(std::uint32_t layers) {
    JobTable table;
    table.layer_count = layers;
    table.point_count = 60;
    table.psi_sweep_pulses = 3200;
    table.feed_mm_s = 20.0;
    table.profile_toml = profile_to_toml(Profile{});
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        table.layer_height_pulses.push_back(100 + 50 * layer);
        for (std::uint32_t point = 0; point < table.point_count; ++point) {
            const auto wave = static_cast<std::int32_t>(point % 2 * 10 * layer);
            table.r_left_pulses.push_back(5000 + wave);
            table.r_right_pulses.push_back(5300 - wave);
        }
    }
    return table;
}

inline Profile by_angle() {
    Profile profile;
    profile.job.planner = psicarve::Planner::angle;
    return profile;
}

}  // namespace psicarve::plan
