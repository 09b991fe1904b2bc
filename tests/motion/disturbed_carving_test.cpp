// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "hmi/verify/verify_report.hpp"
#include "tests/motion/carving_bench.hpp"
#include "tests/motion/random_operator.hpp"
#include "tests/places.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::motion {
namespace {

using cycle::MachineRig;
using cycle::RequestKind;

/// The example's, with short ways to its sensors.
Profile fine_profile() {
    Profile profile = load_profile(example("fine.toml")).value();
    profile.r1.travel_mm = {0.0, 14.0};
    profile.r1.home_position_mm = 14.0;
    profile.r2.travel_mm = profile.r1.travel_mm;
    profile.r2.home_position_mm = profile.r1.home_position_mm;
    profile.y.travel_mm = {0.0, 10.0};
    profile.job.spindle_spinup_s = 0.01;
    profile.job.planner = Planner::lookahead;
    return profile;
}

Profile usual_profile() {
    Profile profile = cycle::quick_profile();
    profile.job.planner = Planner::lookahead;
    return profile;
}

void expect_obedience(const Profile& profile, const JobTable& table, std::uint64_t rounds) {
    const Carved undisturbed = carved(profile, table);
    ASSERT_TRUE(undisturbed.report.ok) << verify::report_text(undisturbed.report);
    for (const verify::RuleResult& rule : undisturbed.report.rules) EXPECT_TRUE(rule.judged);
    ::testing::Test::RecordProperty("seconds", std::to_string(undisturbed.carve_s));
    ::testing::Test::RecordProperty("waited_ticks", std::to_string(undisturbed.waited_ticks));
    ::testing::Test::RecordProperty("iterations", std::to_string(undisturbed.iterations));
    for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
        const Carved disturbed = carved(profile, table, Operator(seed));
        ASSERT_TRUE(disturbed.report.ok) << "seed " << seed << '\n' << verify::report_text(disturbed.report);
        ASSERT_EQ(disturbed.order, undisturbed.order) << "seed " << seed;
    }
}

class Shapes : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Shapes, ObeyTheFourRulesThroughRandomHoldsResumesAndOverrides) {
    const Profile profile = usual_profile();
    expect_obedience(profile, table_of(profile, sample_shapes()[GetParam()].shape, 2, 100),
                     test::is_thorough() ? 10 : 1);
}

TEST_P(Shapes, ObeyThemAlongASpiralToo) {
    const Profile profile = usual_profile();
    const Shape shape = sample_shapes()[GetParam()].shape;
    expect_obedience(profile, table_of(profile, shape, 4, 100, Joining::spiral), test::is_thorough() ? 4 : 1);
}

INSTANTIATE_TEST_SUITE_P(DisturbedCarving, Shapes, ::testing::Range(std::size_t{0}, std::size_t{4}),
                         [](const auto& named) { return std::string{sample_shapes()[named.param].name}; });

// The heads have just come inwards when the carving takes them out again.
TEST(Carving, ObeysTheFourRulesWhenItBeginsAtOnceAndOutwards) {
    Profile profile = usual_profile();
    profile.job.path_tolerance_mm = 0.1;
    for (const NamedShape& shape : sample_shapes()) {
        if (std::string{shape.name} != "gear") continue;
        const Carved result = carved(profile, table_of(profile, shape.shape, 2, 101, Joining::spiral));
        EXPECT_TRUE(result.report.ok) << verify::report_text(result.report);
    }
}

class Tolerances : public ::testing::TestWithParam<double> {};

