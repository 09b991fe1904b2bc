// SPDX-License-Identifier: GPL-3.0-or-later
// G7.1: what is drawn, and what the axes do.
#include <algorithm>
#include <cmath>

#include "shared/base/units.hpp"
#include "tests/hmi/gcode/drawn_program.hpp"
#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

PlanePoint surface_at(const CanonRecord& record, double share, double radius_mm) {
    return {rad_from_deg(record.start[5] + share * (record.end[5] - record.start[5])) * radius_mm,
            record.start[1] + share * (record.end[1] - record.start[1])};
}

TEST(Cylinder, DrawsLinesStraightWithTheFeedOfTheUnrolledSurface) {
    const auto read = drawn(kCylinder + "G1 X45 Y60 C90\nG7.1 C0\nG1 C0\nM2\n");
    ASSERT_EQ(read->faults(), Faults{});
    const auto ways = of_line(*read, 4);
    ASSERT_EQ(ways.size(), 1U);
    const double turned_mm = 45.0 * kPi / 2.0;
    EXPECT_NEAR(ways[0].length, std::sqrt(25.0 + 100.0 + turned_mm * turned_mm), 1e-9);
    EXPECT_DOUBLE_EQ(ways[0].feed_per_min, 300.0);
    // Behind it C alone turns by degrees a minute.
    EXPECT_DOUBLE_EQ(of_line(*read, 6).back().length, 90.0);
}

TEST(Cylinder, DrawsCirclesWithinTheirShareOfTheTolerance) {
    const auto read = drawn(kCylinder + "G2 I10 J4 X45\nG7.1 C0\nM2\n");
    ASSERT_EQ(read->faults(), Faults{});
    const auto chords = of_line(*read, 4);
    ASSERT_GT(chords.size(), 16U);
    double along_mm = 0.0;
    for (const CanonRecord& chord : chords) {
        along_mm += chord.length;
        for (double share = 0.0; share <= 1.0; share += 0.125) {
            const PlanePoint there = surface_at(chord, share, 45.0);
            EXPECT_NEAR(std::hypot(there.first_mm - 10.0, there.second_mm - 54.0), std::hypot(10.0, 4.0),
                        kOwnToleranceMm / 4.0 + 1e-9);
        }
    }
    EXPECT_NEAR(along_mm, std::hypot(2.0 * kPi * std::hypot(10.0, 4.0), 5.0), 1e-9);
    EXPECT_EQ(chords.back().end, (Position{45.0, 50.0}));
    // Clockwise with C to the right and Y up: from the left over the top.
    EXPECT_GT(chords[4].end[1], 50.0);
}

TEST(Cylinder, JudgesAnAxisThatGetsItsFirstPlaceThereByItsEnd) {
    const auto read = drawn(kCylinder + "G2 I10 Z55\nG7.1 C0\nM2\n");
    EXPECT_EQ(read->faults(), Faults{});
    const auto chords = of_line(*read, 4);
    for (std::size_t i = 0; i < chords.size(); ++i)
        EXPECT_EQ((chords[i].placed & mask_of(2)) != 0, i + 1 == chords.size()) << i;
    EXPECT_EQ(drawn_faults(kCylinder + "G2 I10 Z65\nG7.1 C0\nM2\n"), Faults{"4:8 outside_travel"});
}

TEST(Cylinder, KeepsTheToleranceAtTheTipThatIsFurthestOut) {
    const auto most_off_mm = [](const std::string& begin, const Profile& profile, std::size_t head_letter,
                                double tip_mm) {
        const auto read = drawn(begin + "G7.1 C12\nG2 I10\nG7.1 C0\nM2\n", profile);
        EXPECT_EQ(read->faults(), Faults{});
        double most_mm = 0.0;
        for (const CanonRecord& chord : of_line(*read, 4)) {
            // Where the tip is off the circle along C it is further off by what it stands outside the
            // cylinder.
            const double scale = std::max(1.0, (chord.end[head_letter] + tip_mm) / 12.0);
            for (double share = 0.0; share <= 1.0; share += 0.125) {
                const PlanePoint there = surface_at(chord, share, 12.0);
                const double off_mm =
                    std::abs(std::hypot(there.first_mm - 10.0, there.second_mm - 50.0) - 10.0);
                most_mm = std::max(most_mm, off_mm * scale);
            }
        }
        return most_mm;
    };
    const double share_mm = kOwnToleranceMm / 4.0 + 1e-9;
    const std::string begin = "G21 G90 F300\nG0 X50 Y50 Z60 C0\n";
    EXPECT_LE(most_off_mm(begin, {}, 0, 0.0), share_mm);
    // The head that stays outside cuts nothing, any other does.
    EXPECT_LE(most_off_mm("G21 G90 F300\nG0 X12 Y50 Z55 C0\n", {}, 2, 0.0), share_mm);
    EXPECT_GT(most_off_mm("G21 G90 F300\nG0 X12 Y50 Z60 C0\n", {}, 2, 0.0), share_mm);
    Profile profile;
    profile.r1.tip_offset_mm = 30.0;
    EXPECT_LE(most_off_mm(begin, profile, 0, 30.0), share_mm);
}

