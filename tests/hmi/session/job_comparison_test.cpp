// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/job_comparison.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "shared/job/job.hpp"
#include "tests/hmi/session/sights.hpp"

namespace psicarve::session {
namespace {

using JobPointer = std::shared_ptr<const cam::PreparedJob>;

JobPointer job_of_two_layers(const Profile& profile) {
    JobTable table;
    table.layer_count = 2;
    table.point_count = 5;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.joining = Joining::continuous;
    table.feed_mm_s = 20.0;
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    table.layer_height_pulses = {400, 800};
    table.r_left_pulses.assign(10, 4000);
    table.r_right_pulses.assign(10, 8000);
    auto job = cam::prepare_blob(job_blob_from_table(table), profile, "two layers");
    EXPECT_TRUE(job);
    return std::make_shared<const cam::PreparedJob>(std::move(*job));
}

/// Of the core whose profile has this hash.
MachineView machine_with(const Profile& profile, std::uint64_t hash) {
    MachineView machine = test::machine_in(MachineState::ready);
    machine.profile = profile;
    machine.core_profile_hash = hash;
    return machine;
}

/// No core, and the checkpoint of that job behind its first layer.
MachineView checkpoint_of(const cam::PreparedJob& job) {
    MachineView machine;
    machine.resumable_layer = 1;
    machine.checkpoint_layer_count = 2;
    machine.checkpoint_job_checksum = job_checksum(job.blob);
    return machine;
}

TEST(JobComparison, NamesTheFirstKeyOfMotionThatDiffers) {
    const JobPointer job = job_of_two_layers(Profile{});
    Profile other;
    other.r1.speed_mm_s /= 2.0;
    JobComparison comparison;
    OpenJobView view;
    comparison.compare_profiles(job, machine_with(Profile{}, 1), view);
    EXPECT_EQ(view.profile_difference, "");
    comparison.compare_profiles(job, machine_with(other, 2), view);
    EXPECT_NE(view.profile_difference.find("axis.r1"), std::string::npos) << view.profile_difference;
    comparison.compare_profiles(job, machine_with(Profile{}, 1), view);
    EXPECT_EQ(view.profile_difference, "");
}

TEST(JobComparison, TellsNothingWhereThereIsNoJobOrNoProfile) {
    Profile own;
    own.blank.radius_mm = 25.0;
    const JobPointer job = job_of_two_layers(own);
    Profile other;
    other.blank.radius_mm = 26.0;
    JobComparison comparison;
    OpenJobView view;
    comparison.compare_profiles(job, machine_with(other, 2), view);
    EXPECT_TRUE(view.blank_difference);
    comparison.compare_profiles({}, machine_with(other, 2), view);
    EXPECT_FALSE(view.blank_difference);
    comparison.compare_profiles(job, machine_with(other, 2), view);
    EXPECT_TRUE(view.blank_difference);
    MachineView unknown = machine_with(other, 2);
    unknown.profile.reset();
    comparison.compare_profiles(job, unknown, view);
    EXPECT_FALSE(view.blank_difference);
}

TEST(JobComparison, KnowsTheJobOfACheckpointByItsBytes) {
    const JobPointer job = job_of_two_layers(Profile{});
    Profile finer;
    finer.job.path_tolerance_mm /= 2.0;
    const JobPointer like = job_of_two_layers(finer);
    JobComparison comparison;
    EXPECT_TRUE(comparison.is_of_checkpoint(job, checkpoint_of(*job)));
    EXPECT_FALSE(comparison.is_of_checkpoint(like, checkpoint_of(*job)));
    EXPECT_TRUE(comparison.is_of_checkpoint(job, checkpoint_of(*job)));
    EXPECT_FALSE(comparison.is_of_checkpoint({}, checkpoint_of(*job)));
}

TEST(JobComparison, AsksACheckpointOnlyWhereNoCoreIsHeardAndOneIsKnown) {
    const JobPointer job = job_of_two_layers(Profile{});
    JobComparison comparison;
    MachineView machine = checkpoint_of(*job);
    machine.life = CoreLife::alive;
    EXPECT_FALSE(comparison.is_of_checkpoint(job, machine));
    machine.life = CoreLife::silent;
    EXPECT_TRUE(comparison.is_of_checkpoint(job, machine));
    machine.resumable_layer.reset();
    EXPECT_FALSE(comparison.is_of_checkpoint(job, machine));
    machine.earlier_layer = 1;
    EXPECT_TRUE(comparison.is_of_checkpoint(job, machine));
    machine.checkpoint_layer_count = 3;
    EXPECT_FALSE(comparison.is_of_checkpoint(job, machine));
}

}  // namespace
}  // namespace psicarve::session
