// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "shared/base/units.hpp"
#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

void expect_perfect(const SampleJob& job, const PerfectMachine& machine) {
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_EQ(report.points_visited, report.points_total);
    EXPECT_EQ(report.max_deviation_pulses, 0);
    EXPECT_LE(report.max_line_deviation_pulses, 1.0);
}

TEST(PerfectTrace, OfAContinuousJobIsVerified) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.carve_job();
    expect_perfect(job, machine);
}

TEST(PerfectTrace, OfAZigzagJobIsVerified) {
    const SampleJob job = wavy_job(Joining::zigzag);
    PerfectMachine machine(job);
    machine.carve_job();
    expect_perfect(job, machine);
}

TEST(PerfectTrace, OfASpiralIsVerified) {
    for (const std::uint32_t rows : {1U, 2U, 3U, 6U}) {
        for (const std::uint32_t points : {2U, 5U, 21U, 98U}) {
            const SampleJob job = wavy_job(Joining::spiral, rows, points);
            PerfectMachine machine(job);
            machine.carve_job();
            SCOPED_TRACE(std::to_string(rows) + " rows of " + std::to_string(points) + " points");
            expect_perfect(job, machine);
            EXPECT_EQ(verified(job, machine).uncarved_cells, 0U);
        }
    }
}

/// Carved by a machine that takes up these gaps.
VerifyReport verified_with_gaps(const Profile& profile) {
    const SampleJob job(profile, 3, 41, Joining::zigzag,
                        [](double angle, double) { return 8.0 + 0.3 * std::sin(3.0 * angle); });
    PerfectMachine machine(job);
    machine.gap = {8, 12, 4, 20};
    machine.carve_job();
    return verified(job, machine);
}

TEST(PerfectTrace, WithBacklashTakenUpIsVerified) {
    Profile profile;
    profile.r1.backlash_mm = 8.0 / 400.0;
    profile.r2.backlash_mm = 12.0 / 400.0;
    profile.psi.backlash_deg = 4.0 * 360.0 / 6400.0;
    profile.y.backlash_mm = 20.0 / 400.0;
    const VerifyReport report = verified_with_gaps(profile);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_EQ(report.max_deviation_pulses, 0);
    profile.r2.backlash_mm = 11.0 / 400.0;
    EXPECT_FALSE(verified_with_gaps(profile).ok) << "one pulse of the gap is missing";
    EXPECT_FALSE(verified_with_gaps(Profile{}).ok);
}

TEST(PerfectTrace, ThatBeginsWithItsGapsCrossedIsVerifiedByWhatItsHeadSaysOfThem) {
    Profile profile;
    profile.r1.backlash_mm = 8.0 / 400.0;
    profile.r2.backlash_mm = 12.0 / 400.0;
    profile.psi.backlash_deg = 4.0 * 360.0 / 6400.0;
    profile.y.backlash_mm = 20.0 / 400.0;
    const SampleJob job(profile, 3, 41, Joining::zigzag,
                        [](double angle, double) { return 8.0 + 0.3 * std::sin(3.0 * angle); });
    PerfectMachine machine(job);
    machine.gap = {8, 12, 4, 20};
    machine.begin_crossed().carve_job();
    const VerifyReport report = verified(job, machine);
    EXPECT_TRUE(report.ok) << report_text(report);
    EXPECT_EQ(report.max_deviation_pulses, 0);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        PerfectMachine lies = machine;
        lies.start.crossed_pulses[k] -= 1;
        EXPECT_FALSE(verified(job, lies).ok) << k;
        lies.start.crossed_pulses[k] = 0;
        EXPECT_FALSE(verified(job, lies).ok) << k;
    }
    PerfectMachine other = machine;
    other.start.crossed_pulses[1] = 13;
    const auto refused = Verifier::make(job.view(), profile).value().begin(other.start);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "r2 begins 13 pulses into its backlash, which is 12 by this profile: it is not of the machine "
              "that was traced");
}

TEST(PerfectTrace, OfASingleLayerOfTwoPointsIsVerified) {
    const SampleJob job = wavy_job(Joining::continuous, 1, 2);
    PerfectMachine machine(job);
    machine.carve_job();
    expect_perfect(job, machine);
}