TEST(Cylinder, DrawsWithZToTheRightAsLathesDo) {
    Profile profile;
    profile.gcode.letters = AxisNames::turning;
    const auto read =
        drawn("G21 G90 F300\nG0 X50 Z50 C0\nG7.1 C45\nG2 K10\nG2 C20 Z60 R40\nG7.1 C0\nM2\n", profile);
    ASSERT_EQ(read->faults(), Faults{});
    const auto chords = of_line(*read, 4);
    for (const CanonRecord& chord : chords)
        EXPECT_NEAR(std::hypot(rad_from_deg(chord.end[5]) * 45.0, chord.end[2] - 60.0), 10.0, 1e-9);
    EXPECT_GT(chords[4].end[5], 0.0);
    EXPECT_EQ(of_line(*read, 5).back().end[5], 20.0);
}

TEST(Drawing, CountsTheWayOfAnOwnR2ByWhicheverLetter) {
    Profile lathe;
    lathe.gcode.letters = AxisNames::turning;
    const auto length_mm = [](const std::string& block, const std::string& begin, const Profile& profile) {
        const auto read = drawn("G21 G90 F300\n" + begin + "\n" + block + "\nM2\n", profile);
        EXPECT_EQ(read->faults(), Faults{}) << block;
        double sum_mm = 0.0;
        for (const CanonRecord& record : of_line(*read, 4)) sum_mm += record.length;
        return sum_mm;
    };
    for (const std::string mode : {"G7.1 C20", "G12.1"}) {
        for (const auto& [ours, theirs] : std::vector<std::pair<std::string, std::string>>{
                 {"G1 X45 Z45 Y55", "G1 X45 U45 Z55"},
                 {"G2 I5 Z45", mode == "G12.1" ? "G2 I5 U45" : "G2 K5 U45"}})
            EXPECT_NEAR(length_mm(ours, "G0 X50 Z50 Y50 C0\n" + mode, {}),
                        length_mm(theirs, "G0 X50 U50 Z50 C0\n" + mode, lathe), 1e-9)
                << mode << " " << theirs;
    }
}

TEST(Cylinder, HasTheLettersOfAnArcsWordsWhereNoMachineIsAsked) {
    for (const std::string arc : {"G2 K10", "G2 I3 K4", "G2 Z60 R10", "G2 I10", "G2 J10", "G2 Y60 R10"})
        EXPECT_EQ(
            read_program("G21 G90 F300\nG0 X50 Y50 Z50 C0\nG7.1 C45\n" + arc + "\nG7.1 C0\nM2\n")->faults(),
            Faults{})
            << arc;
}

TEST(Cylinder, TakesItsRadiusInTheProgramsUnits) {
    const auto read = drawn("G20 G90 F10\nG0 X2 Y2 C0\nG7.1 C1\nG1 C180\nG7.1 C0\nM2\n");
    EXPECT_NEAR(of_line(*read, 4).back().length, 25.4 * kPi, 1e-9);
}

TEST(Cylinder, TurnsInTheAirAsItIsDrawn) {
    Profile profile;
    profile.gcode.turns_shortest = true;
    const auto last_turn = [&](const std::string& more) {
        const auto made = made_records("G21 G90\nG0 X50 Y50 C0\n" + more + "M2\n", {}, profile);
        EXPECT_EQ(made.failure, "");
        return made.ways().back().target[index_of(Axis::psi)];
    };
    EXPECT_DOUBLE_EQ(last_turn("G7.1 C45\nG0 C350\nG7.1 C0\n"), 350.0);
    EXPECT_DOUBLE_EQ(last_turn("G0 C350\n"), -10.0);
}

TEST(Cylinder, OfAnArcFromAnywhereJudgesTheEnd) {
    EXPECT_EQ(drawn_faults("G21 G90 F300\nG0 X50\nG7.1 C45\nG2 C20 Y160 R500\nG7.1 C0\nM2\n"),
              Faults{"4:4 outside_travel"});
    EXPECT_EQ(drawn_faults(kCylinder + "G2 C0 Y149 R-55\nG7.1 C0\nM2\n"), Faults{"4:4 outside_travel"});
}

}  // namespace
}  // namespace psicarve::gcode
