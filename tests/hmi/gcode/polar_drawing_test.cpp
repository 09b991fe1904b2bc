// SPDX-License-Identifier: GPL-3.0-or-later
// G12.1: what is drawn, and what the axes do.
#include <cmath>
#include <random>

#include "shared/base/units.hpp"
#include "tests/hmi/gcode/drawn_program.hpp"
#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

/// Where r1 and psi stand, in the cross-section, and a share of the way between both.
PlanePoint cross_section_at(const CanonRecord& record, double share) {
    const double radius_mm = record.start[0] + share * (record.end[0] - record.start[0]);
    const double angle_rad = rad_from_deg(record.start[5] + share * (record.end[5] - record.start[5]));
    return {radius_mm * std::cos(angle_rad), radius_mm * std::sin(angle_rad)};
}

TEST(Polar, WaysKeepTheirShareOfTheToleranceWhateverIsDrawn) {
    std::mt19937 random{7};
    const auto within = [&](double least, double most) {
        return std::uniform_real_distribution<double>{least, most}(random);
    };
    std::string text = "G21 G90 F300\nG0 X40 Z55 C0 Y10\nG12.1\n";
    PlanePoint at{40.0, 0.0};
    std::vector<std::array<PlanePoint, 2>> ends;  // of lines; of arcs: the end and the centre
    for (int i = 0; i < 400; ++i) {
        const double angle_rad = std::atan2(at.second_mm, at.first_mm) + within(-1.2, 1.2);
        const double radius_mm = within(12.0, 40.0);
        const PlanePoint to{radius_mm * std::cos(angle_rad), radius_mm * std::sin(angle_rad)};
        char block[120];
        std::snprintf(block, sizeof block, "G1 X%.6f C%.6f\n", to.first_mm, to.second_mm);
        text += block;
        at = to;
        // And a whole circle there, away from the axis.
        const double scale = 1.0 + within(-2.0, 2.0) / radius_mm;
        std::snprintf(block, sizeof block, "G3 I%.6f J%.6f\n", at.first_mm * (scale - 1.0),
                      at.second_mm * (scale - 1.0));
        text += block;
        ends.push_back({to, {at.first_mm * scale, at.second_mm * scale}});
    }
    const auto read = drawn(text + "G13.1\nM2\n");
    ASSERT_EQ(read->faults(), Faults{});
    PlanePoint from{40.0, 0.0};
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const auto& [to, centre] = ends[i];
        const double length_mm = std::hypot(to.first_mm - from.first_mm, to.second_mm - from.second_mm);
        const double circle_mm = std::hypot(to.first_mm - centre.first_mm, to.second_mm - centre.second_mm);
        const auto line = of_line(*read, 4 + 2 * i);
        const auto circle = of_line(*read, 5 + 2 * i);
        double line_length_mm = 0.0;
        for (const CanonRecord& chord : line) {
            line_length_mm += chord.length;
            for (double share = 0.0; share <= 1.0; share += 0.0625) {
                const PlanePoint there = cross_section_at(chord, share);
                const double off_mm =
                    std::abs((there.first_mm - from.first_mm) * (to.second_mm - from.second_mm) -
                             (there.second_mm - from.second_mm) * (to.first_mm - from.first_mm)) /
                    length_mm;
                ASSERT_LE(off_mm, kOwnToleranceMm / 4.0 + 1e-5) << i;
            }
        }
        double circle_length_mm = 0.0;
        for (const CanonRecord& chord : circle) {
            circle_length_mm += chord.length;
            for (double share = 0.0; share <= 1.0; share += 0.0625) {
                const PlanePoint there = cross_section_at(chord, share);
                ASSERT_NEAR(std::hypot(there.first_mm - centre.first_mm, there.second_mm - centre.second_mm),
                            circle_mm, kOwnToleranceMm / 4.0 + 1e-5)
                    << i;
            }
        }
        ASSERT_NEAR(line_length_mm, length_mm, 1e-4);
        ASSERT_NEAR(circle_length_mm, 2.0 * kPi * circle_mm, 1e-4);
        ASSERT_FALSE(line.back().ends_within);
        const PlanePoint end = cross_section_at(line.back(), 1.0);
        ASSERT_NEAR(end.first_mm, to.first_mm, 1e-5);
        ASSERT_NEAR(end.second_mm, to.second_mm, 1e-5);
        from = to;
    }
}

