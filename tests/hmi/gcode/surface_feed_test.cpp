// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/surface_feed.hpp"

#include <cmath>
#include <random>

#include "shared/base/units.hpp"
#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

Profile surface_profile() {
    Profile profile;
    profile.gcode.feeds_over_surface = true;
    return profile;
}

/// Of the last cutting move of a program that begins with these blocks.
CanonRecord last_cut(const std::string& blocks, const Profile& profile = surface_profile()) {
    const auto read = read_program("G21 G90 F300\n" + blocks + "\nM2\n", machine_options(profile), &profile);
    EXPECT_EQ(read->faults(), Faults{}) << blocks;
    CanonRecord last;
    for (const CanonRecord& record : read->records)
        if (record.kind == CanonKind::feed || record.kind == CanonKind::arc) last = record;
    return last;
}

TEST(SurfaceFeed, IsThatOfTheToolOverThePieceThatTurns) {
    const std::string out = "G0 X30 Z60 Y50 C0\n";
    const CanonRecord turn = last_cut(out + "G1 C90");
    EXPECT_NEAR(turn.length, 30.0 * kPi / 2.0, 1e-9);
    EXPECT_DOUBLE_EQ(turn.feed_per_min, 300.0);
    // At the greatest radius of the way.
    EXPECT_NEAR(last_cut(out + "G1 X20 Y40 C90").length, std::sqrt(200.0 + 30.0 * 30.0 * kPi * kPi / 4.0),
                1e-9);
    EXPECT_NEAR(last_cut(out + "G1 Y40").length, 10.0, 1e-12);
}

TEST(SurfaceFeed, IsThatOfTheFasterHeadUnlessItStaysOutside) {
    EXPECT_NEAR(last_cut("G0 X30 Z40 Y50 C0\nG1 C90").length, 40.0 * kPi / 2.0, 1e-9);
    EXPECT_NEAR(last_cut("G0 X30 Z60 Y50 C0\nG1 C90").length, 30.0 * kPi / 2.0, 1e-9);
    EXPECT_NEAR(last_cut("G0 X60 Z60 Y50 C0\nG1 C90").length, 60.0 * kPi / 2.0, 1e-9);
    // One that comes from there cuts.
    EXPECT_NEAR(last_cut("G0 X30 Z60 Y50 C0\nG1 Z50 C90").length, std::hypot(10.0, 60.0 * kPi / 2.0), 1e-9);
}

TEST(SurfaceFeed, IsCountedInMachineCoordinates) {
    EXPECT_NEAR(last_cut("G10 L2 P1 X10 C45\nG0 X20 Z50 Y50 C0\nG0 Z60\nG1 C90").length, 30.0 * kPi / 2.0,
                1e-9);
    Profile profile = surface_profile();
    profile.gcode.letters = AxisNames::turning;
    EXPECT_NEAR(last_cut("G0 X30 U60 Z50 C0\nG1 Z40 C90", profile).length, std::hypot(10.0, 30.0 * kPi / 2.0),
                1e-9);
}

TEST(SurfaceFeed, IsThatOfTheTips) {
    Profile profile = surface_profile();
    profile.r1.tip_offset_mm = 5.0;
    profile.r1.tool_wear_mm = 1.0;
    profile.r2.tip_offset_mm = -7.0;
    const auto turned_mm = [&](const std::string& begin) {
        return last_cut(begin + " Y50 C0\nG1 C90", profile).length / (kPi / 2.0);
    };
    EXPECT_NEAR(turned_mm("G0 X30 Z60"), 36.0, 1e-9);
    EXPECT_NEAR(turned_mm("G0 X30 Z50"), 43.0, 1e-9);
    EXPECT_NEAR(last_cut("G0 X30 Z60 Y50 C0\nG3 Y60 J5 C90", profile).length,
                std::hypot(5.0 * kPi, 41.0 * kPi / 2.0), 1e-9);
    EXPECT_NEAR(last_cut("G0 X30 Z45 Y50 C0\nG2 Y60 J5 C90", profile).length,
                std::hypot(5.0 * kPi, 38.0 * kPi / 2.0), 1e-9);
}

TEST(SurfaceFeed, OfAnArcThatTurnsIsThatOfItsFurthestPoint) {
    const CanonRecord turned = last_cut("G0 X30 Z60 Y50 C0\nG2 Y60 J5 C90");
    EXPECT_NEAR(turned.length, std::hypot(5.0 * kPi, 30.0 * kPi / 2.0), 1e-9);
    const CanonRecord outward = last_cut("G0 X30 Z60 Y50 C0\nG3 Y60 J5 C90");
    EXPECT_NEAR(outward.length, std::hypot(5.0 * kPi, 35.0 * kPi / 2.0), 1e-9);
    EXPECT_NEAR(last_cut("G0 X30 Z60 Y50 C0\nG3 Y60 J5").length, 5.0 * kPi, 1e-9);
}

TEST(SurfaceFeed, IsNeverExceededByATool) {
    std::mt19937 random{11};
    const auto within = [&](double least, double most) {
        return std::uniform_real_distribution<double>{least, most}(random);
    };
    const DrawingMachine machine = drawing_machine_of(surface_profile());
    for (int i = 0; i < 2'000; ++i) {
        const Position from{within(5.0, 55.0), within(0.0, 100.0), within(5.0, 55.0), 0, 0,
                            within(0.0, 90.0)};
        const Position to{within(5.0, 55.0),   within(0.0, 100.0), within(5.0, 55.0), 0, 0,
                          within(-90.0, 180.0)};
        const double length_mm = line_over_surface_mm(machine, from, to);
        for (const std::size_t letter : {std::size_t{0}, std::size_t{2}}) {
            for (int k = 0; k < 32; ++k) {
                const double radius_mm = from[letter] + (k + 0.5) / 32.0 * (to[letter] - from[letter]);
                const double speed = std::hypot(to[letter] - from[letter], to[1] - from[1],
                                                radius_mm * rad_from_deg(to[5] - from[5]));
                ASSERT_LE(speed, length_mm * (1.0 + 1e-12)) << i;
            }
        }
    }
}

TEST(SurfaceFeed, LeavesOtherFeedsAsTheyAre) {
    EXPECT_NEAR(last_cut("G0 X30 Z40 Y50 C0\nG1 C90", Profile{}).length, 90.0, 1e-12);
    EXPECT_NEAR(last_cut("G0 X30 Z40 Y50 C0\nG93 G1 C90 F2").feed_per_min, 2.0 * 40.0 * kPi / 2.0, 1e-9);
    EXPECT_NEAR(last_cut("G0 X30 Z40 Y50 C0\nG7.1 C10\nG1 C90").length, 10.0 * kPi / 2.0, 1e-9);
}

}  // namespace
}  // namespace psicarve::gcode
