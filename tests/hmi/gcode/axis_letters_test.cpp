// SPDX-License-Identifier: GPL-3.0-or-later
// What the profile's [gcode] changes: letters, the second head, rapid turns of psi.
#include "hmi/gcode/axis_letters.hpp"

#include <cmath>
#include <random>

#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

Profile machine_of(AxisNames letters, SecondHead second_head, bool turns_shortest = false) {
    Profile profile;
    profile.gcode = {letters, second_head, turns_shortest};
    return profile;
}

MadeRecords made_on(const std::string& text, const Profile& profile) {
    return made_records(text + "\nM2\n", {}, profile);
}

Faults judged_on(const std::string& text, const Profile& profile) {
    return read_program(text + "\nM2\n", {}, &profile)->faults();
}

using Places = std::array<double, kAxisCount>;

TEST(AxisLetters, AreThoseOfLathesWhereTheProfileSaysSo) {
    const Profile profile = machine_of(AxisNames::turning, SecondHead::own);
    const auto ways = made_on("G0 X20 U30 Z5 C9", profile).ways();
    ASSERT_EQ(ways.size(), 1U);
    EXPECT_EQ(ways[0].target, (Places{20.0, 30.0, 9.0, 5.0}));
    EXPECT_EQ(judged_on("G0 X20 U30 Z5 C9", profile), Faults{});
    EXPECT_EQ(judged_on("G0 Y5", profile), Faults{"1:4 axis_missing"});
    EXPECT_EQ(judged_on("G0 Z149\nZ151\nU1\nU61\nX-1", profile),
              (Faults{"2:1 outside_travel", "3:1 core_radius", "4:1 outside_travel", "5:1 outside_travel"}));
}

TEST(AxisLetters, OfLathesDrawArcsInTheirOwnPlane) {
    const Profile profile = machine_of(AxisNames::turning, SecondHead::own);
    const auto ways = made_on("F60 G18 G0 X40 Z50\nG3 X40 Z70 K10", profile).ways();
    ASSERT_GT(ways.size(), 10U);
    for (const MotionRecord& way : ways)
        EXPECT_NEAR(std::hypot(way.target[0] - 40.0, way.target[kY] - 60.0), 10.0, 1e-9);
    EXPECT_EQ(judged_on("F60 G18 G0 X40 Z50\nG3 X40 Z70 K10", profile), Faults{});
    EXPECT_EQ(judged_on("F60 G18 G0 X55 Z50\nG2 X55 Z70 K10\nG2 X55 Z50 K-10", profile),
              Faults{"2:4 outside_travel"});
    EXPECT_EQ(judged_on("F60 G17 G0 X40 Z50\nG3 X42 I1", profile), Faults{"2:4 arc_axes"});
    EXPECT_EQ(made_on("F60 G17 G0 X40 Z50\nG3 X42 I1", profile).failure,
              "line 2: an arc in XY does not move Y and one head");
}

TEST(AxisLetters, MoveBothHeadsByOneWordWhereTheSecondFollows) {
    for (const AxisNames letters : {AxisNames::machine, AxisNames::turning}) {
        const Profile profile = machine_of(letters, SecondHead::follow);
        const auto ways = made_on("G0 X20\nG1 X25 F60", profile).ways();
        ASSERT_EQ(ways.size(), 2U);
        EXPECT_EQ(ways[0].target, (Places{20.0, 20.0, 0.0, 0.0}));
        EXPECT_EQ(ways[1].target, (Places{25.0, 25.0, 0.0, 0.0}));
        EXPECT_DOUBLE_EQ(ways[1].seconds, 5.0);
        EXPECT_EQ(judged_on("G0 U5", profile), Faults{"1:4 axis_missing"});
    }
    EXPECT_EQ(judged_on("G0 Z5", machine_of(AxisNames::machine, SecondHead::follow)),
              Faults{"1:4 axis_missing"});
}