TEST(Polar, CountsAllTurnsAndGoesOnFromThem) {
    const auto read = drawn(kPolar + "G1 X30\nG3 I-30 P2\nG2 X0 C30 I-30\nG13.1\nG1 X35 C0\nM2\n");
    ASSERT_EQ(read->faults(), Faults{});
    // About the axis one way does for both turns.
    ASSERT_EQ(of_line(*read, 5).size(), 1U);
    EXPECT_DOUBLE_EQ(of_line(*read, 5).back().end[5], 720.0);
    EXPECT_NEAR(of_line(*read, 6).back().end[5], 450.0, 1e-9);
    EXPECT_EQ(of_line(*read, 8).back().end[5], 0.0);
}

TEST(Polar, BeginsWhereTheMachineStandsWhateverCSays) {
    const auto read = drawn("G21 G90 F300\nG0 X40 C450\nG12.1\nG1 C30\nG13.1\nM2\n");
    ASSERT_EQ(read->faults(), Faults{});
    // C450 is the direction of 90 degrees: along X 0.
    EXPECT_NEAR(of_line(*read, 4).back().end[0], 30.0, 1e-9);
    EXPECT_NEAR(of_line(*read, 4).back().end[5], 450.0, 1e-9);
}

TEST(Polar, TakesStepsInchesAndAbsoluteCentres) {
    const auto end_of = [](const std::string& blocks) {
        const auto read = drawn(kPolar + blocks + "\nM2\n");
        EXPECT_EQ(read->faults(), Faults{}) << blocks;
        return cross_section_at(read->of_kind(CanonKind::feed).back(), 1.0);
    };
    EXPECT_NEAR(end_of("G91 G1 X-5 C3\nX-5 C3").second_mm, 6.0, 1e-9);
    EXPECT_NEAR(end_of("G91 G1 X-5 C3\nX-5 C3").first_mm, 30.0, 1e-9);
    EXPECT_NEAR(end_of("G20\nF10\nG1 X1 C.5").second_mm, 12.7, 1e-9);
    EXPECT_NEAR(end_of("G90.1 G2 X30 C-10 I30 J0").second_mm, -10.0, 1e-9);
}

TEST(Polar, MovesOtherAxesEvenlyAlong) {
    const auto read = drawn(kPolar + "G1 X20 C30 Y20\nG13.1\nM2\n");
    const auto chords = of_line(*read, 4);
    ASSERT_GT(chords.size(), 4U);
    double along_mm = 0.0;
    for (const CanonRecord& chord : chords) {
        along_mm += chord.length;
        const PlanePoint there = cross_section_at(chord, 1.0);
        EXPECT_NEAR((chord.end[1] - 10.0) / 10.0, there.second_mm / 30.0, 1e-6);
        EXPECT_DOUBLE_EQ(chord.feed_per_min, 300.0);
    }
    EXPECT_NEAR(along_mm, std::sqrt(20.0 * 20.0 + 30.0 * 30.0 + 10.0 * 10.0), 1e-9);
}

TEST(Polar, RefusesAWayThroughTheCoreWithThePoint) {
    Profile profile;
    profile.core_radius_mm = 5.0;
    const auto read = drawn(kPolar + "G1 X20 C4\nX-20\nX-20 C6\nX20\nM2\n", profile);
    ASSERT_FALSE(read->problems.errors().empty());
    EXPECT_EQ(read->faults(), Faults{"5:1 core_radius"});
    EXPECT_EQ(what_text(read->problems.errors().front()),
              "at X 0.0000 C 4.0000 mm the tip of r1 comes to 4.0000 mm, and the core that it must not reach "
              "ends at 5.0000 mm");
    // To the pulse: 400 of them a mm.
    EXPECT_EQ(drawn_faults(kPolar + "G1 X20 C4.999\nX-20\nM2\n", profile), Faults{});
    EXPECT_EQ(drawn_faults(kPolar + "G1 X20 C4.998\nX-20\nM2\n", profile), Faults{"5:1 core_radius"});
    // An arc over the axis' other side, and one that keeps out.
    EXPECT_EQ(drawn_faults(kPolar + "G1 X20\nG3 X-3 I-11.5\nM2\n", profile), Faults{"5:4 core_radius"});
    EXPECT_EQ(drawn_faults(kPolar + "G1 X20\nG3 X-20 I-20\nM2\n", profile), Faults{});
}

TEST(Polar, RefusesTheAxisWhereNoMachineIsAsked) {
    const auto read = read_program("G21 G90 F300\nG0 X40 C0\nG12.1\nG1 X-40\nM2\n");
    ASSERT_FALSE(read->problems.errors().empty());
    EXPECT_EQ(read->faults(), Faults{"4:4 core_radius"});
    EXPECT_EQ(what_text(read->problems.errors().front()), "at X 0.0000 C 0.0000 mm the way passes the axis");
    EXPECT_EQ(read_program("G21 G90 F300\nG0 X40 C0\nG12.1\nG1 C.01\nX-40\nM2\n")->faults(), Faults{});
}

