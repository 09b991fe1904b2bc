// SPDX-License-Identifier: GPL-3.0-or-later
// Where a roughing pass says that neither head cuts, neither does.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "hmi/rough/roughing.hpp"
#include "tests/hmi/rough/brute_stock.hpp"
#include "tests/hmi/rough/rough_tables.hpp"

namespace psicarve::rough {
namespace {

struct Body {
    std::uint64_t seed;
    ToolShape shape;
    Joining joining;
    double angle_error_deg;
    double off_axis_mm;
};

class AirOfRandomTables : public ::testing::TestWithParam<Body> {
protected:
    AirOfRandomTables() : profile(profile_with(GetParam().shape)) {
        profile.head_r2_angle_error_deg = GetParam().angle_error_deg;
        profile.blank.offset_x_mm = GetParam().off_axis_mm;
    }
    JobTable table() const {
        const double pitch_mm = GetParam().shape == ToolShape::point ? 0.5 : 0.4;
        // On two sides far out: there both heads have nothing to do once they have been.
        const TipRadius body = random_body(GetParam().seed);
        const TipRadius wide = [body](double direction, double height_mm) {
            return std::abs(std::sin(direction)) > 0.6 ? 9.2 : body(direction, height_mm);
        };
        return table_of(profile, 12, pitch_mm, GetParam().joining, wide);
    }

    Profile profile;
};

TEST_P(AirOfRandomTables, IsClearOfAStockThatIsCarvedByTheToolsDefinition) {
    JobTable roughed_table = table();
    const RoughingSummary summary = roughed(roughed_table, profile, {1.6, 0.3, {}});
    const auto blob = job_blob_from_table(roughed_table);
    const auto checked = JobView::check(blob);
    ASSERT_TRUE(checked) << checked.error().message;
    const JobView& job = *checked;
    brute::Stock stock(profile, roughed_table, 28, 64);
    // Further in than that the planner's cells no longer tell.
    constexpr double kClear_mm = 0.06;
    std::uint64_t ways = 0;
    for (std::uint32_t layer = 0; layer < job.finishing_layer(); ++layer) {
        brute::Stock tried = stock;
        for (std::uint32_t step = 0; step + 1 < job.point_count(); ++step) {
            const std::uint32_t from = carved_point(job.joining(), job.point_count(), layer, step);
            const std::uint32_t to = carved_point(job.joining(), job.point_count(), layer, step + 1);
            if (!job.is_air(layer, from) || !job.is_air(layer, to)) continue;
            ++ways;
            tried.carve_way(job, layer, step, kClear_mm);
            ASSERT_EQ(tried.removed_mm(), stock.removed_mm()) << "layer " << layer << ", step " << step;
        }
        stock.carve(job, layer, layer + 1);
    }
    EXPECT_GE(ways, 40U);
    std::uint64_t told = 0;
    for (const PassSummary& pass : summary.passes) told += pass.air_ways;
    EXPECT_EQ(told, ways);
    for (std::uint32_t layer = job.finishing_layer(); layer < job.layer_count(); ++layer) {
        for (std::uint32_t point = 0; point < job.point_count(); ++point)
            ASSERT_FALSE(job.is_air(layer, point));
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AirOfRandomTables,
                         ::testing::Values(Body{1, ToolShape::point, Joining::continuous, 0.0, 0.0},
                                           Body{2, ToolShape::point, Joining::zigzag, 0.0, 1.5},
                                           Body{3, ToolShape::ball, Joining::continuous, 0.0, 0.0},
                                           Body{4, ToolShape::ball, Joining::zigzag, 0.0, 1.5},
                                           Body{5, ToolShape::flat, Joining::continuous, 0.0, 1.5},
                                           Body{6, ToolShape::vee, Joining::zigzag, 0.0, 0.0},
                                           Body{7, ToolShape::ball, Joining::continuous, 0.7, 1.5},
                                           Body{8, ToolShape::flat, Joining::zigzag, 0.0, 0.0}),
                         [](const auto& named) { return "Seed" + std::to_string(named.param.seed); });

TEST(Air, IsNoneWhereAHeadCutsAllTheWay) {
    const Profile profile = profile_with(ToolShape::ball);
    // One head cuts, the other one is parked: all of it at the feed.
    const TipRadius half = [](double direction, double) { return std::sin(direction) > -0.01 ? 9.6 : 6.0; };
    JobTable table = table_of(profile, 6, 0.4, Joining::zigzag, half);
    const RoughingSummary summary = roughed(table, profile, {4.0, 0.3, {}});
    ASSERT_EQ(summary.passes.size(), 1U);
    EXPECT_GT(summary.passes[0].air_points, 0U);
    const auto blob = job_blob_from_table(table);
    const auto job = JobView::check(blob);
    ASSERT_TRUE(job) << job.error().message;
    // What the two of them share at their halves' ends is little.
    EXPECT_LE(summary.passes[0].air_ways, summary.passes[0].layers);
}

TEST(Air, IsToldAsAShareOfTheWays) {
    RoughingSummary summary;
    summary.passes = {{5.0, 2, 10, 30, 40, 10}, {4.0, 1, 10, 10, 20, 20}};
    const std::string text = to_json(summary, {});
    EXPECT_NE(text.find("\"rapid_share\":0.25"), std::string::npos) << text;
    EXPECT_NE(text.find("\"rapid_share\":1.0"), std::string::npos) << text;
    EXPECT_NE(text.find("\"rapid_share\":0.5"), std::string::npos) << text;
}

}  // namespace
}  // namespace psicarve::rough
