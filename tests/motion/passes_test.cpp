// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs of several passes: the heads go clear between them, and everything holds that holds within one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "hmi/verify/verify_report.hpp"
#include "rtcore/cycle/layer_range.hpp"
#include "tests/motion/carving_bench.hpp"
#include "tests/motion/random_operator.hpp"
#include "tests/shared/passes_fixture.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::motion {
namespace {

using cycle::MachineRig;
using cycle::RequestKind;

struct Way {
    Joining joining;
    Planner planner;
};

std::string name_of_way(const Way& way) {
    return std::string{name_of(way.joining)} + (way.planner == Planner::angle ? "Angle" : "Lookahead");
}

class Passes : public ::testing::TestWithParam<Way> {
protected:
    Passes() : profile(cycle::quick_profile()) {
        profile.job.planner = GetParam().planner;
        profile.job.joining = GetParam().joining;
    }
    JobTable table(std::uint32_t points = test::is_thorough() ? 20 : 8) const {
        const auto shape = [](double, std::uint32_t layer) { return 6.0 + 0.4 * (layer % 3); };
        return with_roughing(table_of(profile, shape, 3, points, GetParam().joining), 2, 400);
    }

    Profile profile;
};

TEST_P(Passes, ObeyTheFourRulesAndTellTheirTimes) {
    const JobTable job = table();
    const Carved result = carved(profile, job);
    ASSERT_TRUE(result.report.ok) << verify::report_text(result.report);
    EXPECT_EQ(result.report.points_visited, std::uint64_t{job.layer_count} * job.point_count);
    ASSERT_EQ(result.report.passes.size(), 3U);
    double sum_s = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(result.report.passes[i].layers, job.passes[i].layer_count);
        EXPECT_GT(result.report.passes[i].seconds, 0.0);
        sum_s += result.report.passes[i].seconds;
    }
    EXPECT_EQ(result.report.passes[0].name, "roughing pass 1");
    EXPECT_EQ(result.report.passes[2].name, "finishing pass");
    EXPECT_NEAR(sum_s, result.report.carve_seconds, 1e-6);
}

TEST_P(Passes, HaveTheSamePulsesHoweverTheyAreDisturbed) {
    const JobTable job = table();
    const Carved undisturbed = carved(profile, job);
    ASSERT_TRUE(undisturbed.report.ok) << verify::report_text(undisturbed.report);
    for (std::uint64_t seed = 1; seed <= (test::is_thorough() ? 2U : 1U); ++seed) {
        const Carved disturbed = carved(profile, job, Operator(seed));
        ASSERT_TRUE(disturbed.report.ok) << "seed " << seed << '\n' << verify::report_text(disturbed.report);
        ASSERT_EQ(disturbed.order, undisturbed.order) << "seed " << seed;
    }
}

/// What the pins did from a layer's first point to the end of the job.
std::vector<std::uint32_t> order_from(MachineRig& rig, std::uint32_t layer) {
    EXPECT_EQ(rig.ask(RequestKind::start, 0, cycle::packed(cycle::LayerRange{layer, 0})),
              cycle::Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::waiting));
    rig.port->writes.clear();
    EXPECT_EQ(rig.ask(RequestKind::start_interpolation), cycle::Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::finishing));
    std::vector<std::uint32_t> order = order_of(rig.port->writes);
    EXPECT_TRUE(rig.run_until(MachineState::ready));
    return order;
}

TEST_P(Passes, GoOnFromAnyLayerOfAnyPass) {
    const JobTable job = table(8);
    MachineRig rig(profile);
    ASSERT_TRUE(rig.home());
    rig.load(job);
    const std::vector<std::uint32_t> whole = order_from(rig, 0);
    for (std::uint32_t layer = 1; layer < job.layer_count; ++layer) {
        const std::vector<std::uint32_t> rest = order_from(rig, layer);
        ASSERT_LT(rest.size(), whole.size());
        EXPECT_TRUE(std::equal(rest.rbegin(), rest.rend(), whole.rbegin())) << "layer " << layer;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Carved, Passes,
    ::testing::Values(Way{Joining::continuous, Planner::lookahead}, Way{Joining::zigzag, Planner::lookahead},
                      Way{Joining::spiral, Planner::lookahead}, Way{Joining::continuous, Planner::angle},
                      Way{Joining::zigzag, Planner::angle}, Way{Joining::spiral, Planner::angle}),
    [](const auto& named) { return name_of_way(named.param); });

/// Where the heads stood whenever Y moved between two passes.
TEST(BetweenPasses, TheHeadsAreClearOfWhatStands) {
    Profile profile = cycle::quick_profile();
    const auto shape = [](double, std::uint32_t) { return 6.0; };
    JobTable job = with_roughing(table_of(profile, shape, 3, 20), 1, 400);
    for (JobPass& pass : job.passes) pass.clear_mm = 9.0;
    MachineRig rig(profile);
    ASSERT_TRUE(rig.home());
    rig.load(job);
    ASSERT_EQ(rig.ask(RequestKind::start), cycle::Refusal::none);
    ASSERT_TRUE(rig.run_until(MachineState::waiting));
    ASSERT_EQ(rig.ask(RequestKind::start_interpolation), cycle::Refusal::none);
    std::int64_t y = rig.positions()[index_of(Axis::y)];
    std::int64_t most_down = 0;
    const auto least = static_cast<std::int64_t>(9.0 * profile.r1.pulses_per_mm);
    while (rig.cycle->state() != MachineState::finishing) {
        rig.tick();
        const auto at = rig.positions();
        if (at[index_of(Axis::y)] < y) {
            ++most_down;
            ASSERT_GT(at[index_of(Axis::r1)], least);
            ASSERT_GT(at[index_of(Axis::r2)], least);
        }
        y = at[index_of(Axis::y)];
    }
    EXPECT_EQ(most_down, job.layer_height_pulses[2] - job.layer_height_pulses[0]);
}

// The second pass stands further out than the first, right above its end: on their way clear the heads come
// by.
TEST(BetweenPasses, APointThatIsPassedOnTheWayOutIsNoArrival) {
    Profile profile = cycle::quick_profile();
    const auto shape = [](double, std::uint32_t) { return 6.0; };
    JobTable job = with_roughing(table_of(profile, shape, 1, 20), 2, 400);
    for (std::size_t point = 0; point < job.point_count; ++point) {
        job.r_left_pulses[job.point_count + point] += 600;
        job.r_right_pulses[job.point_count + point] += 600;
    }
    for (JobPass& pass : job.passes) pass.clear_mm = 9.0;
    const Carved result = carved(profile, job);
    EXPECT_TRUE(result.report.ok) << verify::report_text(result.report);
    EXPECT_EQ(result.report.points_visited, std::uint64_t{job.layer_count} * job.point_count);
    ASSERT_EQ(result.report.passes.size(), 3U);
}

}  // namespace
}  // namespace psicarve::motion