TEST(Polar, CountsAToolsLengthToTheCore) {
    Profile profile;
    profile.core_radius_mm = 5.0;
    EXPECT_EQ(drawn_faults("G21 G90 F300\nG43.1 X3\nG0 X40 C0\nG12.1\nG1 X20 C4\nX-20\nM2\n", profile),
              Faults{});
    EXPECT_EQ(drawn_faults("G21 G90 F300\nG43.1 X-3\nG0 X40 C0\nG12.1\nG1 X20 C7\nX-20\nM2\n", profile),
              Faults{"6:1 core_radius"});
}

TEST(Polar, DrawsWithTheTipHoweverFarThatIsFromWhereItsHeadIsCounted) {
    Profile profile;
    profile.core_radius_mm = 5.0;
    profile.r1.tip_offset_mm = 5.5;
    profile.r1.tool_wear_mm = 0.5;
    profile.r2.tip_offset_mm = 2.0;
    const auto read =
        drawn("G21 G90 F300\nG0 X40 C0\nG12.1\nG1 X#5420 C30\nX30\nX-30 C20\nG13.1\nG0 X24\nM2\n", profile);
    ASSERT_EQ(read->faults(), Faults{});
    const auto tip_at = [](const CanonRecord& record, double share) {
        CanonRecord moved = record;
        moved.start[0] += 6.0;
        moved.end[0] += 6.0;
        return cross_section_at(moved, share);
    };
    EXPECT_NEAR(tip_at(of_line(*read, 4).back(), 1.0).first_mm, 46.0, 1e-9);
    EXPECT_NEAR(tip_at(of_line(*read, 5).back(), 1.0).first_mm, 30.0, 1e-9);
    for (const CanonRecord& chord : of_line(*read, 6))
        for (double share = 0.0; share <= 1.0; share += 0.0625) {
            const PlanePoint there = tip_at(chord, share);
            EXPECT_NEAR(there.second_mm, 25.0 + there.first_mm / 6.0, kOwnToleranceMm / 3.0);
        }
    // Behind it X counts as ever.
    EXPECT_EQ(read->records[read->records.size() - 2].end[0], 24.0);
    // The core is the tip's; there X counts -1.
    profile.r1.travel_mm = {-10.0, 60.0};
    EXPECT_EQ(drawn_faults("G21 G90 F300\nG0 X40 C0\nG12.1\nG1 X20 C5\nX-20\nM2\n", profile), Faults{});
    EXPECT_EQ(drawn_faults("G21 G90 F300\nG0 X40 C0\nG12.1\nG1 X20 C4.9\nX-20\nM2\n", profile),
              Faults{"5:1 core_radius"});
}

TEST(Polar, FindsTheTipAgainBehindAWrongBlock) {
    Profile profile;
    profile.r1.tip_offset_mm = 6.0;
    EXPECT_EQ(drawn_faults(kPolar + "G1 X&\nG1 F300 X20 C0\nX66\nX66.1\nG13.1\nM2\n", profile),
              (Faults{"4:4 number_missing", "7:1 outside_travel"}));
}

TEST(Polar, IsRefusedWhereTheHeadThatFollowsHasItsTipElsewhere) {
    Profile profile;
    profile.gcode.second_head = SecondHead::follow;
    profile.r1.tip_offset_mm = profile.r2.tip_offset_mm = 3.0;
    EXPECT_EQ(drawn_faults(kPolar + "G1 X30\nM2\n", profile), Faults{});
    profile.r2.tool_wear_mm = 0.2;
    const auto read = drawn(kPolar + "G1 X30\nM2\n", profile);
    ASSERT_EQ(read->faults(), Faults{"3:1 drawing_begin"});
    EXPECT_EQ(what_text(read->problems.errors().front()),
              "G12.1, and the tip of r2, which follows, stands 0.2000 mm further out");
    profile.gcode.second_head = SecondHead::own;
    EXPECT_EQ(drawn_faults(kPolar + "G1 X30\nM2\n", profile), Faults{});
}

TEST(Polar, KeepsBothHeadsOutOfTheirCoresWhereTheSecondFollows) {
    Profile profile;
    profile.gcode.second_head = SecondHead::follow;
    profile.core_radius_mm = 5.0;
    profile.r1.pulses_per_mm = 100.0;
    profile.r2.pulses_per_mm = 800.0;
    const auto what = [&](const std::string& out) {
        const auto read = drawn(kPolar + "G1 X20 C" + out + "\nX-20\nM2\n", profile);
        EXPECT_LE(read->problems.errors().size(), 1U) << out;
        return read->problems.errors().empty() ? "" : what_text(read->problems.errors().front());
    };
    EXPECT_EQ(what("5"), "");
    // To the pulse of each: that is still r1's last one, and three of r2's too far in.
    EXPECT_EQ(what("4.996"),
              "at X 0.0000 C 4.9960 mm the tip of r2 comes to 4.9960 mm, and the core that it must not reach "
              "ends at 5.0000 mm");
    EXPECT_NE(what("4.98").find("the tip of r1 comes to 4.9800 mm"), std::string::npos);
    profile.gcode.second_head = SecondHead::own;
    EXPECT_EQ(what("4.996"), "");
}

