// SPDX-License-Identifier: GPL-3.0-or-later
// Spirals whose Y rises pulses at a time over each one of the table, corners cut by whole millimetres, and
// flanks where a head's pulse is coarser than the tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>

#include "hmi/cam/job_builder.hpp"
#include "hmi/model/load_mesh.hpp"
#include "hmi/verify/verify_report.hpp"
#include "tests/motion/carving_bench.hpp"
#include "tests/places.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::motion {
namespace {

Profile coarse_profile(std::int64_t pulses_per_rev) {
    Profile profile = cycle::quick_profile();
    profile.job.planner = Planner::lookahead;
    profile.psi.pulses_per_rev = pulses_per_rev;
    return profile;
}

JobTable steep_spiral(const Profile& profile, const Shape& shape, std::uint32_t points,
                      std::int64_t rise_a_row) {
    JobTable table = table_of(profile, shape, 4, points, Joining::spiral);
    for (std::uint32_t layer = 0; layer < table.layer_count; ++layer) {
        const std::uint32_t row = layer + 1 < table.layer_count ? layer : layer - 1;
        table.layer_height_pulses[layer] = 200 + rise_a_row * row;
    }
    return table;
}

struct Steep {
    std::int64_t pulses_per_rev;
    std::int64_t rise_a_turn;  ///< Y's pulses over one of psi's
    std::uint32_t points;
};

class SteepSpirals : public ::testing::TestWithParam<Steep> {};

TEST_P(SteepSpirals, ObeyTheFourRules) {
    const Profile profile = coarse_profile(GetParam().pulses_per_rev);
    const std::int64_t rise_a_row = GetParam().rise_a_turn * GetParam().pulses_per_rev / 2 + 7;
    for (const NamedShape& shape : sample_shapes()) {
        const Carved result =
            carved(profile, steep_spiral(profile, shape.shape, GetParam().points, rise_a_row));
        EXPECT_TRUE(result.report.ok) << shape.name << '\n' << verify::report_text(result.report);
    }
}

INSTANTIATE_TEST_SUITE_P(CoarseTables, SteepSpirals,
                         ::testing::Values(Steep{3200, 0, 60}, Steep{800, 1, 60}, Steep{800, 2, 200},
                                           Steep{400, 2, 30}, Steep{400, 5, 60}, Steep{200, 5, 100},
                                           Steep{200, 12, 30}),
                         [](const auto& named) {
                             return std::to_string(named.param.pulses_per_rev) + "Rising" +
                                    std::to_string(named.param.rise_a_turn) + "Of" +
                                    std::to_string(named.param.points);
                         });

class WideTolerances : public ::testing::TestWithParam<Joining> {};

TEST_P(WideTolerances, ObeyTheFourRules) {
    Profile profile = coarse_profile(3200);
    for (const double tolerance_mm : {0.3, 1.0, 10.0}) {
        if (!test::is_thorough() && tolerance_mm != 1.0) continue;
        profile.job.path_tolerance_mm = tolerance_mm;
        for (const NamedShape& shape : sample_shapes()) {
            for (const std::uint32_t points : {20U, 60U, 200U}) {
                if (!test::is_thorough() && points != 60U) continue;
                const Carved result = carved(profile, table_of(profile, shape.shape, 2, points, GetParam()));
                EXPECT_TRUE(result.report.ok)
                    << shape.name << " with " << points << " points, tolerance " << tolerance_mm << '\n'
                    << verify::report_text(result.report);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(CoarseTables, WideTolerances,
                         ::testing::Values(Joining::continuous, Joining::zigzag, Joining::spiral),
                         [](const auto& named) { return "Case" + std::to_string(named.index); });

/// Teeth 3 mm high, with a gap opposite each, and no two flanks alike: one head is halfway up where the other
/// begins.
double teeth_mm(double direction, std::uint32_t layer) {
    const double along = 7.0 * direction + 0.03 * std::cos(direction) + 0.01 * layer;
    const double steepness = 25.0 + 10.0 * std::sin(3.0 * direction);
    return 10.2 + 3.0 * std::clamp(0.5 + steepness * std::sin(along), 0.0, 1.0);
}

/// Another radius, by up to 1 mm, at every point.
double noise_mm(double direction, std::uint32_t layer) {
    const double mixed = std::sin(1e4 * direction + layer) * 43758.5453;
    return 10.0 + 2.0 * (mixed - std::floor(mixed) - 0.5);
}

struct CoarseHead {
    const char* name;
    Shape shape;
    double tolerance_mm;
    double right_pulses_per_mm;
    std::uint32_t points;
    Joining joining = Joining::continuous;
};

class Boundaries : public ::testing::TestWithParam<CoarseHead> {};

// Cut on the chord, the heads and the table are at one place of it: no head may be far ahead of that by its
// curve.
TEST_P(Boundaries, OfHeadsCoarserThanTheToleranceObeyTheFourRules) {
    Profile profile;
    profile.job.path_tolerance_mm = GetParam().tolerance_mm;
    profile.r2.pulses_per_mm = GetParam().right_pulses_per_mm;
    const Carved result =
        carved(profile, table_of(profile, GetParam().shape, 4, GetParam().points, GetParam().joining));
    EXPECT_TRUE(result.report.ok) << verify::report_text(result.report);
}

INSTANTIATE_TEST_SUITE_P(CoarseTables, Boundaries,
                         ::testing::Values(CoarseHead{"TeethRightCoarse", teeth_mm, 0.01, 90.0, 300},
                                           CoarseHead{"Teeth", teeth_mm, 0.002, 400.0, 500},
                                           CoarseHead{"TeethDense", teeth_mm, 0.0024, 400.0, 1500},
                                           CoarseHead{"TeethSpiral", teeth_mm, 0.002, 400.0, 150,
                                                      Joining::spiral},
                                           CoarseHead{"Noise", noise_mm, 0.002, 400.0, 300}),
                         [](const auto& named) { return std::string{named.param.name}; });

/// Three points a layer, far apart, and high layers: Y is at its top speed where a link has its middle.
JobTable three_points_a_layer(const Profile& profile, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto pick = [&](std::uint64_t least, std::uint64_t span) { return least + random() % span; };
    JobTable table = table_of(
        profile, [](double, std::uint32_t) { return 10.0; }, 6, 3);
    std::int64_t height = 200;
    for (std::uint32_t layer = 0; layer < table.layer_count; ++layer) {
        table.layer_height_pulses[layer] = height;
        height += static_cast<std::int64_t>(pick(400, 3600));
    }
    for (std::size_t i = 0; i < table.r_left_pulses.size(); ++i) {
        table.r_left_pulses[i] = static_cast<std::int32_t>(pick(2000, 7000));
        table.r_right_pulses[i] = static_cast<std::int32_t>(pick(2000, 7000));
    }
    return table;
}

/// How close Y's pulses follow each other.
struct Following {
    std::uint64_t least_ticks = ~std::uint64_t{0};
    double most_ahead = 0.0;  ///< of a motion at top speed, over any of its ways [pulses]
};

Following following_of(const Profile& profile, const JobTable& table) {
    const double pulses_a_tick =
        axis_motion(profile, Axis::y).speed_pps * 1e-9 * static_cast<double>(tick_period_ns(profile));
    Following following;
    std::uint64_t tick = 0;
    std::uint64_t last = 0;
    std::int64_t at = 0;
    double ahead = 0.0;
    const Carved result = carved(profile, table, [&](cycle::MachineRig& rig) {
        const std::int64_t now = rig.positions()[kY];
        ++tick;
        if (now == std::exchange(at, now)) return;
        if (last != 0) {
            following.least_ticks = std::min(following.least_ticks, tick - last);
            ahead = std::max(0.0, ahead) + 1.0 - pulses_a_tick * static_cast<double>(tick - last);
            following.most_ahead = std::max(following.most_ahead, ahead);
        }
        last = tick;
    });
    EXPECT_TRUE(result.report.ok) << verify::report_text(result.report);
    return following;
}

// At top speed a pulse of Y comes every 5 ticks. Where the path has a point the count is rounded to a whole
// pulse: half a pulse that Y is behind there is made up for in one interval, and no motor takes note.
TEST(ThreePointsALayer, YsPulsesAreNeverAheadOfItsTopSpeedByMoreThanAPulseAndATick) {
    const Profile profile;
    std::uint64_t least_ticks = ~std::uint64_t{0};
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}) {
        const Following sut = following_of(profile, three_points_a_layer(profile, seed));
        EXPECT_LE(sut.most_ahead, 1.1) << seed << ": 0.45 pulses at either end, and a tick";
        least_ticks = std::min(least_ticks, sut.least_ticks);
    }
    EXPECT_LT(least_ticks, 4U) << "more than rounding to ticks";
    EXPECT_GE(least_ticks, 2U);
}

// Some ticks pass until an edge is heeded: that way is part of the one that rule 4 grants.
TEST(Homing, RunsNoFurtherPastASensorThanSlowingDownFromHomeSpeedTakes) {
    for (const double speed_mm_s : {2.1, 2.1375, 2.2}) {
        Profile profile;
        profile.job.feed_mm_s = 3.0;
        profile.psi.pulses_per_rev = 20'000;
        for (LinearAxisProfile* axis : {&profile.r1, &profile.r2}) {
            axis->pulses_per_mm = 4000.0;
            axis->accel_mm_s2 = 20.0;
            axis->speed_mm_s = axis->home_speed_mm_s = speed_mm_s;
            axis->start_stop_mm_s = 0.05;
            axis->home_position_mm = axis->travel_mm[1] = 30.0;
        }
        const Carved result = carved(profile, table_of(profile, sample_shapes()[0].shape, 1, 8));
        EXPECT_TRUE(result.report.ok) << speed_mm_s << '\n' << verify::report_text(result.report);
    }
}

// Where a head and the table both go about as fast as they can, a pulse that waits for its io period is late
// by more than it lasts.
TEST(TwoTimers, ObeyTheFourRulesAtTheMotorsTopSpeeds) {
    struct Case {
        double speed_mm_s;
        std::uint32_t layers;
        std::uint32_t points;
    };
    const auto mesh = model::load_mesh(example("small.stl"));
    ASSERT_TRUE(mesh);
    for (const Case& tried : {Case{4.2, 12, 30}, Case{4.4, 9, 60}, Case{4.0, 9, 60}}) {
        if (!test::is_thorough() && tried.layers != 12) continue;
        Profile profile;
        profile.tick.schedule = Schedule::two_timer;
        for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
            axis->speed_mm_s = tried.speed_mm_s;
            axis->home_speed_mm_s = 2.0;
        }
        profile.psi.speed_deg_s = 112.0;
        profile.psi.home_speed_deg_s = 30.0;
        cam::JobOptions options;
        options.height_mm = 20.0;
        options.layer_count = tried.layers;
        options.point_count = tried.points;
        const auto job = cam::build_job(*mesh, profile, options);
        ASSERT_TRUE(job);
        const Carved result = carved(profile, job->table);
        EXPECT_TRUE(result.report.ok) << tried.speed_mm_s << " mm/s, " << tried.points << " points\n"
                                      << verify::report_text(result.report);
    }
}

}  // namespace
}  // namespace psicarve::motion
