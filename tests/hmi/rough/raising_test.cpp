// SPDX-License-Identifier: GPL-3.0-or-later
// Heads raised out of the blank: where, that they touch nothing there, and that all else is as without.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "hmi/rough/pass_planner.hpp"
#include "hmi/rough/roughing.hpp"
#include "tests/hmi/rough/brute_stock.hpp"
#include "tests/hmi/rough/rough_tables.hpp"

namespace psicarve::rough {
namespace {

struct Kind {
    std::uint64_t seed;
    ToolProfile tool;
    Joining joining;
    double angle_error_deg;
    Planner planner;
};

class Raising : public ::testing::TestWithParam<Kind> {
protected:
    static constexpr std::uint32_t kManyPoints = 61;

    /// A blank 6 mm off the axis, in a direction of its own.
    Raising() {
        const Kind& kind = GetParam();
        profile.tool = kind.tool;
        profile.head_r2_angle_error_deg = kind.angle_error_deg;
        profile.job.planner = kind.planner;
        std::mt19937_64 random(kind.seed);
        const double direction = static_cast<double>(random() % 628) / 100.0;
        profile.blank = {.radius_mm = 40.0,
                         .height_mm = 0.0,
                         .offset_x_mm = 6.0 * std::cos(direction),
                         .offset_z_mm = 6.0 * std::sin(direction)};
    }
    /// At a feed at which rising is not worth its while nothing is raised.
    JobTable roughed_at(double feed_mm_s) const {
        const TipRadius small = random_body(GetParam().seed);
        const TipRadius body = [&small](double direction, double height_mm) {
            return 27.0 + small(direction, height_mm);
        };
        JobTable table = table_of(profile, 4, 0.8, GetParam().joining, body, kManyPoints);
        table.feed_mm_s = feed_mm_s;
        roughed(table, profile, {1.5, 0.3, {}});
        return table;
    }
    static bool is_outside(const JobView& job, const HeadsOutside& outside, std::uint32_t layer,
                           std::uint32_t point, std::size_t head) {
        const auto radii = head == 0 ? job.r_left_pulses(layer) : job.r_right_pulses(layer);
        return outside.holds(head, radii[point], radii[point + 1]);
    }

    static constexpr double kSlow_mm_s = 2.0;
    static constexpr double kFast_mm_s = 1000.0;
    Profile profile;
};

TEST_P(Raising, LetsNoHeadTouchAnythingOfAWholeBlankWhereItIsTakenAsOutside) {
    const JobTable table = roughed_at(kSlow_mm_s);
    const auto blob = job_blob_from_table(table);
    const JobView job = checked_view(blob, profile);
    const HeadsOutside outside = heads_outside(job, outside_rule(profile));
    // The blank as it was before the first pass: so it holds of a job that begins with any layer, and of one
    // layer alone.
    brute::Stock blank(profile, table, 16, 72);
    const double curve_mm = profile.job.path_tolerance_mm + 1.0 / profile.r1.pulses_per_mm;
    int lines = 0;
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        for (std::uint32_t point = 0; point + 1 < job.point_count(); ++point) {
            for (std::size_t head = 0; head < 2; ++head) {
                if (!is_outside(job, outside, layer, point, head)) continue;
                ++lines;
                ASSERT_LT(layer, job.finishing_layer());
                const Axis axis = head == 0 ? Axis::r1 : Axis::r2;
                blank.carve_line(job, layer, point, axis, curve_mm + 0.99 * profile.job.clearance_mm);
            }
        }
    }
    EXPECT_EQ(blank.removed_mm(), 0.0);
    EXPECT_GE(lines, 50) << "there is something to hold";
}

TEST_P(Raising, OnlyEverMovesHeadsOutwardsAndNoneThatCuts) {
    const JobTable raised = roughed_at(kSlow_mm_s);
    const JobTable plain = roughed_at(kFast_mm_s);
    ASSERT_EQ(raised.layer_height_pulses, plain.layer_height_pulses);
    int moved = 0;
    for (std::size_t i = 0; i < plain.r_left_pulses.size(); ++i) {
        ASSERT_GE(raised.r_left_pulses[i], plain.r_left_pulses[i]);
        ASSERT_GE(raised.r_right_pulses[i], plain.r_right_pulses[i]);
        moved += raised.r_left_pulses[i] > plain.r_left_pulses[i] ? 1 : 0;
        moved += raised.r_right_pulses[i] > plain.r_right_pulses[i] ? 1 : 0;
    }
    EXPECT_GE(moved, 50);
    // So they carve the same.
    const auto raised_blob = job_blob_from_table(raised);
    const auto plain_blob = job_blob_from_table(plain);
    const JobView raised_job = checked_view(raised_blob, profile);
    const JobView plain_job = checked_view(plain_blob, profile);
    brute::Stock of_raised(profile, raised, 16, 72);
    brute::Stock of_plain(profile, plain, 16, 72);
    for (std::uint32_t layer = 0; layer < plain_job.finishing_layer(); ++layer) {
        of_raised.carve(raised_job, layer, layer + 1);
        of_plain.carve(plain_job, layer, layer + 1);
        // Next to a cut the tool goes over trifles, on a hull that begins low: it takes a little of them.
        for (std::size_t i = 0; i < of_plain.radius_mm.size(); ++i)
            ASSERT_NEAR(of_raised.radius_mm[i], of_plain.radius_mm[i], 0.02) << "layer " << layer;
    }
}

TEST_P(Raising, IsLeftAloneWhereAHeadDoesNotGetOut) {
    const double out_mm = profile.blank.reach_mm() + profile.job.clearance_mm;
    profile.r1.travel_mm[1] = profile.r2.travel_mm[1] = out_mm - 0.1;
    profile.r1.home_position_mm = profile.r2.home_position_mm = out_mm - 0.1;
    const JobTable slow = roughed_at(kSlow_mm_s);
    const JobTable fast = roughed_at(kFast_mm_s);
    EXPECT_EQ(slow.r_left_pulses, fast.r_left_pulses);
    EXPECT_EQ(slow.r_right_pulses, fast.r_right_pulses);
}

constexpr ToolProfile kBall{ToolShape::ball, 3.0, 60.0, 0.0};
constexpr ToolProfile kFlat{ToolShape::flat, 8.0, 60.0, 0.0};
constexpr ToolProfile kVee{ToolShape::vee, 14.0, 60.0, 0.0};

INSTANTIATE_TEST_SUITE_P(Seeds, Raising,
                         ::testing::Values(Kind{1, kBall, Joining::continuous, 0.0, Planner::lookahead},
                                           Kind{2, kFlat, Joining::continuous, 0.0, Planner::lookahead},
                                           Kind{3, kVee, Joining::continuous, 0.0, Planner::lookahead},
                                           Kind{4, kBall, Joining::zigzag, 0.0, Planner::lookahead},
                                           Kind{5, kFlat, Joining::zigzag, 0.7, Planner::lookahead},
                                           Kind{6, kVee, Joining::zigzag, 0.0, Planner::angle},
                                           Kind{7, ToolProfile{}, Joining::continuous, 0.0,
                                                Planner::lookahead}),
                         [](const auto& named) { return "Seed" + std::to_string(named.param.seed); });

}  // namespace
}  // namespace psicarve::rough