TEST(Polar, TellsOnceThatAWayLeavesTheTravel) {
    EXPECT_EQ(drawn_faults(kPolar + "G1 X45 C50\nX44 C0\nM2\n"),
              (Faults{"4:4 outside_travel", "5:1 outside_travel"}));
}

TEST(Polar, JudgesAnAxisThatGetsItsFirstPlaceThereByItsEnd) {
    EXPECT_EQ(drawn_faults("G21 G90 F300\nG0 X40 C0\nG12.1\nG1 X25 C30 Z55\nG13.1\nM2\n"), Faults{});
    EXPECT_EQ(drawn_faults("G21 G90 F300\nG0 X40 C0\nG12.1\nG1 X25 C30 Z65\nG13.1\nM2\n"),
              Faults{"4:4 outside_travel"});
    EXPECT_EQ(drawn_faults("G21 G90 F300\nG0 X40 C0\nG12.1\nG1 X25 C30 Z55\nX20 Z.5\nG13.1\nM2\n"),
              Faults{"5:1 core_radius"});
}

TEST(Polar, IsJudgedAgainBehindAWrongBlockOnceItsPlaceIsSaid) {
    Profile profile;
    profile.core_radius_mm = 5.0;
    EXPECT_EQ(drawn_faults(kPolar + "G1 X&\nX-20\nG1 F300 C4\nX20\nX20 C4\nX-20\nG13.1\nM2\n", profile),
              (Faults{"4:4 number_missing", "9:1 core_radius"}));
}

TEST(Polar, IsReadByParametersAsItIsDrawn) {
    const auto read =
        drawn(kPolar + "G1 X20 C30\nG1 X[#5420 + 1] C[#<_c> * 1.1]\nG13.1\nG1 X#<_plane> Y10\nM2\n");
    const PlanePoint there = cross_section_at(of_line(*read, 5).back(), 1.0);
    EXPECT_NEAR(there.first_mm, 21.0, 1e-9);
    EXPECT_NEAR(there.second_mm, 33.0, 1e-9);
}

TEST(Polar, RunsItsWaysAsOneBlockWhoseEndAloneIsExact) {
    const MadeRecords made =
        made_records("G21 G90 F300\nG0 X40 C0\nG61\nG12.1\nG1 X25 C30\nG13.1\nM2\n", {}, {});
    ASSERT_EQ(made.failure, "");
    std::vector<MotionRecord> chords;
    for (const MotionRecord& way : made.ways())
        if (way.line == 5) chords.push_back(way);
    ASSERT_GT(chords.size(), 8U);
    double seconds = 0.0;
    for (std::size_t i = 0; i < chords.size(); ++i) {
        const bool is_last = i + 1 == chords.size();
        EXPECT_DOUBLE_EQ(chords[i].tolerance_mm, is_last ? 0.0 : 0.75 * kOwnToleranceMm);
        EXPECT_EQ((chords[i].flags & kEndsBlock) != 0, is_last);
        seconds += chords[i].seconds;
    }
    EXPECT_NEAR(seconds, std::hypot(15.0, 30.0) / 300.0 * 60.0, 1e-9);
    EXPECT_DOUBLE_EQ(chords.back().target[index_of(Axis::r1)], std::hypot(25.0, 30.0));
}

TEST(Polar, GoesOnFromALineWithinIt) {
    const std::string text = "G21 G90 F300\nG0 X40 C0\nG12.1\nG1 X25 C30\nG1 X-25\nG1 C-30\nG13.1\nM2\n";
    const MadeRecords whole = made_records(text);
    const MadeRecords part = made_records(text, {.from_line = 6});
    const auto ends_of = [](const MadeRecords& made) {
        std::vector<std::array<double, kAxisCount>> ends;
        for (const MotionRecord& way : made.ways())
            if (way.line == 6 && (way.flags & kIsRapid) == 0) ends.push_back(way.target);
        return ends;
    };
    ASSERT_GT(ends_of(whole).size(), 8U);
    EXPECT_EQ(ends_of(part), ends_of(whole));
    EXPECT_LT(part.ways().size(), whole.ways().size());
}

}  // namespace
}  // namespace psicarve::gcode
