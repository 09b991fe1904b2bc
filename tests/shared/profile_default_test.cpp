// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "shared/profile/profile.hpp"
#include "shared/profile/profile_table.hpp"
#include "tests/places.hpp"

namespace psicarve {
namespace {

// The machine's description lists the built-in profile; this is that listing, written out again.
constexpr const char* kListing = R"(name = "default"
core_radius_mm = 1.5
head_clearance_mm = 2.0

[tick]
period_us = 50
schedule = "single"
missed_alarm_per_s = 50

[axis.r1]
pulses_per_mm = 400
travel_mm = [0.0, 60.0]
speed_mm_s = 10.0
accel_mm_s2 = 100.0
start_stop_mm_s = 1.0
positive = "high"
home = "max"
home_position_mm = 60.0
home_speed_mm_s = 5.0
overtravel_mm = 1.0
backlash_mm = 0.0
tip_offset_mm = 0.0

[axis.r2]
pulses_per_mm = 400
travel_mm = [0.0, 60.0]
speed_mm_s = 10.0
accel_mm_s2 = 100.0
start_stop_mm_s = 1.0
positive = "high"
home = "max"
home_position_mm = 60.0
home_speed_mm_s = 5.0
overtravel_mm = 1.0
backlash_mm = 0.0
tip_offset_mm = 0.0

[axis.psi]
pulses_per_rev = 6400
speed_deg_s = 225.0
accel_deg_s2 = 2250.0
start_stop_deg_s = 22.5
positive = "high"
home = "index"
home_position_deg = 0.0
home_speed_deg_s = 45.0
index_tolerance_pulses = 2
backlash_deg = 0.0

[axis.y]
pulses_per_mm = 400
travel_mm = [0.0, 150.0]
speed_mm_s = 10.0
accel_mm_s2 = 100.0
start_stop_mm_s = 1.0
positive = "high"
home = "min"
home_position_mm = 0.0
home_speed_mm_s = 5.0
overtravel_mm = 1.0
backlash_mm = 0.0

[head.r2]
angle_error_deg = 0.0
height_error_mm = 0.0

[job]
feed_mm_s = 20.0
plunge_mm_s = 5.0
clearance_mm = 2.0
retract_mm = 5.0
spindle_spinup_s = 1.0
base_height_mm = 0.0
planner = "lookahead"
corner_deg = 5.0
path_tolerance_mm = 0.01
joining = "continuous"

[port]
dir_setup_ns = 5000
dir_hold_ns = 5000
step_high_ns = 10000
step_low_ns = 10000
input_filter_us = 100

[port.pins]
r1_step = 5
r1_dir = 9
r1_enable = 6
r2_step = 2
r2_dir = 17
r2_enable = 7
psi_step = 3
psi_dir = 8
psi_enable = 6
y_step = 14
y_dir = 4
y_enable = 1
spindle = 16
y_limit = 10
r2_limit = 11
psi_index = 12
r1_limit = 13
estop = 0
)";

Profile parsed(const std::string& text) {
    const auto result = parse_profile(text, "test.toml");
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result ? *result : Profile{};
}

TEST(ProfileDefault, TheListingOfTheMachineParsesToIt) {
    EXPECT_EQ(parsed(kListing), Profile{});
}

TEST(ProfileDefault, AnEmptyFileMeansIt) {
    EXPECT_EQ(parsed(""), Profile{});
}

TEST(ProfileDefault, PrintedItParsesBackToItself) {
    EXPECT_EQ(parsed(profile_to_toml(Profile{})), Profile{});
}

TEST(ProfileDefault, PassesItsOwnChecks) {
    const auto problem = profile_detail::check_profile(Profile{});
    EXPECT_FALSE(problem) << problem->key << ": " << problem->text;
}

TEST(ProfileDefault, EachAxisHasItsOwnValues) {
    const Profile profile =
        parsed("[axis.r2]\nspeed_mm_s = 7.5\n[axis.y]\nspeed_mm_s = 6\n[axis.r1]\ntip_offset_mm = -0.25\n");
    EXPECT_EQ(profile.r1.speed_mm_s, 10.0);
    EXPECT_EQ(profile.r2.speed_mm_s, 7.5);
    EXPECT_EQ(profile.y.speed_mm_s, 6.0);
    EXPECT_EQ(profile.r1.tip_offset_mm, -0.25);
    EXPECT_EQ(profile.r2.tip_offset_mm, 0.0);
}

TEST(ProfileToml, EveryWordAndTextSurvivesPrinting) {
    Profile profile;
    profile.name = "Fräse \"Ψ\" \\ 2 # no comment";
    profile.tick.schedule = Schedule::two_timer;
    profile.tick.period_us = 100;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->speed_mm_s = 5.0;
        axis->positive_is_high = false;
    }
    profile.psi.speed_deg_s = 90.0;
    profile.psi.positive_is_high = false;
    profile.psi.home = HomeSensor::none;
    profile.r1.home = HomeSensor::none;
    profile.r2.home = HomeSensor::min;
    profile.r2.home_position_mm = 0.5;
    profile.job.planner = Planner::angle;
    profile.job.joining = Joining::spiral;
    profile.tool = {ToolShape::vee, 6.35, 45.0, 12.0};
    profile.blank = {30.0, 60.0, 1.5, -2.25, 12.0};
    profile.gcode = {AxisNames::turning, SecondHead::follow, true, true};
    profile.port.pins[index_of(Signal::r1_step)] = -5;
    EXPECT_EQ(parsed(profile_to_toml(profile)), profile);
}