TEST(PerfectTrace, WithPointsOnUnevenPulsesIsVerified) {
    const SampleJob job = wavy_job(Joining::continuous, 3, 98);
    PerfectMachine machine(job);
    machine.carve_job();
    expect_perfect(job, machine);
}

TEST(PerfectTrace, WithAPointOnEveryPulseIsVerified) {
    Profile machine_profile;
    machine_profile.psi.pulses_per_rev = 400;
    machine_profile.psi.speed_deg_s = machine_profile.psi.start_stop_deg_s = 360.0;
    const SampleJob job(machine_profile, 3, 201, Joining::continuous,
                        [](double angle, double) { return 8.0 + 0.3 * std::sin(3.0 * angle); });
    PerfectMachine machine(job);
    machine.carve_job();
    expect_perfect(job, machine);
}

TEST(PerfectTrace, OfSteepFlanksIsVerified) {
    const SampleJob job(Profile{}, 2, 161, Joining::continuous,
                        [](double angle, double) { return std::sin(6.0 * angle) > 0.0 ? 9.0 : 7.0; });
    PerfectMachine machine(job);
    machine.carve_job();
    expect_perfect(job, machine);
}

TEST(PerfectTrace, WithHeadErrorsAndTipOffsetsIsVerified) {
    Profile machine_profile;
    machine_profile.head_r2_angle_error_deg = 0.7;
    machine_profile.head_r2_height_error_mm = 0.03;
    machine_profile.r1.tip_offset_mm = 0.11;
    machine_profile.r2.tip_offset_mm = -0.07;
    const SampleJob job(machine_profile, 3, 33, Joining::continuous,
                        [](double angle, double) { return 8.0 + 0.3 * std::sin(3.0 * angle); });
    PerfectMachine machine(job);
    machine.carve_job();
    expect_perfect(job, machine);
}

TEST(PerfectTrace, IsVerifiedHoweverFarR2StandsAboveR1) {
    for (const double layers_higher : {0.3, 0.5, 1.3, -0.5, -1.3}) {
        Profile machine_profile;
        machine_profile.head_r2_height_error_mm =
            layers_higher * SampleJob::kLayerPulses / machine_profile.y.pulses_per_mm;
        for (const Joining joining : {Joining::continuous, Joining::spiral}) {
            const SampleJob job(machine_profile, 5, 33, joining, [](double angle, double layer) {
                return 8.0 + 0.3 * std::sin(3.0 * angle + layer) + (layer < 2.2 ? 0.3 : -0.2) * layer;
            });
            PerfectMachine machine(job);
            machine.carve_job();
            SCOPED_TRACE(layers_higher);
            expect_perfect(job, machine);
        }
    }
}

TEST(PerfectTrace, LeavesTheCellsBetweenTheHeadsHalvesUncarvedAndSaysSo) {
    for (const double error_deg : {3.3, -30.0}) {
        Profile machine_profile;
        machine_profile.head_r2_angle_error_deg = error_deg;
        const SampleJob job(machine_profile, 3, 101, Joining::continuous,
                            [](double angle, double layer) { return 8.0 + std::sin(angle) - 0.3 * layer; });
        PerfectMachine machine(job);
        machine.carve_job();
        SCOPED_TRACE(error_deg);
        expect_perfect(job, machine);
        const VerifyReport report = verified(job, machine);
        const double gap_cells = std::abs(error_deg) / 1.8 * 3.0;
        EXPECT_NEAR(static_cast<double>(report.uncarved_cells), gap_cells, 4.0);
        EXPECT_NE(report_json(report).find("\"uncarved_cells\": " + std::to_string(report.uncarved_cells)),
                  std::string::npos);
        EXPECT_NE(report_text(report).find(std::to_string(report.uncarved_cells) + " cells"),
                  std::string::npos);
    }
}

TEST(PerfectTrace, OfHeadsThatMeetLeavesNothingUncarved) {
    const SampleJob job(Profile{}, 2, 33, Joining::continuous, [](double, double) { return 8.0; });
    PerfectMachine machine(job);
    machine.carve_job();
    EXPECT_EQ(verified(job, machine).uncarved_cells, 0U);
}

