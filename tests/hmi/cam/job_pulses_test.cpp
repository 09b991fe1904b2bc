// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/job_pulses.hpp"

#include <gtest/gtest.h>

#include "shared/profile/profile.hpp"

namespace psicarve::cam {
namespace {

/// Two layers of three points over half a turn of 600 pulses, 100 higher the second.
std::vector<std::byte> small_job(Joining joining, bool is_roughed = false) {
    JobTable table;
    table.layer_count = 2;
    table.point_count = 3;
    table.psi_sweep_pulses = 600;
    table.feed_mm_s = 20.0;
    table.joining = joining;
    table.layer_height_pulses = {400, 500};
    table.r_left_pulses = {1000, 1010, 990, 980, 980, 1000};
    table.r_right_pulses = {700, 700, 700, 700, 707, 700};
    table.profile_toml = profile_to_toml(Profile{});
    if (is_roughed) {
        table.passes = {{static_cast<std::uint32_t>(PassKind::roughing), 1, 0, 1, 0.3, 2.0, 6.0},
                        {static_cast<std::uint32_t>(PassKind::finishing), 2, 1, 1, 0.0, 0.0, 6.0}};
    }
    return job_blob_from_table(table);
}

PulseCounts to_go(const JobView& job, std::uint32_t layer, std::uint32_t point) {
    return pulses_to_go(job, pulses_to_end(job, Profile{}), layer, point);
}

TEST(JobPulses, CountTheWayFromPointToPointAndFromLayerToLayer) {
    const auto blob = small_job(Joining::continuous);
    const JobView job = JobView::check(blob).value();
    const auto turned = static_cast<std::uint64_t>(job.psi_pulses(1, 2) - job.psi_pulses(0, 0));
    EXPECT_EQ(to_go(job, 0, 0), (PulseCounts{10 + 20 + 10 + 20, 7 + 7, turned, 100}));
}

TEST(JobPulses, LeaveOutWhatIsBehind) {
    const auto blob = small_job(Joining::continuous);
    const JobView job = JobView::check(blob).value();
    const auto turned = static_cast<std::uint64_t>(job.psi_pulses(1, 2) - job.psi_pulses(0, 1));
    EXPECT_EQ(to_go(job, 0, 1), (PulseCounts{20 + 10 + 20, 14, turned, 100}));
    EXPECT_EQ(to_go(job, 1, 2), PulseCounts{});
}

TEST(JobPulses, OfATableThatTurnsToAndFroAreThoseOfBothWays) {
    const auto blob = small_job(Joining::zigzag);
    const JobView job = JobView::check(blob).value();
    const auto way = static_cast<std::uint64_t>(std::abs(job.psi_pulses(0, 2) - job.psi_pulses(0, 0)));
    EXPECT_EQ(to_go(job, 0, 0)[index_of(Axis::psi)], 2 * way) << "none between the layers";
    // Its second layer is carved from its last point to its first.
    EXPECT_EQ(to_go(job, 1, 2)[index_of(Axis::psi)], way);
    EXPECT_EQ(to_go(job, 1, 0), PulseCounts{});
    // 1000, 1010, 990, and the other way 1000, 980, 980.
    EXPECT_EQ(to_go(job, 0, 0)[index_of(Axis::r1)], 10U + 20U + 10U + 20U + 0U);
}

TEST(JobPulses, BetweenTwoPassesTheHeadsGoClearOfTheBlank) {
    Profile profile;
    profile.job.clearance_mm = 1.0;
    profile.r1.tip_offset_mm = 0.5;
    profile.blank.radius_mm = 5.0;
    const auto blob = small_job(Joining::continuous, true);
    const JobView job = JobView::check(blob).value();
    // The second pass may meet 6 mm: R1 counts 5.5 mm of it and R2 6, and each 1 mm more.
    const std::uint64_t r1 = 2 * (6 * 400 + 200) - 990 - 980;
    const std::uint64_t r2 = 2 * 7 * 400 - 700 - 700;
    const auto turned = static_cast<std::uint64_t>(job.psi_pulses(1, 2) - job.psi_pulses(0, 0));
    EXPECT_EQ(pulses_to_end(job, profile).front(), (PulseCounts{10 + 20 + r1 + 20, r2 + 7 + 7, turned, 100}));
    profile.r2.travel_mm = {0.0, 6.5};
    profile.r2.home_position_mm = 6.5;
    const std::uint64_t held = 2 * 2600 - 700 - 700;
    EXPECT_EQ(pulses_to_end(job, profile).front()[index_of(Axis::r2)], held + 7 + 7)
        << "no further than it can";
}

}  // namespace
}  // namespace psicarve::cam