// Down to a twenty-fifth of a pulse of the heads: the pulses are then those of the straight lines.
TEST_P(Tolerances, BelowAPulseAreKeptToo) {
    Profile profile = usual_profile();
    profile.job.path_tolerance_mm = GetParam() / profile.r1.pulses_per_mm;
    for (const NamedShape& shape : sample_shapes()) {
        for (const Joining joining : {Joining::continuous, Joining::spiral}) {
            const Carved result = carved(profile, table_of(profile, shape.shape, 2, 300, joining));
            EXPECT_TRUE(result.report.ok) << shape.name << '\n' << verify::report_text(result.report);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OfTheCurve, Tolerances, ::testing::Values(0.04, 0.4, 0.99),
                         [](const auto& named) { return "Case" + std::to_string(named.index); });

/// Heads that run down steep steps for seconds while the table has next to nothing to do.
double cliff_mm(double direction, std::uint32_t) {
    return std::sin(2.0 * direction + 0.4) > 0.0 ? 11.0 : 3.0 + 0.5 * std::sin(9.0 * direction);
}

class FineShapes : public ::testing::TestWithParam<std::size_t> {};

// As dense as tables are: half a hundred pulses from point to point, curves that use up their tubes.
TEST_P(FineShapes, ObeyTheFourRules) {
    const Profile profile = fine_profile();
    const Carved result = carved(profile, table_of(profile, sample_shapes()[GetParam()].shape, 2, 500));
    EXPECT_TRUE(result.report.ok) << verify::report_text(result.report);
}

INSTANTIATE_TEST_SUITE_P(FineMachine, FineShapes, ::testing::Range(std::size_t{0}, std::size_t{4}),
                         [](const auto& named) { return std::string{sample_shapes()[named.param].name}; });

TEST(FineMachine, SpiralsThatRiseSteeplyObeyTheFourRules) {
    const Profile profile = fine_profile();
    for (const NamedShape& shape : sample_shapes()) {
        if (!test::is_thorough() && std::string{shape.name} != "figurine") continue;
        JobTable table = table_of(profile, shape.shape, 3, 100, Joining::spiral);
        table.layer_height_pulses = {4000, 36000, 36000};
        const Carved result = carved(profile, table);
        EXPECT_TRUE(result.report.ok) << shape.name << '\n' << verify::report_text(result.report);
    }
}

TEST(FineMachine, CliffsObeyTheFourRulesAndNoMotorStalls) {
    const Profile profile = fine_profile();
    const Carved result = carved(profile, table_of(profile, cliff_mm, 2, 500));
    EXPECT_TRUE(result.report.ok) << verify::report_text(result.report);
}

// The motors' accelerations are used to the last at each flank, and the verifier sees ten times more pulses.
TEST(DisturbedCarving, OfSharpFlanksObeysTheFourRulesOnAFineMachineToo) {
    const Profile profile = fine_profile();
    for (const NamedShape& shape : sample_shapes()) {
        if (std::string{shape.name} != "gear") continue;
        expect_obedience(profile, table_of(profile, shape.shape, 1, 60), test::is_thorough() ? 4 : 1);
    }
}

/// Asks for twice the feed as soon as the carving begins.
class TwiceTheFeed {
public:
    void operator()(MachineRig& rig) {
        if (!asked_) rig.ask(RequestKind::override, 0, 200);
        asked_ = true;
    }

private:
    bool asked_ = false;
};

class FeedsOfShapes : public ::testing::TestWithParam<std::size_t> {};

// A slow feed is even where at twice that the axes' own limits make it rise and fall between two points.
TEST_P(FeedsOfShapes, ObeyTheFourRulesAtTwiceTheFeedWhereTheAxesLimitIt) {
    const NamedShape shape = sample_shapes()[GetParam()];
    const std::vector<std::uint32_t> points =
        test::is_thorough() ? std::vector<std::uint32_t>{24U, 90U, 400U} : std::vector<std::uint32_t>{90U};
    for (Profile profile : {usual_profile(), fine_profile()}) {
        for (const double feed_mm_s : {4.0, 12.0, 30.0}) {
            profile.job.feed_mm_s = feed_mm_s;
            for (const std::uint32_t count : points) {
                const Carved result =
                    carved(profile, table_of(profile, shape.shape, 1, count), TwiceTheFeed());
                EXPECT_TRUE(result.report.ok) << count << ' ' << feed_mm_s << '\n'
                                              << verify::report_text(result.report);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(TwiceTheFeed, FeedsOfShapes, ::testing::Range(std::size_t{0}, std::size_t{4}),
                         [](const auto& named) { return std::string{sample_shapes()[named.param].name}; });

}  // namespace
}  // namespace psicarve::motion
