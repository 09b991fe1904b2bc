// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/rough/roughing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "hmi/rough/pass_planner.hpp"
#include "tests/hmi/rough/brute_stock.hpp"
#include "tests/hmi/rough/rough_tables.hpp"

namespace psicarve::rough {
namespace {

using testing::HasSubstr;

Profile profile_with(ToolShape shape, double diameter_mm = 3.0) {
    Profile profile;
    profile.tool = {shape, diameter_mm, 70.0, 0.0};
    profile.blank = {.radius_mm = 10.0, .height_mm = 0.0};
    return profile;
}

TEST(Roughing, HasAsManyLayersAsThereIsSomethingToRemove) {
    const Profile profile = profile_with(ToolShape::point);
    // Below 9 mm a waist; above, the body leaves nothing of the blank but its allowance.
    const TipRadius body = [](double, double height_mm) { return height_mm < 9.0 ? 6.0 : 9.8; };
    JobTable table = table_of(profile, 20, 0.5, Joining::continuous, body);
    const RoughingSummary summary = roughed(table, profile, {1.5, 0.4, {}});
    // 8.5, 7 and 6.4 mm: ten layers each.
    ASSERT_EQ(summary.passes.size(), 3U);
    EXPECT_EQ(table.layer_count, 50U);
    const auto blob = job_blob_from_table(table);
    const JobView job = checked_view(blob, profile);
    ASSERT_EQ(job.passes().size(), 4U);
    const std::vector<std::int32_t> wanted{3400, 2800, 2560};
    for (std::uint32_t pass = 0; pass < 3; ++pass) {
        EXPECT_EQ(job.passes()[pass].layer_count, 10U);
        EXPECT_EQ(job.passes()[pass].clear_mm, 10.0);
        for (std::uint32_t layer = 10 * pass; layer < 10 * (pass + 1); ++layer) {
            EXPECT_EQ(job.layer_heights_pulses()[layer], 1600 + 200 * (layer % 10));
            for (std::uint32_t point = 0; point < kPoints; ++point) {
                // Each head's last point of a layer is cut already: by the other one, there in the beginning.
                const bool is_shared = point == 0 || point + 1 == kPoints;
                const std::int32_t radius = job.r_left_pulses(layer)[point];
                EXPECT_TRUE(radius == wanted[pass] || (is_shared && radius > wanted[pass]))
                    << layer << ' ' << point << ' ' << radius;
            }
        }
    }
}

TEST(Roughing, LayersAreAsFarApartAsTheStepoverSays) {
    const Profile profile = profile_with(ToolShape::ball);
    JobTable table = table_of(profile, 20, 0.5, Joining::zigzag, [](double, double) { return 7.0; });
    const RoughingSummary summary = roughed(table, profile, {5.0, 0.5, 1.5});
    ASSERT_EQ(summary.passes.size(), 1U);
    const auto blob = job_blob_from_table(table);
    const JobView job = checked_view(blob, profile);
    const std::vector<std::int64_t> rings{0, 3, 5, 8, 11, 14, 16, 19};
    ASSERT_EQ(job.finishing_layer(), rings.size());
    for (std::uint32_t layer = 0; layer < rings.size(); ++layer)
        EXPECT_EQ(job.layer_heights_pulses()[layer], 1600 + 200 * rings[layer]) << layer;
}

TEST(Roughing, AnOddNumberOfHalfTurnsBeforeItLeavesTheFinishingPassWhatItWas) {
    const Profile profile = profile_with(ToolShape::point);
    const TipRadius lopsided = [](double direction, double) { return 7.0 + std::cos(direction); };
    const JobTable before = table_of(profile, 3, 0.5, Joining::continuous, lopsided);
    JobTable table = before;
    roughed(table, profile, {4.0, 0.0, {}});
    ASSERT_EQ(table.passes.back().first_layer % 2, 1U);
    const std::size_t first = table.passes.back().first_layer * std::size_t{kPoints};
    for (std::size_t i = 0; i < before.r_left_pulses.size(); ++i) {
        EXPECT_EQ(table.r_left_pulses[first + i], before.r_right_pulses[i]);
        EXPECT_EQ(table.r_right_pulses[first + i], before.r_left_pulses[i]);
    }
}

TEST(Roughing, WhereTheHeadsStandAskewAnIdleLayerMakesTheirHalvesMeet) {
    Profile profile = profile_with(ToolShape::point);
    profile.head_r2_angle_error_deg = 0.5;
    const TipRadius lopsided = [](double direction, double) { return 7.0 + std::cos(direction); };
    const JobTable before = table_of(profile, 3, 0.5, Joining::continuous, lopsided);
    JobTable table = before;
    roughed(table, profile, {4.0, 0.0, {}});
    EXPECT_EQ(table.passes.back().first_layer, 4U);
    EXPECT_EQ(table.passes[1].number, 1U);
    const std::size_t first = 4 * std::size_t{kPoints};
    EXPECT_TRUE(std::equal(before.r_left_pulses.begin(), before.r_left_pulses.end(),
                           table.r_left_pulses.begin() + static_cast<std::ptrdiff_t>(first)));
}

// Without that the other head's radius would be the worn tip's, past its travel or inside the core.
TEST(Roughing, AHeadThatTakesTheOthersHalfKeepsItsOwnLeastRadius) {
    Profile profile = profile_with(ToolShape::point);
    profile.r2.tool_wear_mm = 0.4;
    profile.r2.travel_mm[0] = 1.5;
    JobTable before = table_of(profile, 3, 0.5, Joining::continuous, [](double, double) { return 1.8; });
    for (std::int32_t& radius : before.r_right_pulses) radius = std::max(radius, 600);
    // The second of two passes of three layers has the halves changed, and leaves nothing.
    JobTable even = before;
    roughed(even, profile, {4.1, 0.0, {}});
    EXPECT_EQ(even.passes.back().first_layer, 6U);
    checked_view(job_blob_from_table(even), profile);
    // After three passes the finishing pass has.
    JobTable odd = before;
    roughed(odd, profile, {3.0, 0.3, {}});
    ASSERT_EQ(odd.passes.back().first_layer, 9U);
    const auto blob = job_blob_from_table(odd);
    const JobView job = checked_view(blob, profile);
    for (std::uint32_t point = 0; point < kPoints; ++point) {
        EXPECT_EQ(job.r_left_pulses(9)[point], 760);
        EXPECT_EQ(job.r_right_pulses(9)[point], 600);
    }
}

TEST(Roughing, WhereAHeadDoesNotReachTheOthersHalfAnIdleLayerKeepsTheHalvesAsTheyWere) {
    Profile profile = profile_with(ToolShape::point);
    profile.r2.travel_mm[1] = 8.5;
    profile.blank.radius_mm = 8.4;  // the model stands out of it, where R1 alone gets
    // From layer to layer the other side stands out: always R1's.
    const TipRadius turning = [](double direction, double height_mm) {
        const bool is_odd = std::lround((height_mm - 4.0) / 0.5) % 2 != 0;
        return 7.0 + 2.0 * std::max(0.0, (is_odd ? -1.0 : 1.0) * std::sin(direction));
    };
    const JobTable before = table_of(profile, 3, 0.5, Joining::continuous, turning);
    JobTable table = before;
    roughed(table, profile, {4.0, 0.0, {}});
    ASSERT_EQ(table.passes.size(), 3U);
    EXPECT_EQ(table.passes[0].layer_count, 3U);
    EXPECT_EQ(table.passes.back().first_layer, 4U);
    EXPECT_EQ(table.layer_height_pulses[3], before.layer_height_pulses[1]);
    const auto blob = job_blob_from_table(table);
    const JobView job = checked_view(blob, profile);
    EXPECT_TRUE(
        std::equal(before.r_left_pulses.begin(), before.r_left_pulses.end(), job.r_left_pulses(4).begin()));
}

TEST(Roughing, ABlankWithNothingToRemoveGetsNoPass) {
    const Profile profile = profile_with(ToolShape::ball);
    JobTable table = table_of(profile, 5, 0.5, Joining::continuous, [](double, double) { return 9.9; });
    EXPECT_TRUE(roughed(table, profile, {2.0, 0.3, {}}).passes.empty());
    EXPECT_TRUE(table.passes.empty());
    EXPECT_EQ(table.layer_count, 5U);
}

TEST(Roughing, NumbersThatMakeNoSenseAreRefused) {
    const auto refusal = [](const RoughingOptions& options, const Profile& profile) {
        const auto checked = check_options(options, profile);
        return checked ? std::string{"accepted"} : checked.error().message;
    };
    const Profile ball = profile_with(ToolShape::ball);
    EXPECT_EQ(refusal({1.0, 0.0, 3.0}, ball), "accepted");
    for (const double none_mm : {0.0, -1.0, 10'001.0, double{NAN}})
        EXPECT_THAT(refusal({none_mm, 0.3, {}}, ball), HasSubstr("the stepdown must be more than 0 mm"));
    for (const double none_mm : {-0.1, 10'001.0, double{NAN}})
        EXPECT_THAT(refusal({1.0, none_mm, {}}, ball), HasSubstr("the allowance must be 0 to 10000 mm"));
    EXPECT_THAT(refusal({1.0, 0.3, 0.0}, ball), HasSubstr("the stepover must be more than 0 mm"));
    EXPECT_THAT(refusal({1.0, 0.3, NAN}, ball), HasSubstr("the stepover must be more than 0 mm"));
    EXPECT_THAT(refusal({1.0, 0.3, 3.1}, ball), HasSubstr("more than the tool is wide, 3 mm"));
    EXPECT_THAT(refusal({1.0, 0.3, 1.0}, profile_with(ToolShape::point)), HasSubstr("a point carves"));
    Profile without = ball;
    without.blank = {};
    EXPECT_THAT(refusal({1.0, 0.3, {}}, without), HasSubstr("--blank RADIUSxHEIGHT"));
    JobTable table = table_of(ball, 3, 0.5, Joining::continuous, [](double, double) { return 5.0; });
    const JobTable own = table;
    const auto many = add_roughing(table, own, ball, {0.001, 0.3, {}});
    ASSERT_FALSE(many);
    EXPECT_THAT(many.error().message, HasSubstr("makes more than 1022 passes"));
}

TEST(Roughing, ABlankThatTheHeadsDoNotReachAroundIsCalledThat) {
    Profile profile = profile_with(ToolShape::ball);
    profile.blank.radius_mm = 65.0;
    JobTable table = table_of(profile, 3, 0.5, Joining::continuous, [](double, double) { return 7.0; });
    const JobTable level = table;
    const auto refused = add_roughing(table, level, profile, {2.0, 0.5, {}});
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().message,
              "the blank reaches out to 65.00 mm, but head r1 only to 60.00 mm: it would stand in the blank "
              "before the carving begins; take a smaller blank");
}

TEST(Roughing, APassThatGoesAllTheWayInHasNoDepthBelowTheAxis) {
    const Profile profile = profile_with(ToolShape::ball);
    JobTable table = table_of(profile, 3, 0.5, Joining::continuous, [](double, double) { return 7.0; });
    const RoughingSummary summary = roughed(table, profile, {14.0, 0.5, {}});
    ASSERT_EQ(summary.passes.size(), 1U);
    EXPECT_EQ(summary.passes[0].depth_mm, 0.0);
}

TEST(Roughing, IsWhatTheProfileAsksFor) {
    Profile profile = profile_with(ToolShape::ball);
    EXPECT_FALSE(wanted_roughing(profile)) << "none, as long as nobody asks";
    profile.roughing = {2.0, 0.25, 0.0};
    ASSERT_TRUE(wanted_roughing(profile));
    EXPECT_EQ(wanted_roughing(profile)->stepdown_mm, 2.0);
    EXPECT_EQ(wanted_roughing(profile)->allowance_mm, 0.25);
    EXPECT_FALSE(wanted_roughing(profile)->stepover_mm) << "as the tool allows";
    profile.roughing.stepover_mm = 1.25;
    EXPECT_EQ(wanted_roughing(profile)->stepover_mm, 1.25);
    profile.tool.shape = ToolShape::point;
    EXPECT_FALSE(wanted_roughing(profile)->stepover_mm) << "a point carves every layer";
}

struct Sweep {
    std::uint64_t seed;
    ToolShape shape;
    Joining joining;
    double angle_error_deg;
    double allowance_mm;
};

class RandomTables : public ::testing::TestWithParam<Sweep> {};

/// Against a stock that is carved by the tool's definition, pass by pass.
TEST_P(RandomTables, AreRoughedNoDeeperThanTheFinishAndNoFurtherAtOnceThanTheStepdown) {
    const Sweep& sweep = GetParam();
    Profile profile = profile_with(sweep.shape);
    profile.head_r2_angle_error_deg = sweep.angle_error_deg;
    const double pitch_mm = sweep.shape == ToolShape::point ? 0.5 : 0.4;
    const TipRadius body = random_body(sweep.seed);
    const JobTable finishing = table_of(profile, 12, pitch_mm, sweep.joining, body);
    JobTable table = finishing;
    const double stepdown_mm = 1.6;
    const RoughingSummary summary = roughed(table, profile, {stepdown_mm, sweep.allowance_mm, {}});
    ASSERT_GE(summary.passes.size(), 2U);
    const auto blob = job_blob_from_table(table);
    const JobView job = checked_view(blob, profile);

    brute::Stock finished(profile, table, 28, 64);
    // What a tool's side has passed under falls with the next time.
    for (int time = 0; time < 3; ++time) finished.carve(job, job.finishing_layer(), job.layer_count());
    brute::Stock stock(profile, table, 28, 64);
    std::uint32_t idle_layers = 0;
    const double ridge = ridge_mm(profile.tool, summary.stepover_mm);
    for (const JobPass& pass : job.passes().first(job.passes().size() - 1)) {
        const std::vector<double> before = stock.radius_mm;
        for (std::uint32_t layer = pass.first_layer; layer < pass.first_layer + pass.layer_count; ++layer) {
            const double had = stock.removed_mm();
            stock.carve(job, layer, layer + 1);
            if (stock.removed_mm() <= had) ++idle_layers;
        }
        stock.carve(job, pass.first_layer, pass.first_layer + pass.layer_count);  // and the ways between them
        double most_mm = 0.0;
        for (std::size_t i = 0; i < before.size(); ++i) {
            ASSERT_GE(stock.radius_mm[i],
                      std::min(profile.blank.radius_mm, finished.radius_mm[i] + sweep.allowance_mm) - 0.021)
                << pass_name(pass) << ", row " << i / stock.columns() << ", column " << i % stock.columns();
            ASSERT_GE(stock.radius_mm[i], pass.depth_mm - 0.011);
            most_mm = std::max(most_mm, before[i] - stock.radius_mm[i]);
        }
        EXPECT_LE(most_mm, stepdown_mm * 1.25 + ridge + 0.1) << pass_name(pass);
    }
    // One that makes an even number of half turns, and one whose crumbs fall between the places looked at.
    EXPECT_LE(idle_layers, sweep.angle_error_deg != 0.0 ? 2U : 1U);
    RecordProperty("passes", static_cast<int>(summary.passes.size()));
}

/// What a head that has nothing to cut in a layer keeps between its tool and the stock (docs/roughing.md).
constexpr double kParkedClear_mm = 0.3;

TEST_P(RandomTables, KeepAHeadThatCutsNothingInALayerClearOfTheStock) {
    const Sweep& sweep = GetParam();
    Profile profile = profile_with(sweep.shape);
    profile.head_r2_angle_error_deg = sweep.angle_error_deg;
    const double pitch_mm = sweep.shape == ToolShape::point ? 0.5 : 0.4;
    // There is nothing to cut in one half turn: there a head is parked in every other layer, or in all.
    const TipRadius body = random_body(sweep.seed);
    const TipRadius half = [&body](double direction, double height_mm) {
        return std::sin(direction) > -0.1 ? 9.5 : body(direction, height_mm);
    };
    JobTable table = table_of(profile, 12, pitch_mm, sweep.joining, half);
    roughed(table, profile, {3.0, 0.4, {}});
    ASSERT_GE(table.passes.size(), 2U);
    const auto blob = job_blob_from_table(table);
    const JobView job = checked_view(blob, profile);
    brute::Stock stock(profile, table, 28, 64);
    // The stock's steps, and what stands between the cells that the planner looks at: under a vee's flank
    // more.
    const double steps_mm = sweep.shape == ToolShape::vee ? 0.08 : 0.03;
    int parked = 0;
    for (std::uint32_t layer = 0; layer < job.finishing_layer(); ++layer) {
        for (const Axis head : {Axis::r1, Axis::r2}) {
            brute::Stock tried = stock;
            // One that is in the cut touches it.
            tried.carve_head(job, layer, head, steps_mm);
            if (tried.removed_mm() > stock.removed_mm()) continue;
            ++parked;
            tried.carve_head(job, layer, head, kParkedClear_mm - steps_mm);
            EXPECT_EQ(tried.removed_mm(), stock.removed_mm())
                << "layer " << layer << ", head " << name_of(head);
        }
        stock.carve(job, layer, layer + 1);
    }
    EXPECT_GE(parked, 5);
}

// What is too little to be worth a cut may be more than a head is lifted by.
TEST(Roughing, AParkedHeadIsClearOfWhatIsLeftForTheNextPass) {
    const Profile profile = profile_with(ToolShape::ball);
    // With a stepdown of 8 mm 0.35 mm of stock are a trifle; behind 180 degrees there is much to do.
    const TipRadius body = [](double direction, double) { return std::sin(direction) > -0.01 ? 9.35 : 4.0; };
    JobTable table = table_of(profile, 6, 0.4, Joining::zigzag, body);
    const RoughingSummary summary = roughed(table, profile, {8.0, 0.3, {}});
    ASSERT_EQ(summary.passes.size(), 1U);
    const auto blob = job_blob_from_table(table);
    const JobView job = checked_view(blob, profile);
    constexpr double kCells_mm = 0.01;  // of the planner's map
    const std::int64_t clear = pulses_from_mm(10.0 + kParkedClear_mm - kCells_mm, profile.r1.pulses_per_mm);
    for (std::uint32_t layer = 0; layer < job.finishing_layer(); ++layer) {
        // Where both heads come, the other one has cut already.
        for (std::uint32_t point = 1; point + 1 < kPoints; ++point)
            EXPECT_GE(job.r_left_pulses(layer)[point], clear) << "layer " << layer << ", point " << point;
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomTables,
                         ::testing::Values(Sweep{1, ToolShape::point, Joining::continuous, 0.0, 0.3},
                                           Sweep{2, ToolShape::point, Joining::zigzag, 0.0, 0.0},
                                           Sweep{3, ToolShape::ball, Joining::continuous, 0.0, 0.3},
                                           Sweep{4, ToolShape::ball, Joining::zigzag, 0.0, 0.0},
                                           Sweep{5, ToolShape::flat, Joining::continuous, 0.0, 0.5},
                                           Sweep{6, ToolShape::vee, Joining::zigzag, 0.0, 0.2},
                                           Sweep{7, ToolShape::ball, Joining::continuous, 0.7, 0.3},
                                           Sweep{8, ToolShape::flat, Joining::zigzag, 0.0, 0.1}),
                         [](const auto& named) { return "Seed" + std::to_string(named.param.seed); });

}  // namespace
}  // namespace psicarve::rough
