// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs of the size of the tolerance, or of a pulse: where a place belongs on them no angle tells.
#include "shared/base/units.hpp"
#include "tests/hmi/verify/program_machine.hpp"

namespace psicarve::verify {
namespace {

Profile coarse_profile() {
    Profile profile;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->pulses_per_mm = 50.0;
        axis->start_stop_mm_s = axis->speed_mm_s;
    }
    return profile;
}

/// Round a centre to the left of where the machine stands, from there on.
struct Circles {
    double radius_mm;
    double turns = 1.0;
    double turned_deg = 0.0;

    ProgramPlace operator()(double share) const {
        const double angle_rad = 2.0 * kPi * turns * share;
        return {40 - radius_mm + radius_mm * std::cos(angle_rad), 41, turned_deg * share,
                10 + radius_mm * std::sin(angle_rad)};
    }
};

/// Pins go a millimetre a second, so that F61 is right.
std::string begin_of(const std::string& more) {
    return "G21 G90 G94 F61 " + more + "\nG1 Y10\n";
}
PlacedMachine at_begin(const Profile& profile = {}) {
    PlacedMachine machine{profile};
    machine.pins().start.position_pulses[1] = machine.pins().position[1];
    machine.to({40, 41, 0, 10});
    return machine;
}
std::string circle(double radius_mm, const std::string& more = {}) {
    return "G17 G3 I" + std::to_string(-radius_mm) + " " + more + "\n";
}

TEST(ProgramArcs, MayBeAsSmallAsTheTolerance) {
    for (const double radius_mm : {0.001, 0.002, 0.004, 0.008, 0.012, 0.016, 0.02, 0.03}) {
        PlacedMachine machine = at_begin();
        for (int n = 0; n < 3; ++n) machine.along(8, Circles{radius_mm});
        machine.to({39, 41, 0, 10});
        const std::string text = circle(radius_mm, "F300") + circle(radius_mm) + circle(radius_mm);
        EXPECT_EQ(verdict(judged(begin_of("G64 P.01") + text + "G1 X39 F61\nM2\n", machine)), "ok")
            << radius_mm;
    }
}

// The path is off the chords of a circle that is not gone round, and that of one gone round the wrong way.
TEST(ProgramArcs, AreGoneRoundAsTheProgramSays) {
    const std::string text = begin_of("G64 P.01") + circle(0.05, "F300") + "G1 X39 F61\nM2\n";
    PlacedMachine none = at_begin();
    none.to({39, 41, 0, 10});
    EXPECT_EQ(verdict(judged(text, none)).substr(0, 11), "off-the-way");
    PlacedMachine back = at_begin();
    back.along(16, Circles{0.05, -1.0}).to({39, 41, 0, 10});
    EXPECT_EQ(verdict(judged(text, back)).substr(0, 11), "off-the-way");
    PlacedMachine twice = at_begin();
    twice.along(32, Circles{0.05, 2.0}).to({39, 41, 0, 10});
    EXPECT_EQ(verdict(judged(text, twice)).substr(0, 11), "off-the-way");
    PlacedMachine once = at_begin();
    once.along(16, Circles{0.05}).to({39, 41, 0, 10});
    EXPECT_EQ(verdict(judged(text, once)), "ok");
}

TEST(ProgramArcs, MayBeManyInARow) {
    const Profile profile = coarse_profile();
    std::string text = "G21 G90 G94 F900 G64 P.01\nG1 Y10\n";
    PlacedMachine machine = at_begin(profile);
    for (int n = 0; n < 58; ++n) {
        text += circle(0.03);
        machine.along(8, Circles{0.03});
    }
    EXPECT_EQ(verdict(judged(text + "M2\n", machine, profile)), "ok");
}

TEST(ProgramArcs, OfManyTurnsAreGoneRoundAsOften) {
    const std::string text = begin_of("G64 P.01") + circle(0.05, "P300 F300") + "G1 X39 F61\nM2\n";
    for (const auto& [turns, expected] : {std::pair{300, "ok"}, {298, "off-the-way"}}) {
        PlacedMachine machine = at_begin();
        machine.along(16 * turns, Circles{0.05, static_cast<double>(turns)}).to({39, 41, 0, 10});
        // Less turns end early, or go on along the next way: both are seen.
        EXPECT_EQ(verdict(judged(text, machine)).substr(0, 11), expected) << turns;
    }
}

// A helix whose table turns further than its radius: its share is that of its length.
TEST(ProgramArcs, MayTurnTheTableFurtherThanTheyAreLarge) {
    const std::string text = begin_of("G64 P.05") + circle(0.1, "C90 F1500") + "G1 X39.5 C90 F61\nM2\n";
    PlacedMachine right = at_begin();
    right.along(400, Circles{0.1, 1.0, 90.0}).to({39.5, 41, 90, 10});
    EXPECT_EQ(verdict(judged(text, right)), "ok");
    PlacedMachine apart = at_begin();
    apart.along(100, Circles{0.1}).to({40, 41, 90, 10}).to({39.5, 41, 90, 10});
    EXPECT_EQ(verdict(judged(text, apart)).substr(0, 11), "off-the-way");
}

TEST(ProgramArcs, WithoutAPulseAreNoWays) {
    Profile stepwise;
    stepwise.gcode.is_stepwise = true;
    for (const Profile& profile : {Profile{}, stepwise}) {
        PlacedMachine machine = at_begin(profile);
        machine.to({39, 41, 0, 10});
        const std::string text = circle(0.0004, "F300") + "G1 X39 F61\n" + circle(0.0004, "F300") + "M2\n";
        const auto report = judged(begin_of("G64 P.01") + text, machine, profile);
        EXPECT_EQ(verdict(report), "ok") << profile.gcode.is_stepwise;
        EXPECT_EQ(report.ways_done, 2U);
    }
}

// What the machine rests for behind an arc is no time of the arc.
TEST(ProgramArcs, AreNotSlowedByTheRestBehindThem) {
    for (const std::string rest : {"M3", "M0", "G4 P2", "M6"}) {
        for (const auto& [feed, expected] : {std::pair{"F61", "ok"}, {"F5", "feed 3"}, {"F0.6", "feed 3"}}) {
            PlacedMachine machine = at_begin();
            machine.along(8, Circles{0.012});
            if (rest == "M3") machine.rest(0.01).spindle(true);
            machine.rest(2.0).to({39, 41, 0, 10}).spindle(false);
            const std::string text = circle(0.012, feed) + rest + "\nG1 X39 F61\nM2\n";
            EXPECT_EQ(verdict(judged(begin_of("G64 P.01") + text, machine)), expected) << rest << feed;
        }
    }
    // Nor is the trace's end.
    PlacedMachine machine = at_begin();
    machine.along(8, Circles{0.012}).rest(2.0).spindle(true).spindle(false);
    EXPECT_EQ(verdict(judged(begin_of("G64 P.01") + circle(0.012, "F0.6") + "M2\n", machine)), "feed 3");
}

// No pulse is due for a circle that the tolerance holds as a whole: its time may pass at rest.
TEST(ProgramArcs, ThatNeedNoPulseMayTakeTheirTimeAtRest) {
    const std::string text = begin_of("G64 P.05") + circle(0.012, "F5") + "M3\nG1 X39 F61\nM2\n";
    for (const auto& [seconds, expected] : {std::pair{0.95, "ok"}, {0.1, "feed"}}) {
        PlacedMachine machine = at_begin();
        machine.rest(seconds).spindle(true).rest(1.5).to({39, 41, 0, 10}).spindle(false);
        const auto report = judged(text, machine);
        EXPECT_EQ(verdict(report).substr(0, 4), expected) << seconds << ": " << program_report_text(report);
    }
}

// A place that a rest behind it is asked for is no rest before: a path that stays there is on its circle.
TEST(ProgramArcs, MayStayWhereALaterWayRests) {
    for (const std::string rest : {"M2", "G4 P.5\nG1 X39\nM2", "M3\nG1 X39\nM2"}) {
        for (const auto& [seconds, expected] : {std::pair{1.3, "ok"}, {0.1, "feed 3"}}) {
            const Profile profile = coarse_profile();
            PlacedMachine machine = at_begin(profile);
            const auto turns = [&](int count) { machine.along(8 * count, Circles{0.02, 1.0 * count}); };
            turns(4);
            machine.to({39.98, 41, 0, 10.02}).rest(seconds).to({40, 41, 0, 10});
            turns(4);
            machine.to({39.98, 41, 0, 10.02});
            if (rest[0] == 'M' && rest[1] == '3') machine.rest(0.1).spindle(true);
            machine.rest(0.6);
            if (rest != "M2") machine.to({39, 41, 0, 10.02});
            machine.spindle(false);
            const std::string text = circle(0.02, "P9 F60") + "G1 X39.98 Y10.02 F900\n" + rest + "\n";
            EXPECT_EQ(verdict(judged("G21 G90 G94 F900 G64 P.05\nG1 Y10\n" + text, machine, profile)),
                      expected)
                << rest;
        }
    }
}

// A way back over the end of the one before passes its own end before it has begun.
TEST(ProgramArcs, AndLinesMayPassTheirEndBeforeTheyRestThere) {
    for (const auto& [seconds, expected] : {std::pair{0.6, "ok"}, {0.3, "dwell 4"}}) {
        PlacedMachine machine = at_begin();
        machine.to({40, 41, 0, 10.03}).to({40, 41, 0, 10.02}).rest(seconds).to({39, 41, 0, 10.02});
        const std::string text = "G1 Y10.03\nG1 Y10.02\nG4 P.5\nG1 X39\nM2\n";
        EXPECT_EQ(verdict(judged(begin_of("G64 P.05") + text, machine)), expected);
    }
}

TEST(ProgramArcs, TellHowFarAPathGoesBack) {
    PlacedMachine on_arc = at_begin();
    on_arc.to(Circles{2.0}(0.0));
    for (int n = 1; n <= 40; ++n) on_arc.to(Circles{2.0}(n * 0.005));
    for (int n = 39; n >= 20; --n) on_arc.to(Circles{2.0}(n * 0.005));
    const auto arc = judged(begin_of("G64 P.02") + circle(2.0) + "M2\n", on_arc);
    EXPECT_EQ(verdict(arc), "goes-back 3");
    EXPECT_GT(arc.rules[0].first->measured, arc.rules[0].first->allowed);
    PlacedMachine on_line = at_begin();
    on_line.to({39.5, 41, 0, 10}).to({39.8, 41, 0, 10});
    const auto line = judged(begin_of("G64 P.02") + "G1 X39\nM2\n", on_line);
    EXPECT_EQ(verdict(line), "goes-back 3");
    EXPECT_GT(line.rules[0].first->measured, line.rules[0].first->allowed);
    EXPECT_LT(line.rules[0].first->measured, 0.3);
}

}  // namespace
}  // namespace psicarve::verify
