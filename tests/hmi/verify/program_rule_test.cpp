// SPDX-License-Identifier: GPL-3.0-or-later
// Programs in G-code, judged by pins that are right, and by pins that are not.
#include <functional>

#include "shared/base/units.hpp"
#include "tests/hmi/verify/program_machine.hpp"

namespace psicarve::verify {
namespace {

constexpr const char* kExact = "G21 G90 G94 G61 F300\nG1 X39 C9\nG1 Z40.5 Y1\nG1 X39.5 Z41\nG1 Y2 C18\nM2\n";

PlacedMachine exact_machine() {
    PlacedMachine machine;
    machine.to({39, 41, 9, 0}).to({39, 40.5, 9, 1}).to({39.5, 41, 9, 1}).to({39.5, 41, 18, 2});
    return machine;
}

TEST(ProgramRule, TakesPinsThatGoFromPlaceToPlace) {
    PlacedMachine machine = exact_machine();
    const auto report = judged(kExact, machine);
    EXPECT_EQ(verdict(report), "ok");
    EXPECT_EQ(report.ways_done, 4U);
    EXPECT_GT(report.run_seconds, 1.0);
    EXPECT_EQ(report.most_off_mm, 0.0);
}

TEST(ProgramRule, MissesALostPulseAndOneTooManyOfAnyAxis) {
    for (const Axis axis : kAllAxes) {
        for (const bool is_lost : {true, false}) {
            PlacedMachine machine;
            machine.to({39, 41, 9, 0}).to({39, 40.5, 9, 1});
            auto& pins = machine.pins();
            // What the machine counts stays as it was: the pins alone have it.
            const auto counted = pins.position;
            pins.pulse(axis, !is_lost);
            pins.position = counted;
            machine.to({39.5, 41, 9, 1}).to({39.5, 41, 18, 2});
            const auto report = judged(kExact, machine);
            EXPECT_FALSE(report.ok);
            // A way may begin with the pulse that is missing.
            const std::string line = axis == Axis::y && is_lost ? "5" : "4";
            EXPECT_EQ(verdict(report), "end-missed " + line) << name_of(axis);
            EXPECT_EQ(report.rules[0].first->axis, axis);
            EXPECT_EQ(report.rules[0].first->measured, 1.0);
        }
    }
}

TEST(ProgramRule, RefusesAnotherOrderOfWays) {
    PlacedMachine machine;
    machine.to({39, 41, 9, 0}).to({39.5, 41, 9, 0}).to({39.5, 40.5, 9, 1}).to({39.5, 41, 18, 2});
    EXPECT_EQ(verdict(judged(kExact, machine)), "off-the-way 3");
}

TEST(ProgramRule, RefusesAWayLeftOutAndOneThatIsNotOfTheProgram) {
    PlacedMachine left_out;
    left_out.to({39, 41, 9, 0}).to({39, 40.5, 9, 1}).to({39.5, 41, 18, 2});
    EXPECT_EQ(verdict(judged(kExact, left_out)), "off-the-way 4");
    PlacedMachine more = exact_machine();
    more.to({39.5, 41, 18, 3});
    EXPECT_EQ(verdict(judged(kExact, more)), "goes-on 5");
    PlacedMachine less;
    less.to({39, 41, 9, 0}).to({39, 40.5, 9, 1});
    EXPECT_EQ(verdict(judged(kExact, less)), "ends-early 3");
    PlacedMachine still;
    EXPECT_EQ(verdict(judged(kExact, still)), "ends-early 2");
}

// A pulse of psi is an eighth as wide there as where the way begins.
TEST(ProgramRule, MeasuresATurnAtTheRadiusWhereTheTipStands) {
    for (const std::int64_t ahead : {2, 3}) {
        PlacedMachine machine;
        machine.to({5.0, 41.0, -20.25 * 35.0 / 36.0, 0.0});
        machine.pins().move(Axis::psi, -ahead).move(Axis::psi, ahead);
        machine.to({4.0, 41.0, -20.25, 0.0});
        const auto report = judged("G21 G90 G94 G64 P0.005 F300\nG1 X4 C-20.25\nM2\n", machine);
        EXPECT_EQ(verdict(report), ahead == 2 ? "ok" : "off-the-way 2");
    }
}

TEST(ProgramRule, TellsOfADrawnWayOnceThatItsFeedWasLowered) {
    const std::string program = "G21 G90 G94 G61 F6000\nG12.1\nG1 C30\nG1 X30\nG13.1\nG1 X41\nM2\n";
    PlacedMachine machine;
    const auto at = [](double x_mm, double c_mm) {
        return ProgramPlace{std::hypot(x_mm, c_mm), 41.0, deg_from_rad(std::atan2(c_mm, x_mm)), 0.0};
    };
    machine.along(200, [&](double share) { return at(40.0, 30.0 * share); });
    machine.along(200, [&](double share) { return at(40.0 - 10.0 * share, 30.0); });
    machine.to({41.0, 41.0, 45.0, 0.0});
    const auto report = judged(program, machine);
    EXPECT_EQ(verdict(report), "ok");
    ASSERT_EQ(report.lowered.size(), 3U);
    EXPECT_EQ(report.lowered_count, 3U);
    std::vector<std::uint64_t> lines;
    double lost_s = 0.0;
    for (const LoweredFeed& feed : report.lowered) {
        EXPECT_EQ(feed.first_line, feed.last_line);
        lines.push_back(feed.first_line);
        lost_s += feed.lost_s();
        if (feed.first_line == 3) {
            EXPECT_NEAR(feed.asked_s, 30.0 / 6000.0 * 60.0, 0.05);
        }
    }
    std::sort(lines.begin(), lines.end());
    EXPECT_EQ(lines, (std::vector<std::uint64_t>{3, 4, 6}));
    EXPECT_NEAR(lost_s, report.lowered_seconds, 1e-9);
}

// Under G61 a way is straight to the pulse, however near to its end.
TEST(ProgramRule, RefusesAnAxisThatGoesBesideTheOthers) {
    PlacedMachine machine;
    machine.to({39, 41, 0.5, 0}).to({39, 41, 9, 0});
    EXPECT_EQ(verdict(judged(kExact, machine)), "off-the-way 2");
}

TEST(ProgramRule, RefusesHeadsThatAreNotAtOnePlaceOfTheirWay) {
    const std::string begin = "G21 G90 G94 F300 G61\nG1 Z40\n";
    const auto verdict_of = [&](const std::string& program, const std::vector<ProgramPlace>& places) {
        PlacedMachine machine;
        machine.to({40, 40, 0, 0});
        for (const ProgramPlace& place : places) machine.to(place);
        return verdict(judged(begin + program + "M2\n", machine));
    };
    EXPECT_EQ(verdict_of("G1 X20 Z20\n", {{20, 20, 0, 0}}), "ok");
    EXPECT_EQ(verdict_of("G1 X20 Z20\n", {{40, 20, 0, 0}, {20, 20, 0, 0}}), "heads-apart 3");
    EXPECT_EQ(verdict_of("G1 X20 Z20\n", {{30, 30, 0, 0}, {29.96, 30, 0, 0}, {20, 20, 0, 0}}),
              "heads-apart 3");
    EXPECT_EQ(verdict_of("G1 X39 Z35\n", {{39, 35, 0, 0}}), "ok");
    EXPECT_EQ(verdict_of("G1 X39 Z35\n", {{39, 40, 0, 0}, {39, 35, 0, 0}}), "heads-apart 3");
    const std::string blended = "G64 P0.1\nG1 X39 Z35\nG1 X38\n";
    EXPECT_EQ(verdict_of(blended, {{39.04, 35.12, 0, 0}, {38.95, 35.02, 0, 0}, {38, 35, 0, 0}}), "ok");
    EXPECT_EQ(verdict_of(blended, {{39.8, 37, 0, 0}, {39, 35, 0, 0}, {38, 35, 0, 0}}), "heads-apart 4");
}

// Where a way that turns comes in from far out, a share of it is long out there.
TEST(ProgramRule, RefusesAPathThatGoesBackWhereATurningWayIsWide) {
    const auto at = [](double share) {
        return ProgramPlace{40 - 36 * share, 41 - 36 * share, -1080 * share, 0};
    };
    for (const double back_pulses : {0.0, 3.0, 20.0}) {
        PlacedMachine machine;
        machine.to(at(0.05)).to(at(0.05 - back_pulses / 19200.0)).to(at(0.05)).to(at(1.0));
        const auto report = judged("G21 G90 G94 G64 P0.005 F300\nG1 X4 Z5 C-1080\nM2\n", machine);
        EXPECT_EQ(verdict(report), back_pulses == 0.0 ? "ok" : "goes-back 2") << back_pulses;
    }
}

TEST(ProgramRule, RefusesAPathThatGoesBack) {
    PlacedMachine machine;
    machine.to({39.5, 41, 4.5, 0}).to({39.8, 41, 1.8, 0}).to({39, 41, 9, 0});
    EXPECT_EQ(verdict(judged(kExact, machine)), "goes-back 2");
}

TEST(ProgramRule, CutsCornersByTheToleranceAndNoFurther) {
    const std::string program = "G21 G90 G94 F300 G64 P0.2\nG1 X39\nG1 Y1\nM2\n";
    // A corner cut so that it is passed at a distance of d has its ends 1.41 d before and behind it.
    const auto cut_by = [&](double mm) {
        PlacedMachine machine;
        const double before = std::sqrt(2.0) * mm;
        machine.to({39 + before, 41, 0, 0}).to({39, 41, 0, before}).to({39, 41, 0, 1});
        return verdict(judged(program, machine));
    };
    EXPECT_EQ(cut_by(0.0), "ok");
    EXPECT_EQ(cut_by(0.19), "ok");
    EXPECT_EQ(cut_by(0.22), "off-the-way 2");
    EXPECT_EQ(cut_by(0.4), "off-the-way 2");
}

// Ways much shorter than the tolerance: a place is on many of them, and none may be left out for good.
TEST(ProgramRule, FollowsWaysThatAreShorterThanTheTolerance) {
    std::string program = "G21 G90 G94 F300 G64 P0.5\n";
    std::vector<ProgramPlace> places;
    for (int n = 1; n <= 60; ++n) {
        const ProgramPlace place{40 - 0.05 * n + (n % 2 == 0 ? 0.04 : 0.0), 41, 0, 0.04 * (n % 7)};
        places.push_back(place);
        program += "X" + std::to_string(place[0]) + " Y" + std::to_string(place[3]) + "\n";
        if (n == 1) program.insert(program.size() - 1, " G1");
    }
    program += "M2\n";
    PlacedMachine all;
    for (const ProgramPlace& place : places) all.to(place);
    EXPECT_EQ(verdict(judged(program, all)), "ok");
    PlacedMachine straight;
    straight.to({places.front()[0], 41, 0, 0.1}).to({places.back()[0] + 0.2, 41, 0, 0.1}).to(places.back());
    EXPECT_EQ(verdict(judged(program, straight)), "ok");
    PlacedMachine aside;
    aside.to({places.front()[0], 41, 0, 0.1}).to({38.5, 41, 0, 0.95}).to(places.back());
    EXPECT_EQ(verdict(judged(program, aside)).substr(0, 11), "off-the-way");
}

// Forth and back over the same line: as often as the program does it, not less.
TEST(ProgramRule, CountsWaysOverTheSameLine) {
    const std::string program = "G21 G90 G94 F300 G64 P0.05\nG1 X39\nX40\nX39\nX40\nX38\nM2\n";
    const auto verdict_of = [&](const std::vector<double>& places) {
        PlacedMachine machine;
        for (const double r1 : places) machine.to({r1, 41, 0, 0});
        return verdict(judged(program, machine));
    };
    EXPECT_EQ(verdict_of({39.0, 40.0, 39.0, 40.0, 38.0}), "ok");
    EXPECT_EQ(verdict_of({39.04, 39.97, 39.03, 39.96, 38.0}), "ok");
    EXPECT_EQ(verdict_of({39.0, 40.0, 38.0}), "off-the-way 5");
    EXPECT_EQ(verdict_of({39.1, 40.0, 39.0, 40.0, 38.0}), "goes-back 2");
}

// The truth is the circle, not the chords that the machine was given.
TEST(ProgramRule, JudgesArcsAsCircles) {
    Profile low;
    low.y.travel_mm[0] = low.y.home_position_mm = -10.0;
    const std::string program = "G21 G90 G94 F300 G64 P0.02\nG17 G3 X40 Y0 I-2 J0\nM2\n";
    const auto circle = [](double radius_mm) {
        return [radius_mm](double share) {
            const double angle_rad = 2.0 * kPi * share;
            return ProgramPlace{38 + radius_mm * std::cos(angle_rad), 41, 0, radius_mm * std::sin(angle_rad)};
        };
    };
    PlacedMachine round;
    round.along(200, circle(2.0));
    EXPECT_EQ(verdict(judged(program, round, low)), "ok");
    // Chords with a sagitta of 2 mm (1 - cos(pi / 16)) = 0.038 mm.
    PlacedMachine rough;
    rough.along(16, circle(2.0));
    EXPECT_EQ(verdict(judged(program, rough, low)), "off-the-way 2");
    PlacedMachine large;
    large.to({40.03, 41, 0, 0}).along(200, circle(2.03)).to({40, 41, 0, 0});
    EXPECT_EQ(verdict(judged(program, large, low)), "off-the-way 2");
    PlacedMachine other_way;
    other_way.along(200, [&](double share) { return circle(2.0)(1.0 - share); });
    EXPECT_EQ(verdict(judged(program, other_way, low)).substr(0, 11), "off-the-way");
}

TEST(ProgramRule, FollowsAHelixTurnByTurn) {
    Profile low;
    low.y.travel_mm[0] = low.y.home_position_mm = -10.0;
    const std::string program = "G21 G90 G94 F300 G64 P0.02\nG17 G2 X40 Y0 I-1 J0 P3 C54\nM2\n";
    const auto turns = [](int count, double degrees) {
        return [count, degrees](double share) {
            const double angle_rad = -2.0 * kPi * count * share;
            return ProgramPlace{39 + std::cos(angle_rad), 41, degrees * share, std::sin(angle_rad)};
        };
    };
    PlacedMachine right;
    right.along(600, turns(3, 54.0));
    EXPECT_EQ(verdict(judged(program, right, low)), "ok");
    PlacedMachine less;
    less.along(600, turns(2, 54.0));
    EXPECT_EQ(verdict(judged(program, less, low)), "off-the-way 2");
}

TEST(ProgramRule, WantsNoWayFasterThanItsFeed) {
    // PerfectMachine takes 2.5 ms a pulse, 400 of them a millimetre: 60 mm/min.
    for (const auto& [feed, expected] : {std::pair{"F61", "ok"}, {"F59", "ok"}, {"F50", "feed 2"}}) {
        PlacedMachine machine;
        machine.to({39, 41, 0, 0});
        const bool is_slower = std::string{feed} == "F59";
        const std::string program = "G21 G90 G94 G61 " + std::string{feed} + "\nG1 X39\nM2\n";
        EXPECT_EQ(verdict(judged(program, machine, {}, is_slower ? 1.1 : 1.0)), expected) << feed;
    }
}

// Ways within one tolerance, whose ends nobody can time: together they take as long as they ask for.
TEST(ProgramRule, TimesShortWaysTogether) {
    for (const auto& [feed, expected] : {std::pair{"F62", "ok"}, {"F45", "feed"}}) {
        std::string program = "G21 G90 G94 G64 P0.05 " + std::string{feed} + "\nG1 X39.99\n";
        for (int n = 2; n <= 300; ++n) program += "X" + std::to_string(40.0 - 0.01 * n) + "\n";
        PlacedMachine machine;
        machine.to({37, 41, 0, 0});
        EXPECT_EQ(verdict(judged(program + "M2\n", machine)).substr(0, 4), expected) << feed;
    }
}

TEST(ProgramRule, TellsWhereFeedsWereLowered) {
    // The pins go 60 mm a minute.
    PlacedMachine machine;
    machine.to({39, 41, 0, 0}).to({38, 41, 0, 0}).to({36, 41, 0, 0});
    const auto report = judged("G21 G90 G94 G61 F61\nG1 X39\nG1 X38 F600\nG1 X36 F300\nM2\n", machine);
    EXPECT_EQ(verdict(report), "ok");
    ASSERT_EQ(report.lowered.size(), 2U);
    EXPECT_EQ(report.lowered[0].first_line, 4U);  // costs more time
    EXPECT_NEAR(report.lowered[0].share(), 0.8, 0.01);
    EXPECT_EQ(report.lowered[1].last_line, 3U);
    EXPECT_NEAR(report.lowered[1].share(), 0.9, 0.01);
    EXPECT_NEAR(report.lowered_seconds, 2.5, 0.05);
    EXPECT_EQ(report.bounds.least_pulses[0], 36 * 400);
}

TEST(ProgramRule, WantsTheRestsAndTheSpindle) {
    const std::string program = "G21 G90 G94 F300\nM3\nG1 X39\nG4 P0.5\nG1 X38\nM5\nG1 X39\nM2\n";
    const auto verdict_of = [&](double rest_s, bool is_on) {
        PlacedMachine machine;
        machine.spindle(is_on).to({39, 41, 0, 0}).rest(rest_s).to({38, 41, 0, 0}).spindle(false);
        machine.to({39, 41, 0, 0});
        return verdict(judged(program, machine));
    };
    EXPECT_EQ(verdict_of(0.6, true), "ok");
    EXPECT_EQ(verdict_of(0.3, true), "dwell 3");
    EXPECT_EQ(verdict_of(0.6, false), "spindle 3");
}

TEST(ProgramRule, SaysOfNoFeedThatItWasLoweredToAStandstill) {
    const std::vector<LoweredFeed> lowered = {
        {.first_line = 5, .last_line = 5, .asked_s = 0.01, .taken_s = 4.0},
        {.first_line = 6, .last_line = 8, .asked_s = 1.0, .taken_s = 100.0},
        {.first_line = 9, .last_line = 9, .asked_s = 1.0, .taken_s = 2.0}};
    EXPECT_EQ(lowered_text(lowered, 3), "line 5 by over 99 %, lines 6 to 8 by 99 %, line 9 by 50 %");
}

TEST(ProgramRule, BeginsWhereHomingHasLastDefinedThePositions) {
    PlacedMachine machine;
    machine.to({45, 41, 0, 0}).pins().define_positions({16'000, 41 * 400, 0, 0});
    machine.to({39, 41, 9, 0}).to({39, 40.5, 9, 1}).to({39.5, 41, 9, 1}).to({39.5, 41, 18, 2});
    EXPECT_EQ(verdict(judged(kExact, machine)), "ok");
}

TEST(ProgramRule, JudgesTheOtherRulesAsForAJob) {
    PlacedMachine disabled = exact_machine();
    for (TraceEvent& event : disabled.pins().events) event.levels &= ~bit_of(enable_of(Axis::y));
    EXPECT_EQ(verdict(judged(kExact, disabled)), "disabled 3");
    Profile weak;
    weak.port.dir_setup_ns = 150'000;
    PlacedMachine hasty = exact_machine();
    EXPECT_EQ(judged(kExact, hasty, weak).rules[1].first->fault, "direction-setup");
}

TEST(ProgramRule, SaysWhatIsWrongWithItsProgram) {
    PlacedMachine machine = exact_machine();
    const auto report = judged("G21 G90 G94 F300\nG1 X39 C9\nG1 X[1/0]\nM2\n", machine);
    EXPECT_FALSE(report.ok);
    ASSERT_TRUE(report.failure);
    EXPECT_NE(report.failure->message.find("line 3"), std::string::npos) << report.failure->message;
}

TEST(ProgramRule, ReadsItsProgramFromWhereTheMachineStands) {
    PlacedMachine machine = exact_machine();
    const std::string program = "#1=[1/#5420]\n" + std::string{kExact};
    EXPECT_EQ(verdict(judged(program, machine)), "ok");
    // Also what it is wrong in behind the trace's end.
    PlacedMachine less;
    less.to({39, 41, 9, 0});
    EXPECT_NE(verdict(judged("G21 G90 G94 G61 F300\nG1 X39 C9\nG1 Y5\nG1 X99\nM2\n", less)).find("line 4"),
              std::string::npos);
}

// A turn by the shortest way is one for rapids, and for later places.
TEST(ProgramRule, CountsPsiAsTheProfileAsks) {
    Profile profile;
    profile.gcode.turns_shortest = true;
    const std::string program = "G21 G90 G94 F3000 G61\nG0 C10\nG0 C350\nG1 C340\nM2\n";
    PlacedMachine machine;
    machine.to({40, 41, 10, 0}).to({40, 41, -10, 0}).to({40, 41, -20, 0});
    EXPECT_EQ(verdict(judged(program, machine, profile)), "ok");
    EXPECT_NE(verdict(judged(program, machine)), "ok");
}

}  // namespace
}  // namespace psicarve::verify
