// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/job/outside.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "tests/shared/job_fixture.hpp"
#include "tests/shared/passes_fixture.hpp"

namespace psicarve {
namespace {

constexpr double kLeastClearance_mm = 0.5;

/// A roughing and a finishing pass, of a machine that knows of no blank unless `machine` does.
HeadsOutside outside_of(const Profile& made_for, const Profile& machine,
                        const std::function<void(JobTable&)>& change = {}) {
    JobTable table = with_roughing(small_job(made_for), 1, 400);
    for (JobPass& pass : table.passes) pass.clear_mm = made_for.blank.reach_mm();
    table.r_left_pulses.front() = table.r_left_pulses.back();  // wherever the others are: no pass is all air
    if (change) change(table);
    const auto blob = job_blob_from_table(table);
    const auto job = JobView::check(blob);
    EXPECT_TRUE(job);
    return heads_outside(*job, outside_rule(machine));
}

Profile with_blank(double radius_mm, double offset_mm = 0.0) {
    Profile profile;
    profile.blank = {.radius_mm = radius_mm, .offset_x_mm = offset_mm};
    profile.job.path_tolerance_mm = 0.011;  // to no whole number of pulses
    return profile;
}

constexpr HeadsOutside kNowhere{};

TEST(HeadsOutside, AreSoFarOutThatNothingOfTheBlankIsNearWhateverTheProfile) {
    std::mt19937_64 random(5);
    const auto between = [&random](double least, double most) {
        return least + (most - least) * static_cast<double>(random() % 10'001) / 10'000.0;
    };
    for (int round = 0; round < 500; ++round) {
        Profile profile = with_blank(between(9.0, 30.0), between(-6.0, 6.0));
        profile.blank.offset_z_mm = between(-6.0, 6.0);
        profile.job.clearance_mm = round % 4 == 0 ? 0.0 : between(0.0, 5.0);
        profile.job.path_tolerance_mm = between(0.001, 0.5);
        for (LinearAxisProfile* axis : {&profile.r1, &profile.r2}) {
            axis->pulses_per_mm = between(10.0, 600.0);
            axis->tip_offset_mm = between(-5.0, 5.0);
        }
        const auto parsed = parse_profile(profile_to_toml(profile), "");
        ASSERT_TRUE(parsed) << parsed.error().message;
        const HeadsOutside outside = outside_of(profile, profile);
        double furthest_mm = 0.0;
        for (int i = 0; i < 360; ++i)
            furthest_mm = std::max(furthest_mm, profile.blank.surface_mm(rad_from_deg(i)));
        for (std::size_t head = 0; head < 2; ++head) {
            const LinearAxisProfile& axis = head == 0 ? profile.r1 : profile.r2;
            const std::int64_t least = outside.from_pulses[head];
            ASSERT_TRUE(outside.holds(head, least, least + 100));
            ASSERT_FALSE(outside.holds(head, least + 100, least - 1));
            ASSERT_FALSE(outside.holds(head, least - 1, least + 100));
            const double nearest_mm = static_cast<double>(least - 1) / axis.pulses_per_mm + axis.tip_mm() -
                                      profile.job.path_tolerance_mm;
            const double clearance_mm = std::max(profile.job.clearance_mm, kLeastClearance_mm);
            ASSERT_GE(nearest_mm, furthest_mm + clearance_mm - 1e-9);
            // The finished tips are 10 mm out, to a coarse pulse.
            const double reach_mm = std::max(profile.blank.reach_mm(), 10.1);
            ASSERT_LE(nearest_mm, reach_mm + clearance_mm + 3.0 / axis.pulses_per_mm);
        }
    }
}

TEST(HeadsOutside, AreNowhereWhereNobodyTellsOfABlank) {
    const Profile none;
    EXPECT_EQ(outside_of(none, none).from_pulses, kNowhere.from_pulses);
    // What the machine says of its blank is not what this job is made for.
    EXPECT_EQ(outside_of(none, with_blank(12.0)).from_pulses, kNowhere.from_pulses);
    // It is not enough that one of the passes says so.
    const auto one_tells = [](JobTable& table) { table.passes[0].clear_mm = 12.0; };
    EXPECT_EQ(outside_of(none, none, one_tells).from_pulses, kNowhere.from_pulses);
    // Nor is a blank in the job's profile enough, where passes say that they do not know what they find.
    const auto unknown = [](JobTable& table) {
        for (JobPass& pass : table.passes) pass.clear_mm = 0.0;
    };
    const auto half_known = [](JobTable& table) { table.passes[0].clear_mm = 0.0; };
    const Profile told = with_blank(10.2);
    EXPECT_EQ(outside_of(told, told, unknown).from_pulses, kNowhere.from_pulses);
    EXPECT_EQ(outside_of(told, told, half_known).from_pulses, kNowhere.from_pulses);
}

// A table may say anything. One that roughs where, by its own words, nothing stands does not know.
TEST(HeadsOutside, AreNowhereWhereAWholePassWouldBeInTheAir) {
    const Profile profile = with_blank(10.2);
    const auto roughs_at = [&](std::int32_t left_pulses, std::int32_t right_pulses) {
        return outside_of(profile, profile, [=](JobTable& table) {
            const std::size_t count = std::size_t{table.passes[0].layer_count} * table.point_count;
            std::fill_n(table.r_left_pulses.begin(), count, left_pulses);
            std::fill_n(table.r_right_pulses.begin(), count, right_pulses);
        });
    };
    const std::int32_t least = static_cast<std::int32_t>(outside_of(profile, profile).from_pulses[0]);
    EXPECT_EQ(roughs_at(least, least).from_pulses, kNowhere.from_pulses);
    EXPECT_EQ(roughs_at(least - 1, least).from_pulses[0], least);
    EXPECT_EQ(roughs_at(least, least - 1).from_pulses[0], least);
}

TEST(HeadsOutside, AreNowhereInAFinishingPassAlone) {
    const auto finishing = [](JobTable& table) {
        table = small_job(with_blank(5.0));
        table.r_left_pulses[3] = 20'000;
    };
    const Profile profile = with_blank(5.0);
    EXPECT_EQ(outside_of(profile, profile, finishing).from_pulses, kNowhere.from_pulses);
}

TEST(HeadsOutside, AreBeyondTheLargestOfAllThatTells) {
    const Profile small = with_blank(12.0);
    const HeadsOutside alone = outside_of(small, small);
    // 12 + clearance 2 + tolerance 0.011 mm, rounded outwards, and a pulse.
    EXPECT_EQ(alone.from_pulses[0], 5605 + 1);
    const HeadsOutside larger_machine = outside_of(small, with_blank(20.0));
    EXPECT_EQ(larger_machine.from_pulses[0], alone.from_pulses[0] + 8 * 400);
    EXPECT_EQ(outside_of(small, with_blank(7.0)).from_pulses, alone.from_pulses);
    const HeadsOutside off_axis = outside_of(small, with_blank(12.0, 3.0));
    EXPECT_EQ(off_axis.from_pulses[0], alone.from_pulses[0] + 3 * 400);
    for (const std::size_t pass : {0U, 1U}) {
        const auto told = [pass](JobTable& table) { table.passes[pass].clear_mm = 15.0; };
        EXPECT_EQ(outside_of(small, small, told).from_pulses[0], alone.from_pulses[0] + 3 * 400);
    }
    // A model that stands out of its blank.
    const auto stands_out = [](JobTable& table) { table.r_right_pulses.back() = 17 * 400; };
    EXPECT_EQ(outside_of(small, small, stands_out).from_pulses[0], alone.from_pulses[0] + 5 * 400);
    // Roughing goes over what may stand: that tells nothing.
    const auto raised = [](JobTable& table) { table.r_right_pulses.front() = 17 * 400; };
    EXPECT_EQ(outside_of(small, small, raised).from_pulses, alone.from_pulses);
}

}  // namespace
}  // namespace psicarve
