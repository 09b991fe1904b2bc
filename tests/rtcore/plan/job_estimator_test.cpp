// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/job_estimator.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "rtcore/plan/carving.hpp"
#include "tests/shared/spiral_fixture.hpp"

namespace psicarve::plan {
namespace {

// So long nothing takes that ends at all.
constexpr std::chrono::seconds kPatience{120};

struct OwnedJob {
    std::vector<std::byte> blob;
    JobView view;
};

std::shared_ptr<const JobView> owned(const JobTable& table) {
    auto job = std::make_shared<OwnedJob>();
    job->blob = job_blob_from_table(table);
    job->view = JobView::check(job->blob).value();
    return {job, &job->view};
}

/// Rougher from layer to layer: each takes longer than the one below.
JobTable rougher_and_rougher(std::uint32_t layers) {
    JobTable table;
    table.layer_count = layers;
    table.point_count = 60;
    table.psi_sweep_pulses = 3200;
    table.feed_mm_s = 20.0;
    table.profile_toml = profile_to_toml(Profile{});
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        table.layer_height_pulses.push_back(100 + 50 * layer);
        for (std::uint32_t point = 0; point < table.point_count; ++point) {
            const auto wave = static_cast<std::int32_t>(point % 2 * 10 * layer);
            table.r_left_pulses.push_back(5000 + wave);
            table.r_right_pulses.push_back(5300 - wave);
        }
    }
    return table;
}

double planned_seconds(const Profile& profile, const std::shared_ptr<const JobView>& job, LayerSpan layers) {
    const auto program = carving_of(machine_limits(profile), job, layers);
    cycle::MotionBlock block{};
    while (program->next(block)) {
    }
    return program->planned().seconds;
}

Profile by_angle() {
    Profile profile;
    profile.job.planner = psicarve::Planner::angle;
    return profile;
}

TEST(JobEstimate, CountsPointsEvenlyBetweenItsMarks) {
    JobEstimate sut;
    EXPECT_EQ(sut.seconds(), 0.0);
    sut.add({.points = 11, .seconds = 2.0});
    sut.add({.points = 31, .seconds = 12.0});
    EXPECT_EQ(sut.points(), 31U);
    EXPECT_DOUBLE_EQ(sut.seconds_to(0), 0.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(1), 0.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(6), 1.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(11), 2.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(21), 7.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(31), 12.0);
    EXPECT_DOUBLE_EQ(sut.seconds_to(99), 12.0);
    sut.add({.points = 31, .seconds = 13.0});
    EXPECT_DOUBLE_EQ(sut.seconds(), 13.0);
}

TEST(JobEstimator, FindsWhatThePlannerPlans) {
    for (const bool is_spiral : {false, true}) {
        for (const Profile& profile : {Profile{}, by_angle()}) {
            const JobTable table = rougher_and_rougher(7);
            const auto job = owned(is_spiral ? spiral_of(table) : table);
            JobEstimator sut{profile};
            EXPECT_EQ(sut.estimate(), nullptr);
            sut.begin(job);
            ASSERT_TRUE(sut.wait(kPatience));
            const auto estimate = sut.estimate();
            EXPECT_EQ(estimate->points(), 7U * 60U);
            EXPECT_DOUBLE_EQ(estimate->seconds(), planned_seconds(profile, job, {}));
            EXPECT_GT(estimate->seconds(), 0.0);
            EXPECT_EQ(estimate->is_reference(), profile.job.planner == psicarve::Planner::lookahead);
        }
    }
}

TEST(JobEstimator, TellsOneLayerFromAnother) {
    const auto job = owned(rougher_and_rougher(8));
    JobEstimator sut{Profile{}};
    sut.begin(job);
    ASSERT_TRUE(sut.wait(kPatience));
    const auto estimate = sut.estimate();
    const auto layer_seconds = [&](std::uint64_t layer) {
        return estimate->seconds_to((layer + 1) * 60) - estimate->seconds_to(layer * 60);
    };
    EXPECT_GT(layer_seconds(7), 1.5 * layer_seconds(1));
    EXPECT_NEAR(estimate->seconds_to(3 * 60), planned_seconds(Profile{}, job, {0, 3}),
                0.02 * estimate->seconds());
}

TEST(JobEstimator, ForgetsTheJobBefore) {
    const auto first = owned(rougher_and_rougher(3));
    const auto second = owned(rougher_and_rougher(9));
    JobEstimator sut{Profile{}};
    sut.begin(first);
    sut.begin(second);
    ASSERT_TRUE(sut.wait(kPatience));
    EXPECT_EQ(sut.estimate()->points(), 9U * 60U);
    sut.begin(first);
    EXPECT_EQ(sut.estimate(), nullptr);
    ASSERT_TRUE(sut.wait(kPatience));
    EXPECT_EQ(sut.estimate()->points(), 3U * 60U);
}

TEST(JobEstimator, RestsWhileItIsPausedAndEndsInTheMiddle) {
    JobEstimator sut{Profile{}};
    sut.set_paused(true);
    sut.begin(owned(rougher_and_rougher(6)));
    EXPECT_FALSE(sut.wait(std::chrono::milliseconds{400}));
    sut.set_paused(false);
    EXPECT_TRUE(sut.wait(kPatience));
    sut.set_paused(true);
    sut.begin(owned(rougher_and_rougher(200)));
}

}  // namespace
}  // namespace psicarve::plan
