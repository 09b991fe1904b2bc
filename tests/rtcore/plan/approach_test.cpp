// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/approach.hpp"

#include <gtest/gtest.h>

#include "shared/base/units.hpp"
#include "shared/job/job.hpp"

namespace psicarve::plan {
namespace {

/// Two layers, zigzag: R1 never sees the wide side of the piece.
std::vector<std::byte> lopsided_blob(const Profile& profile) {
    JobTable table;
    table.layer_count = 2;
    table.point_count = 3;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.joining = Joining::zigzag;
    table.feed_mm_s = 10.0;
    table.layer_height_pulses = {400, 440};
    table.r_left_pulses.assign(6, 2877);
    table.r_right_pulses.assign(6, 3865);
    table.source_name = "lopsided";
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    return job_blob_from_table(table);
}

/// Approaches with this profile; both heads stand at `outside` whenever the table or the heads' height moves.
void expect_outside(const Profile& profile, std::int64_t outside) {
    const auto blob = lopsided_blob(profile);
    const auto job = JobView::check(blob).value();
    const auto blocks = approach_blocks(machine_limits(profile), job, {1000, 1000, 0, 0});
    Pulses4 at{1000, 1000, 0, 0};
    bool has_turned = false;
    for (const cycle::MotionBlock& block : blocks) {
        if (block.kind != cycle::BlockKind::move) continue;
        const bool turns = block.delta_pulses[2] != 0 || block.delta_pulses[3] != 0;
        if (turns) {
            has_turned = true;
            EXPECT_EQ(at[0], outside) << "R1 passes the wide side, too";
            EXPECT_EQ(at[1], outside);
        }
        for (std::size_t k = 0; k < kAxisCount; ++k) at[k] += block.delta_pulses[k];
    }
    EXPECT_TRUE(has_turned);
    EXPECT_EQ(at[0], 2877);
    EXPECT_EQ(at[1], 3865);
}

TEST(Approach, KeepsBothHeadsOutsideTheWholeTableWhilePsiTurns) {
    expect_outside(Profile{}, 3865 + 800);
}

TEST(Approach, KeepsBothHeadsOutsideABlankThatIsWider) {
    Profile profile;
    profile.blank.radius_mm = 20.0;
    expect_outside(profile, 20 * 400 + 800);
    profile.blank.offset_x_mm = 3.0;
    profile.blank.offset_z_mm = -4.0;
    expect_outside(profile, 25 * 400 + 800);
    profile.blank.offset_x_mm = profile.blank.offset_z_mm = 0.0;
    profile.blank.radius_mm = 5.0;
    expect_outside(profile, 3865 + 800);
}

TEST(Approach, HeadsRestBeforeTheCarvingMayTakeThemOutAgain) {
    const Profile profile;
    const auto blob = lopsided_blob(profile);
    const auto job = JobView::check(blob).value();
    const auto blocks = approach_blocks(machine_limits(profile), job, {1000, 1000, 0, 0});
    ASSERT_GE(blocks.size(), 3U);
    EXPECT_EQ(blocks.back().kind, cycle::BlockKind::program_end);
    EXPECT_EQ(blocks[blocks.size() - 2].kind, cycle::BlockKind::dwell);
    EXPECT_EQ(blocks[blocks.size() - 2].ticks, 200) << "10 ms of 50 us";
    EXPECT_EQ(blocks[blocks.size() - 3].reaches_points, 1);
}

// Whoever stops with a jump and jumps off the other way at once asks for twice what a motor can do.
TEST(Finish, HeadsRestBeforeTheyGoOut) {
    const MachineLimits limits = machine_limits(Profile{});
    const auto blocks = finish_blocks(limits, {2000, 2000, 0, 400});
    ASSERT_GE(blocks.size(), 2U);
    EXPECT_EQ(blocks[0].kind, cycle::BlockKind::dwell);
    EXPECT_EQ(blocks[0].ticks, 200) << "10 ms of 50 us";
    EXPECT_EQ(blocks[1].kind, cycle::BlockKind::move);
    EXPECT_GT(blocks[1].delta_pulses[0], 0);
    EXPECT_GT(blocks[1].delta_pulses[1], 0);
}

}  // namespace
}  // namespace psicarve::plan