TEST(ProfileToml, AwkwardNumbersSurvivePrintingBitForBit) {
    std::mt19937_64 random(20240611);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int round = 0; round < 50; ++round) {
        Profile profile;
        profile.r1.pulses_per_mm = 300.0 + 100.0 * share(random);
        profile.r1.accel_mm_s2 = 1e-3 + 1e5 * share(random) * share(random);
        profile.head_r2_angle_error_deg = -45.0 + 90.0 * share(random);
        profile.job.path_tolerance_mm = 1e-6 * (1.0 + share(random));
        profile.job.clearance_mm = 1e-12 * share(random);
        profile.job.spindle_spinup_s = 600.0 * share(random);
        profile.y.travel_mm = {-10.0 * share(random), 100.0 + share(random)};
        EXPECT_EQ(parsed(profile_to_toml(profile)), profile);
    }
}

TEST(ProfileToml, FitsIntoAJob) {
    EXPECT_LT(profile_to_toml(Profile{}).size(), kProfileTextBytes / 2);
}

TEST(ProfileExamples, AllParse) {
    for (const auto& entry : std::filesystem::directory_iterator(in_source("examples"))) {
        if (entry.path().extension() != ".toml") continue;
        const auto result = load_profile(entry.path().string());
        EXPECT_TRUE(result) << (result ? "" : result.error().message);
    }
}

/// Gives one field another value of its own type.
void change(const profile_detail::KeySpec& key, Profile& profile) {
    std::visit(
        [](auto* field) {
            using T = std::remove_cvref_t<decltype(*field)>;
            if constexpr (std::is_same_v<T, std::string>) {
                *field += "x";
            } else if constexpr (std::is_same_v<T, std::array<double, 2>>) {
                (*field)[1] += 1.0;
            } else if constexpr (std::is_same_v<T, bool>) {
                *field = !*field;
            } else if constexpr (std::is_enum_v<T>) {
                *field = static_cast<T>(static_cast<int>(*field) == 0 ? 1 : 0);
            } else {
                *field = static_cast<T>(*field + T{1});
            }
        },
        key.field(profile));
}

TEST(MotionDifferences, NameExactlyTheKeysThatMatter) {
    for (const auto& key : profile_detail::key_table()) {
        Profile other;
        change(key, other);
        ASSERT_NE(other, Profile{}) << key.path;
        const auto named = motion_differences(Profile{}, other);
        if (key.matters_to_motion) {
            EXPECT_THAT(named, testing::ElementsAre(key.path));
        } else {
            EXPECT_THAT(named, testing::IsEmpty()) << key.path;
        }
    }
}

TEST(MotionDifferences, SpeedsMatterAndTheNameDoesNot) {
    Profile other;
    other.name = "another";
    other.port.pins[index_of(Signal::estop)] = 15;
    other.psi.speed_deg_s = 100.0;
    other.y.travel_mm[1] = 100.0;
    EXPECT_THAT(motion_differences(Profile{}, other),
                testing::ElementsAre("axis.psi.speed_deg_s", "axis.y.travel_mm"));
}

TEST(JobDifferences, LeaveTheBlankToTheJobThatKnowsIt) {
    Profile job;
    Profile machine;
    EXPECT_THAT(job_differences(job, machine), testing::IsEmpty());
    machine.blank.radius_mm = 20.0;
    EXPECT_THAT(job_differences(job, machine), testing::ElementsAre("blank.radius_mm"));
    job.blank.radius_mm = 10.0;
    EXPECT_THAT(job_differences(job, machine), testing::IsEmpty());
    machine.blank.radius_mm = 0.0;
    EXPECT_THAT(job_differences(job, machine), testing::IsEmpty());
    job.y.pulses_per_mm = 200.0;
    EXPECT_THAT(job_differences(job, machine), testing::ElementsAre("axis.y.pulses_per_mm"));
}

TEST(PlaceDifferences, AreThoseByWhichPulsesStandElsewhere) {
    Profile other;
    other.psi.accel_deg_s2 = 1000.0;
    other.job.planner = Planner::angle;
    EXPECT_THAT(place_differences(Profile{}, other), testing::IsEmpty());
    other.r1.tip_offset_mm = 0.5;
    other.y.pulses_per_mm = 200.0;
    EXPECT_THAT(place_differences(Profile{}, other),
                testing::ElementsAre("axis.r1.tip_offset_mm", "axis.y.pulses_per_mm"));
}

TEST(ProfileKeys, EveryFieldIsReachedByExactlyOneKey) {
    Profile profile;
    std::vector<const void*> places;
    for (const auto& key : profile_detail::key_table()) {
        std::visit([&](auto* field) { places.push_back(field); }, key.field(profile));
    }
    std::sort(places.begin(), places.end());
    EXPECT_EQ(std::adjacent_find(places.begin(), places.end()), places.end());
    // 3 of its own, 5 tick, 3 x 13 linear, 10 psi, 2 head, 11 job, 4 tool, 5 blank, 6 port, 25 pins.
    EXPECT_EQ(places.size(), 118U);
}

}  // namespace
}  // namespace psicarve
