// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/machine_check.hpp"

#include "tests/hmi/gcode/read_program.hpp"

namespace psicarve::gcode {
namespace {

Faults faults_of(const std::string& text, const Profile& profile = {}) {
    return read_program(text, {}, &profile)->faults();
}

TEST(MachineCheck, TakesWhatTheMachineCanDo) {
    EXPECT_EQ(faults_of("G21 F100\nG0 X60 Y0 Z1.5 C720\nG1 X1.5 Y150 Z60\nG0 X20 Y50\nG3 Y60 J5\nG28\nM2\n"),
              Faults{});
}

TEST(MachineCheck, JudgesTravelToThePulse) {
    // 400 pulses a mm: less than half a pulse is none.
    EXPECT_EQ(faults_of("G0 X60.001 Y150.001\nM2\n"), Faults{});
    EXPECT_EQ(faults_of("G0 X60.002\nG0 Y150.002\nG0 Y-.002\nM2\n"),
              (Faults{"1:4 outside_travel", "2:4 outside_travel", "3:4 outside_travel"}));
}

TEST(MachineCheck, DoesNotJudgeAnAxisBeforeTheProgramPlacesIt) {
    EXPECT_EQ(faults_of("G91 G0 X-500\nG90 Y20\nM2\n"), Faults{});
    EXPECT_EQ(faults_of("G91 G0 X-500\nG90 G0 X20\nG91 X-500\nM2\n"), Faults{"3:5 outside_travel"});
}

TEST(MachineCheck, JudgesTheFirstPlaceOfAnAxisWhateverItIs) {
    EXPECT_EQ(faults_of("G0 X0\nM2\n"), Faults{"1:4 core_radius"});
    EXPECT_EQ(faults_of("G0 X20\nG0 Z0\nZ0\nM2\n"), Faults{"2:4 core_radius"});
}

TEST(MachineCheck, FindsHowFarAnArcReaches) {
    // From the left to the right of a circle of 10 mm about (51, 40), over its top and below it.
    const std::string begin = "F100\nG0 X41 Y40\n";
    EXPECT_EQ(faults_of(begin + "G2 X61 I10\nM2\n"), Faults{"3:4 outside_travel"});
    EXPECT_EQ(faults_of("F100\nG0 X55 Y10\nG3 X55 Y30 J10\nM2\n"), Faults{"3:4 outside_travel"});
    EXPECT_EQ(faults_of("F100\nG0 X55 Y10\nG2 X55 Y30 J10\nM2\n"), Faults{});
    EXPECT_EQ(faults_of("F100\nG0 Z55 Y10\nG19 G2 Z55 Y10 J10\nM2\n"), Faults{"3:8 outside_travel"});
    EXPECT_EQ(faults_of("F100\nG0 X5 Y10\nG2 X5 Y20 J5\nM2\n"), Faults{"3:4 core_radius"});
}

TEST(MachineCheck, JudgesTheEndOfAnArcWhoseStartIsHalfKnown) {
    EXPECT_EQ(faults_of("F100 G0 X40\nG2 X4000 Y0 R5000\nM2\n"), Faults{"2:4 outside_travel"});
    EXPECT_EQ(faults_of("F100 G0 X40\nG2 X50 Y170 R500\nM2\n"), Faults{"2:4 outside_travel"});
    EXPECT_EQ(faults_of("F100 G0 X40\nG2 X50 Y10 R50\nG91 G0 Y160\nM2\n"), Faults{"3:8 outside_travel"});
}

TEST(MachineCheck, DoesNotTakeAnUnknownPlaceForZero) {
    // Wherever the heads stand, that is called 0 from here on.
    EXPECT_EQ(faults_of("G92 X0 Y0 Z0\nG0 X-5 Y-5 Z-5\nM2\n"), Faults{});
    EXPECT_EQ(faults_of("G10 L20 P1 X0 Y0 Z0\nG0 X-5 Y-5 Z-5\nM2\n"), Faults{});
    EXPECT_EQ(faults_of("G28.1\nG0 X20 Y20 Z20\nG28\nM2\n"), Faults{});
    // The machine's own coordinates are known all the same, and so is what is told from a known place.
    EXPECT_EQ(faults_of("G92 Y0\nG0 Y-5\nG53 G0 Y170\nM2\n"), Faults{"3:8 outside_travel"});
    EXPECT_EQ(faults_of("G92 Y0\nG53 G0 Y10\nG0 Y-500\nM2\n"), Faults{});
    EXPECT_EQ(faults_of("G0 Y20\nG92 Y0\nG0 Y-25\nM2\n"), Faults{"3:4 outside_travel"});
    EXPECT_EQ(faults_of("G92 Y0\nG92.1\nG0 Y-5\nM2\n"), Faults{"3:4 outside_travel"});
    EXPECT_EQ(faults_of("G10 L20 P1 Y0\nG10 L2 P1 Y0\nG0 Y-5\nM2\n"), Faults{"3:4 outside_travel"});
    EXPECT_EQ(faults_of("G10 L20 P2 Y0\nG0 Y-5\nM2\n"), Faults{"2:4 outside_travel"});
}

TEST(MachineCheck, DoesNotTakeAnUnknownValueForAZero) {
    const auto unknown = [](const std::string& text) {
        InterpreterOptions options;
        options.is_start_known = false;
        const Profile profile;
        return read_program(text + "\nG0 Y10\nG0 Y-5\nM2\n", options, &profile)->faults();
    };
    EXPECT_EQ(unknown("G10 L2 P1 Y[#5421+1]"), Faults{});
    EXPECT_EQ(unknown("G53 G0 Y5\nG10 L20 P1 Y[#5420]"), Faults{});
    EXPECT_EQ(unknown("G53 G0 Y5\nG92 Y[#5420]"), Faults{});
    EXPECT_EQ(unknown("G43.1 Y[#5420]"), Faults{});
    EXPECT_EQ(unknown("G43.1 Y[#5420]\nG49"), Faults{"4:4 outside_travel"});
    EXPECT_EQ(unknown("G10 L2 P1 Y1"), Faults{"3:4 outside_travel"});
}

// The core refuses the record; until then the program would have run.
TEST(MachineCheck, RefusesDwellsAndWaysLongerThanADay) {
    EXPECT_EQ(faults_of("G4 P86400\nM2\n"), Faults{});
    EXPECT_EQ(faults_of("G0 X20\nG4 P86401\nM2\n"), Faults{"2:1 out_of_range"});
    EXPECT_EQ(faults_of("G0 X20 Y20\nG1 Y21 F.001\nM2\n"), Faults{});
    EXPECT_EQ(faults_of("G0 X20 Y20\nG1 Y30 F.001\nG0 Y20\nM2\n"), Faults{"2:4 out_of_range"});
    EXPECT_EQ(faults_of("G0 X20 Y20\nG93 G1 Y21 F.0001\nM2\n"), Faults{"2:8 out_of_range"});
    EXPECT_EQ(faults_of("G0 X20 Y20\nG2 X40 Y20 I10 F.001\nM2\n"), Faults{"2:4 out_of_range"});
}

TEST(MachineCheck, WarnsOfWhatTheMachineCannotSwitchAndTheProgramIsRight) {
    const Profile profile;
    const auto read = read_program("S100 M3\nM8\nM9\nM2\n", {}, &profile);
    EXPECT_EQ(read->problems.error_count(), 0U);
    EXPECT_EQ(read->faults(), (Faults{"1:1 speed_unused", "2:1 coolant_unused"}));
}

// Of each kind once, where it comes first, however many there are and whatever else is told.
TEST(MachineCheck, WarnsOnceOfEachKindOfWayThatIsNotStepped) {
    Profile profile;
    const std::string text =
        "G21 G90 F600\nG0 X50 Z50 Y40 C0\nG1 X49\nG17 G3 X48 Y41 I-1 J0\no1 repeat [300]\nS100\n"
        "G1 X49 C5\nG1 X48 C0\no1 endrepeat\nG1 X50 Z49\nG3 I-.01\nG3 I-1 C9\nG19 G3 K-1 Z49 X49\nG3 K-.02\n"
        "G0 C0\nG0 X59\nG17 G3 X57 Y39 I-1 J-1\nG12.1\nG1 C9\nG1 X50\nG13.1\nM2\n";
    const auto not_stepped = [&](const Profile& of) {
        std::vector<std::string> told;
        const auto read = read_program(text, {}, &of);
        for (const Problem& problem : read->problems.warnings())
            if (problem.code == ProblemCode::not_stepped)
                told.push_back(std::to_string(problem.line) + " " + std::to_string(problem.times) + " " +
                               what_text(problem));
        return told;
    };
    EXPECT_EQ(not_stepped(profile), std::vector<std::string>{});
    profile.gcode.is_stepwise = true;
    EXPECT_EQ(not_stepped(profile),
              (std::vector<std::string>{"7 600 a line is carved as with \"path\": psi turns",
                                        "10 1 a line is carved as with \"path\": both heads move",
                                        "11 2 an arc stays chords: its radius is below 16 pulses",
                                        "12 2 an arc stays chords: another axis moves with it",
                                        "19 2 a drawn way is carved as with \"path\""}));
    profile.y.pulses_per_mm = 800.0;
    EXPECT_EQ(not_stepped(profile).at(0), "4 4 an arc stays chords: its head and y differ in pulses per mm");
}

TEST(MachineCheck, LetsTheOperatorKeepTheOverrides) {
    EXPECT_EQ(faults_of("M48\nM50\nM50 P1\nM51\nM51 P0\nM52 P0\nM53 P0\nM2\n"), Faults{});
    EXPECT_EQ(faults_of("M49\nM50 P0\nM52\nM53 P1\nM2\n"),
              (Faults{"1:1 override_kept", "2:1 override_kept", "3:1 output_missing", "4:1 output_missing"}));
}

TEST(MachineCheck, KnowsTheTolerancesThatAPathCanHave) {
    EXPECT_EQ(faults_of("G64\nG64 P0\nG64 P10\nG64 P.000001\nM2\n"), Faults{});
    EXPECT_EQ(faults_of("G64 P10.1\nG64 P.0000009\nG20\nG64 P1\nM2\n"),
              (Faults{"1:1 out_of_range", "2:1 out_of_range", "4:1 out_of_range"}));
}

TEST(MachineCheck, SendsTheHeadsHomeByG28) {
    const Profile profile;
    const auto read = read_program("G28\nM2\n", {}, &profile);
    EXPECT_EQ(read->faults(), Faults{});
    EXPECT_EQ(read->records[1].end[0], profile.r1.home_position_mm);
}

}  // namespace
}  // namespace psicarve::gcode
