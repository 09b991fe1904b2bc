// SPDX-License-Identifier: GPL-3.0-or-later
// Heads that are outside of the blank keep to no feed, by either planner.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "rtcore/plan/carving.hpp"
#include "tests/rtcore/plan/table_blocks.hpp"
#include "tests/shared/job_fixture.hpp"
#include "tests/shared/passes_fixture.hpp"

namespace psicarve::plan {
namespace {

constexpr double kFeed_mm_s = 6.0;
constexpr double kTop_rad_s = 225.0 * kPi / 180.0;

class OutsideProgram : public ::testing::TestWithParam<psicarve::Planner> {
protected:
    OutsideProgram() { profile.job.planner = GetParam(); }

    /// Two roughing layers, a third one at 9 mm and three finishing ones, of rings; 12 mm of blank are told.
    std::shared_ptr<const JobView> job(double left_mm, double right_mm, double clear_mm = 12.0) const {
        JobTable table = with_roughing(small_job(profile, 3, 101, 8.0), 1, 0);
        table.feed_mm_s = kFeed_mm_s;
        for (JobPass& pass : table.passes) pass.clear_mm = clear_mm;
        for (std::size_t i = 0; i < 2 * std::size_t{table.point_count}; ++i) {
            table.r_left_pulses[i] = static_cast<std::int32_t>(400.0 * left_mm);
            table.r_right_pulses[i] = static_cast<std::int32_t>(400.0 * right_mm);
        }
        for (std::size_t i = 2 * std::size_t{table.point_count}; i < 3 * std::size_t{table.point_count}; ++i)
            table.r_left_pulses[i] = table.r_right_pulses[i] = 9 * 400;
        return test::job_of(table);
    }
    std::vector<cycle::MotionBlock> blocks(const std::shared_ptr<const JobView>& of,
                                           LayerSpan layers = {}) const {
        const auto program = carving_of(machine_limits(profile), of, layers);
        std::vector<cycle::MotionBlock> made;
        cycle::MotionBlock block;
        while (program->next(block)) made.push_back(block);
        return made;
    }
    double seconds(const std::shared_ptr<const JobView>& of, LayerSpan layers = {0, 1}) const {
        const auto program = carving_of(machine_limits(profile), of, layers);
        cycle::MotionBlock block;
        while (program->next(block)) {
        }
        return program->planned().seconds;
    }
    /// Half a turn, and what it takes to speed up and slow down.
    static void expect_turns_at(double seconds, double speed_rad_s) {
        EXPECT_GE(seconds, 0.995 * kPi / speed_rad_s);
        EXPECT_LE(seconds, 1.01 * kPi / speed_rad_s + 0.11);
    }

    Profile profile;
};

TEST_P(OutsideProgram, TurnsAsFastAsTheTableCanWhereBothHeadsAreOutside) {
    expect_turns_at(seconds(job(15.0, 15.0)), kTop_rad_s);
}

TEST_P(OutsideProgram, TurnsAtTheFeedOfTheHeadThatIsNotOutside) {
    expect_turns_at(seconds(job(15.0, 9.0)), kFeed_mm_s / 9.0);
    expect_turns_at(seconds(job(9.0, 15.0)), kFeed_mm_s / 9.0);
    expect_turns_at(seconds(job(9.0, 9.0)), kFeed_mm_s / 9.0);
    // Further out than the blank, but not by its clearance.
    expect_turns_at(seconds(job(13.9, 15.0)), kFeed_mm_s / 13.9);
}

TEST_P(OutsideProgram, DoesNotKnowOutsideWithoutABlankNorInALargerOne) {
    expect_turns_at(seconds(job(15.0, 15.0, 0.0)), kFeed_mm_s / 15.0);
    const auto made_for_small = job(15.0, 15.0);
    profile.blank = {.radius_mm = 11.0, .offset_z_mm = 3.0};
    expect_turns_at(seconds(made_for_small), kFeed_mm_s / 15.0);
}

TEST_P(OutsideProgram, PlansALayerAlikeWhereverTheCarvingBegins) {
    const auto made = job(15.0, 15.0);
    const double first_s = seconds(made, {0, 1});
    EXPECT_NEAR(seconds(made, {1, 2}), first_s, 1e-9);
    expect_turns_at(first_s, kTop_rad_s);
    // The finishing pass is at the feed.
    expect_turns_at(seconds(made, {3, 4}), kFeed_mm_s / 8.0);
}

TEST_P(OutsideProgram, GivesTheSameBlocksAsEverWhereNoHeadIsOutside) {
    const auto known = blocks(job(13.9, 9.0));
    const auto unknown = blocks(job(13.9, 9.0, 0.0));
    ASSERT_EQ(known.size(), unknown.size());
    // Between the passes the heads go out as far as each blank asks.
    const auto is_carving = [](const cycle::MotionBlock& block) { return block.reaches_points > 0; };
    int compared = 0;
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (!is_carving(known[i]) || known[i].layer == 3) continue;
        ++compared;
        EXPECT_EQ(known[i].delta_pulses, unknown[i].delta_pulses);
        EXPECT_EQ(known[i].max_speed_per_s, unknown[i].max_speed_per_s);
        EXPECT_EQ(known[i].path.start_speed2, unknown[i].path.start_speed2);
        EXPECT_EQ(known[i].path.end_speed2, unknown[i].path.end_speed2);
    }
    EXPECT_GT(compared, 250);
}

INSTANTIATE_TEST_SUITE_P(By, OutsideProgram,
                         ::testing::Values(psicarve::Planner::lookahead, psicarve::Planner::angle),
                         [](const auto& named) {
                             return std::string(named.param == psicarve::Planner::angle ? "Angle"
                                                                                        : "Lookahead");
                         });

}  // namespace
}  // namespace psicarve::plan