TEST(PathOffence, PointsThatWereNeverReachedStillDeviate) {
    const SampleJob job(Profile{}, 2, 33, Joining::continuous,
                        [](double, double layer) { return 8.0 - layer; });
    PerfectMachine machine(job);
    machine.approach().layer(0).finish();
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(report.max_deviation_pulses, 400);
    EXPECT_EQ(report.uncarved_cells, 64U);
}

TEST(JobGeometry, WantsARadiusInEveryDirectionWhateverTheAngleError) {
    for (const double error_deg : {-1.3, 0.0, 0.7}) {
        Profile machine_profile;
        machine_profile.head_r2_angle_error_deg = error_deg;
        const SampleJob job(machine_profile, 2, 33, Joining::continuous, [](double, double) { return 8.0; });
        const auto sut = JobGeometry::make(job.view(), job.profile);
        ASSERT_TRUE(sut);
        for (std::int64_t direction = 0; direction < sut->rev_pulses(); ++direction) {
            const auto wanted_mm = sut->wanted_mm(1, direction);
            ASSERT_TRUE(wanted_mm) << error_deg << " " << direction;
            ASSERT_DOUBLE_EQ(*wanted_mm, 8.0);
        }
    }
}

TEST(PerfectTrace, MayCountPsiWholeTurnsOff) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.start.position_pulses[2] = machine.position[2] = 0;
    machine.carve_job();
    machine.start.position_pulses[2] = -3 * job.profile.psi.pulses_per_rev;
    expect_perfect(job, machine);
}

TEST(PerfectTrace, MayBeginWithHomingBeforeWhichPositionsMeanNothing) {
    const SampleJob job = wavy_job();
    PerfectMachine machine(job);
    machine.start.position_pulses = machine.position = {0, 0, 0, 140};
    for (const Axis axis : kAllAxes) machine.set(enable_of(axis), true);
    machine.move(Axis::r1, 300).move(Axis::r2, 200).move(Axis::psi, 300).move(Axis::y, -40);
    machine.define_positions({24000, 24000, 10, 0}).carve_job();
    expect_perfect(job, machine);
}

TEST(PerfectTrace, CountsEachAxisPulses) {
    const SampleJob job = wavy_job(Joining::continuous, 1, 5);
    PerfectMachine machine(job);
    machine.carve_job();
    const VerifyReport report = verified(job, machine);
    EXPECT_EQ(report.pulses[index_of(Axis::psi)], 3200U);
    EXPECT_EQ(report.pulses[index_of(Axis::y)], 100U);
}

TEST(PerfectTrace, CarveSecondsRunFromLeavingTheFirstPointToReachingTheLast) {
    const SampleJob job(Profile{}, 1, 5, Joining::continuous, [](double, double) { return 8.0; });
    PerfectMachine machine(job);
    machine.approach().wait(5 * kNsPerS).layer(0).wait(5 * kNsPerS).finish();
    EXPECT_DOUBLE_EQ(verified(job, machine).carve_seconds, 7.9975);  // 3200 pulses, one in 2.5 ms
}

TEST(PerfectTrace, ComesOutAsTheWantedSurface) {
    const SampleJob job = wavy_job(Joining::continuous, 2, 321);
    PerfectMachine machine(job);
    machine.carve_job();
    auto sut = Verifier::make(job.view(), job.profile);
    ASSERT_TRUE(sut);
    EXPECT_TRUE(sut->begin(machine.start).has_value());
    sut->feed(machine.events);
    sut->finish();
    // Layer 1 is carved in the second half turn: R1 faces directions 180 to 360 degrees there.
    EXPECT_NEAR(sut->surface().radii_mm(1)[320], job.view().r_left_pulses(1)[0] / 400.0, 0.01);
    EXPECT_NEAR(sut->surface().radii_mm(0)[80], job.view().r_left_pulses(0)[80] / 400.0, 0.01);
    EXPECT_NEAR(sut->surface().radii_mm(0)[400], job.view().r_right_pulses(0)[80] / 400.0, 0.01);
}

}  // namespace
}  // namespace psicarve::verify