TEST(AxisLetters, OfAHeadThatFollowsAreJudgedForBoth) {
    Profile profile = machine_of(AxisNames::machine, SecondHead::follow);
    profile.head_clearance_mm = 4.0;
    profile.r2.travel_mm = {0.0, 50.0};
    profile.r2.home_position_mm = 50.0;
    EXPECT_EQ(judged_on("G0 X55", profile), Faults{"1:4 outside_travel"});
    EXPECT_EQ(judged_on("G0 X1.9", profile), Faults{"1:4 heads_meet"});
    EXPECT_EQ(judged_on("G0 X2.1", profile), Faults{});
    EXPECT_EQ(judged_on("F60 G0 X45 Y20\nG3 Y40 J10", profile), Faults{"2:4 outside_travel"});
}

TEST(AxisLetters, OfAHeadThatFollowsDrawTheSameArcTwice) {
    const Profile profile = machine_of(AxisNames::machine, SecondHead::follow);
    for (const MotionRecord& way : made_on("F60 G0 X40 Y50\nG3 Y70 J10", profile).ways())
        EXPECT_EQ(way.target[0], way.target[1]);
}

TEST(AxisLetters, PlaceTheReferenceByTheMachinesHome) {
    Profile profile = machine_of(AxisNames::turning, SecondHead::own);
    profile.r2.home_position_mm = 55.0;
    profile.y.home_position_mm = 2.0;
    const Position reference = MachineCheck::reference_of(profile);
    EXPECT_EQ(reference, (Position{60.0, 0.0, 2.0, 0.0, 0.0, 0.0, 55.0, 0.0, 0.0}));
    profile.gcode.second_head = SecondHead::follow;
    EXPECT_EQ(MachineCheck::reference_of(profile)[0], 60.0);
}

std::vector<double> psi_of(const std::string& text, bool turns_shortest) {
    std::vector<double> found;
    for (const MotionRecord& way :
         made_on(text, machine_of(AxisNames::machine, SecondHead::own, turns_shortest)).ways())
        found.push_back(way.target[kPsi]);
    return found;
}

TEST(RapidPsi, TurnsAsItIsWrittenUnlessTheProfileSaysOtherwise) {
    EXPECT_EQ(psi_of("G0 C350\nC710", false), (std::vector<double>{350.0, 710.0}));
}

TEST(RapidPsi, TakesTheShortestWayAndOtherMovesGoOnFromThere) {
    EXPECT_EQ(psi_of("F600 G0 C350\nG1 C360\nG0 C0\nY5\nG1 C-90\nG28", true),
              (std::vector<double>{-10.0, 0.0, 0.0, -90.0, 0.0}));
    EXPECT_EQ(psi_of("G0 C180\nC0\nC-180", true), (std::vector<double>{180.0, 0.0, -180.0}));
}

TEST(RapidPsi, EndsInTheDirectionThatIsWrittenByHalfATurnAtMost) {
    std::mt19937 random{88};
    std::uniform_int_distribution<int> eighths{-20000, 20000};
    std::string text = "F600\n";
    std::vector<double> written_deg;
    std::vector<bool> are_rapid;
    for (int i = 0; i < 300; ++i) {
        written_deg.push_back(eighths(random) / 8.0);
        are_rapid.push_back(i % 3 != 0);
        text += (are_rapid.back() ? "G0 Y" : "G1 Y") + std::to_string(1 + i % 2) + " C" +
                std::to_string(written_deg.back()) + "\n";
    }
    const std::vector<double> psi_deg = psi_of(text, true);
    ASSERT_EQ(psi_deg.size(), written_deg.size());
    for (std::size_t i = 1; i < psi_deg.size(); ++i) {
        EXPECT_EQ(std::remainder(psi_deg[i] - written_deg[i], 360.0), 0.0) << i;
        const double turned_deg = psi_deg[i] - psi_deg[i - 1];
        if (are_rapid[i]) {
            EXPECT_LE(std::abs(turned_deg), 180.0) << i;
        } else {
            EXPECT_EQ(turned_deg, written_deg[i] - written_deg[i - 1]) << i;
        }
    }
}

}  // namespace
}  // namespace psicarve::gcode
