// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "rtcore/plan/lookahead_program.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve::plan::test {

struct OwnedJob {
    std::vector<std::byte> blob;
    JobView view;
};

inline JobTable random_table(std::mt19937_64& random, Joining joining, std::int64_t roughness,
                             std::uint32_t layers = 4) {
    JobTable table;
    table.layer_count = layers;
    table.point_count = 60;
    table.psi_sweep_pulses = 3200;
    table.joining = joining;
    table.feed_mm_s = 20.0;
    std::int64_t height = 100;
    for (std::uint32_t layer = 0; layer < table.layer_count; ++layer) {
        table.layer_height_pulses.push_back(height);
        height += 1 + static_cast<std::int64_t>(random() % 90);
        for (auto* radii : {&table.r_left_pulses, &table.r_right_pulses}) {
            auto radius = static_cast<std::int32_t>(5000 + random() % 2000);
            for (std::uint32_t point = 0; point < table.point_count; ++point) {
                const auto step =
                    static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * roughness + 1));
                radius += static_cast<std::int32_t>(step - roughness);
                radii->push_back(radius);
            }
        }
    }
    table.profile_toml = profile_to_toml(Profile{});
    return joining == Joining::spiral ? spiral_of(table) : table;
}

inline std::shared_ptr<const JobView> job_of(const JobTable& table) {
    auto owned = std::make_shared<OwnedJob>();
    owned->blob = job_blob_from_table(table);
    const auto view = JobView::check(owned->blob);
    EXPECT_TRUE(view);
    owned->view = *view;
    return {owned, &owned->view};
}

inline std::vector<cycle::MotionBlock> blocks_of(const std::shared_ptr<const JobView>& job,
                                                 std::uint32_t first_layer = 0,
                                                 std::uint32_t end_layer = kLastLayer) {
    LookaheadProgram program(machine_limits(Profile{}), job, {first_layer, end_layer});
    std::vector<cycle::MotionBlock> blocks;
    cycle::MotionBlock block;
    while (program.next(block)) blocks.push_back(block);
    return blocks;
}

inline Pulses4 point_of(const JobView& job, std::uint32_t layer, std::uint32_t point) {
    return {job.r_left_pulses(layer)[point], job.r_right_pulses(layer)[point], job.psi_pulses(layer, point),
            job.y_pulses(layer, point)};
}

}  // namespace psicarve::plan::test
