// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/workpiece.hpp"

#include <gtest/gtest.h>

#include "tests/rtcore/sim/sim_rig.hpp"

namespace psicarve::sim {
namespace {

Profile crooked_machine() {
    Profile profile;
    profile.r1.tip_offset_mm = 0.2;
    profile.r1.tool_wear_mm = 0.05;
    profile.r2.tip_offset_mm = -0.1;
    profile.head_r2_angle_error_deg = 1.51;
    profile.head_r2_height_error_mm = 0.25;
    profile.blank.radius_mm = 10.0;
    profile.blank.height_mm = 5.0;
    return profile;
}

std::unique_ptr<Workpiece> blank() {
    return Workpiece::make(sim_config_from_profile(crooked_machine()));
}

// r1 9 mm, r2 8 mm, psi 90 degrees, y 1.005 mm
constexpr std::array<std::int64_t, kAxisCount> kPlace{3'600, 3'200, 1'600, 402};

TEST(Workpiece, EachTipCutsWhereItsHeadTrulyStands) {
    const auto sut = blank();
    sut->cut(Axis::r1, kPlace);
    sut->cut(Axis::r2, kPlace);
    const std::vector<Cut> cuts = sut->cuts();
    ASSERT_EQ(cuts.size(), 2U);
    EXPECT_DOUBLE_EQ(cuts[0].direction_deg, 90.0125) << "the middle of its cell";
    EXPECT_DOUBLE_EQ(cuts[0].height_mm, 1.005);
    EXPECT_DOUBLE_EQ(cuts[0].radius_mm, 9.25) << "offset and wear";
    EXPECT_EQ(cuts[0].head, Axis::r1);
    EXPECT_DOUBLE_EQ(cuts[1].direction_deg, 271.5125) << "half a turn and the error";
    EXPECT_DOUBLE_EQ(cuts[1].height_mm, 1.255);
    EXPECT_DOUBLE_EQ(cuts[1].radius_mm, 7.9);
    EXPECT_EQ(cuts[1].head, Axis::r2);
    EXPECT_EQ(
        csv_of(cuts),
        "direction_deg,height_mm,radius_mm,head\n90.0125,1.005,9.25000,r1\n271.5125,1.255,7.90000,r2\n");
}

TEST(Workpiece, WhatIsGoneStaysGone) {
    const auto sut = blank();
    auto place = kPlace;
    for (const std::int64_t r1_pulses : {3'000, 2'000, 3'800}) {
        place[0] = r1_pulses;
        sut->cut(Axis::r1, place);
    }
    ASSERT_EQ(sut->cuts().size(), 1U);
    EXPECT_DOUBLE_EQ(sut->cuts()[0].radius_mm, 5.25);
    EXPECT_EQ(sut->first_touch_pulses(Axis::r1), 3'000);
    EXPECT_EQ(sut->first_touch_pulses(Axis::r2), std::nullopt);
}

TEST(Workpiece, OutsideOfTheBlankNothingIsCut) {
    const auto sut = blank();
    auto place = kPlace;
    place[0] = 3'900;  // 9.75 mm and the tip: the blank's own radius
    sut->cut(Axis::r1, place);
    place = kPlace;
    place[3] = 2'000;  // the blank's top
    sut->cut(Axis::r1, place);
    place[3] = -1;
    sut->cut(Axis::r1, place);
    EXPECT_TRUE(sut->cuts().empty());
    EXPECT_EQ(sut->first_touch_pulses(Axis::r1), std::nullopt);
}

TEST(Workpiece, IsCutByWhatTheMotorsDoNotByWhatThePinsSay) {
    Profile profile;
    profile.blank.radius_mm = 30.0;  // where the heads stand at the start
    profile.blank.height_mm = 10.0;
    const SimConfig config = sim_config_from_profile(profile);
    SimRig rig(profile, config);
    rig.machine().set_workpiece(Workpiece::make(config));
    rig.aim(Axis::r1, false);
    rig.pulses(Axis::r1, 3);
    EXPECT_TRUE(rig.machine().workpiece()->cuts().empty()) << "its drive is off";
    rig.enable_all();
    rig.pulses(Axis::r1, 3);
    rig.machine().slip(Axis::r1, -2);
    const std::vector<Cut> cuts = rig.machine().workpiece()->cuts();
    ASSERT_EQ(cuts.size(), 1U);
    EXPECT_DOUBLE_EQ(cuts[0].direction_deg, 270.0125);
    EXPECT_DOUBLE_EQ(cuts[0].height_mm, 5.005);
    EXPECT_DOUBLE_EQ(cuts[0].radius_mm, 29.9875);
    EXPECT_EQ(rig.machine().workpiece()->first_touch_pulses(Axis::r1), 11'999);
    rig.aim(Axis::psi, true);
    rig.pulse(Axis::psi);
    EXPECT_EQ(rig.machine().workpiece()->cuts().size(), 2U) << "r2 stands at the blank's own radius";
}

}  // namespace
}  // namespace psicarve::sim
