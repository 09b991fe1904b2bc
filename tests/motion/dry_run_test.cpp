// SPDX-License-Identifier: GPL-3.0-or-later
// Dry runs of the original machine, whose planner is "angle": table and Y jump where the job's points are,
// though no head visits them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>

#include "hmi/verify/verify_report.hpp"
#include "shared/profile/profile.hpp"
#include "tests/motion/carving_bench.hpp"
#include "tests/places.hpp"

namespace psicarve::motion {
namespace {

constexpr std::uint32_t kLayers = 4;
constexpr cycle::LayerRange kDry{0, 0, true};

Profile original_profile() {
    std::ifstream file(in_source("examples/original.toml"));
    const std::string toml{std::istreambuf_iterator<char>(file), {}};
    return parse_profile(toml, "original.toml").value();
}

/// On its sides psi is the long axis in the middle and a head is near the edges, so that psi's speed jumps.
JobTable box_of(const Profile& profile, double half_side_mm, std::uint32_t points, Joining joining) {
    const Shape box = [half_side_mm](double at, std::uint32_t) {
        return half_side_mm / std::max(std::fabs(std::cos(at)), std::fabs(std::sin(at)));
    };
    return table_of(profile, box, kLayers, points, joining);
}

class DryRuns : public ::testing::TestWithParam<Joining> {};

TEST_P(DryRuns, AskMotorsForNoMoreThanTheyHave) {
    const Profile profile = original_profile();
    for (const double half_side_mm : {2.0, 2.5, 3.0, 4.0}) {
        for (const std::uint32_t points : {20U, 40U, 60U, 100U}) {
            const JobTable table = box_of(profile, half_side_mm, points, GetParam());
            const Carved dry = carved(profile, table, {}, {.machine = {}, .layers = kDry});
            EXPECT_EQ(dry.report.rules[2].offences, 0U) << half_side_mm << " mm, " << points << " points\n"
                                                        << verify::report_text(dry.report);
        }
    }
}

// Between points a motor that has a sixth less than what it is asked for is found out.
TEST_P(DryRuns, OfAWeakerMotorAreOffences) {
    const Profile profile = original_profile();
    Profile weaker = profile;
    weaker.psi.accel_deg_s2 /= 1.18;
    const Shape cylinder = [](double, std::uint32_t) { return 3.0; };
    const JobTable table = table_of(profile, cylinder, kLayers, 5, GetParam());
    const Carved dry = carved(profile, table, {}, {.machine = {}, .layers = kDry, .judged_by = weaker});
    const auto& found = dry.report.rules[2];
    EXPECT_GT(found.offences, 0U);
    ASSERT_TRUE(found.first);
    EXPECT_EQ(found.first->axis, Axis::psi);
    EXPECT_EQ(found.first->fault, "acceleration");
}

INSTANTIATE_TEST_SUITE_P(Joinings, DryRuns, ::testing::Values(Joining::continuous, Joining::spiral));

}  // namespace
}  // namespace psicarve::motion
