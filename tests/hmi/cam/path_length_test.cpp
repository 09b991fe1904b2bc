// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/path_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shared/profile/profile.hpp"

namespace psicarve::cam {
namespace {

constexpr double kPulsesPerMm = 400.0;  // of all linear axes of the built-in profile

/// Layers of three points, one after the other at constant radii [mm].
JobTable rings(const std::vector<double>& r1_mm, const std::vector<double>& r2_mm,
               const std::vector<double>& heights_mm) {
    const Profile profile;
    EXPECT_EQ(profile.r1.pulses_per_mm, kPulsesPerMm);
    JobTable table;
    table.layer_count = static_cast<std::uint32_t>(r1_mm.size());
    table.point_count = 3;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.feed_mm_s = 20.0;
    for (std::size_t layer = 0; layer < r1_mm.size(); ++layer) {
        table.layer_height_pulses.push_back(static_cast<std::int64_t>(heights_mm[layer] * kPulsesPerMm));
        table.r_left_pulses.insert(table.r_left_pulses.end(), 3,
                                   static_cast<std::int32_t>(r1_mm[layer] * kPulsesPerMm));
        table.r_right_pulses.insert(table.r_right_pulses.end(), 3,
                                    static_cast<std::int32_t>(r2_mm[layer] * kPulsesPerMm));
    }
    table.profile_toml = profile_to_toml(profile);
    return table;
}

std::vector<LayerPath> paths_of(const JobTable& table, const Profile& profile) {
    const auto blob = job_blob_from_table(table);
    const JobView job = JobView::check(blob).value();
    return layer_paths(job, profile, least_time_of(job, profile));
}

TEST(PathLength, IsHalfATurnALayerAndTheLinksBetweenThem) {
    // R1 goes in by 2 mm and out by 1, R2 stays; Y rises by 1.5 mm and by 0.5.
    const auto paths = paths_of(rings({10.0, 8.0, 9.0}, {6.0, 6.0, 6.0}, {1.0, 2.5, 3.0}), Profile{});
    ASSERT_EQ(paths.size(), 3U);
    for (std::size_t layer = 0; layer < 3; ++layer) {
        EXPECT_NEAR(paths[layer].cutting_mm[0],
                    std::numbers::pi * (layer == 0   ? 10.0
                                        : layer == 1 ? 8.0
                                                     : 9.0),
                    1e-9);
        EXPECT_NEAR(paths[layer].cutting_mm[1], std::numbers::pi * 6.0, 1e-9);
    }
    EXPECT_EQ(paths[0].link_mm, (std::array{0.0, 0.0})) << "the approach is no link";
    EXPECT_EQ(paths[1].link_mm, (std::array{2.0 + 1.5, 1.5}));
    EXPECT_EQ(paths[2].link_mm, (std::array{1.0 + 0.5, 0.5}));
}

TEST(PathLength, BetweenTwoPassesGoesOutOfTheBlankAndInAgain) {
    Profile profile;
    profile.blank.radius_mm = 12.0;
    profile.job.clearance_mm = 3.0;
    JobTable table = rings({10.0, 8.0}, {10.0, 7.0}, {4.0, 1.0});
    table.passes = {{static_cast<std::uint32_t>(PassKind::roughing), 1, 0, 1, 0.3, 2.0, 12.0},
                    {static_cast<std::uint32_t>(PassKind::finishing), 2, 1, 1, 0.0, 0.0, 12.0}};
    const auto paths = paths_of(table, profile);
    // Out to 15 mm, 3 mm down, in.
    EXPECT_EQ(paths[1].link_mm, (std::array{5.0 + 3.0 + 7.0, 5.0 + 3.0 + 8.0}));
}

TEST(PathLength, OfASpiralRisesAlongItsRowsAndHasNoLinks) {
    JobTable table = rings({10.0, 10.0, 10.0}, {10.0, 10.0, 10.0}, {1.0, 3.0, 3.0});
    table.joining = Joining::spiral;
    const auto paths = paths_of(table, Profile{});
    EXPECT_NEAR(paths[0].cutting_mm[0], std::numbers::pi * 10.0, 1e-9);
    EXPECT_NEAR(paths[1].cutting_mm[0], std::hypot(std::numbers::pi * 10.0, 2.0), 1e-9);
    EXPECT_NEAR(paths[2].cutting_mm[1], std::numbers::pi * 10.0, 1e-9);
    for (const LayerPath& path : paths) EXPECT_EQ(path.link_mm, (std::array{0.0, 0.0}));
}

}  // namespace
}  // namespace psicarve::cam
