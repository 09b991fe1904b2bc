// SPDX-License-Identifier: GPL-3.0-or-later
// Records of programs whose lines and arcs run by point-by-point comparison.
#include <cmath>
#include <random>

#include "shared/base/units.hpp"
#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

Profile stepwise_profile() {
    Profile profile;
    profile.gcode.is_stepwise = true;
    return profile;
}

MadeRecords stepwise_records(const std::string& text, const RunOptions& how = {}) {
    MadeRecords made = made_records("G0 X50 Z50 Y40 C0\nF600\n" + text + "M2\n", how, stepwise_profile());
    EXPECT_EQ(made.faults, Faults{}) << text;
    EXPECT_EQ(made.failure, "") << text;
    return made;
}

std::vector<MotionRecord> of_line(const MadeRecords& made, std::uint64_t line) {
    std::vector<MotionRecord> found;
    for (const MotionRecord& record : made.records)
        if (record.line == line) found.push_back(record);
    return found;
}

TEST(SteppedRecords, AreFeedsOfAHeadOrYOrBoth) {
    const auto made = stepwise_records("G1 X49\nG1 Y41 Z48\nG1 Y42\nG1 X48 Z47\nG1 Y43 C5\nG0 Y44\n");
    const auto flags = [&](std::uint64_t line) { return of_line(made, line).front().flags & kIsStepped; };
    for (const std::uint64_t line : {3U, 4U, 5U}) {
        const MotionRecord way = of_line(made, line).front();
        EXPECT_NE(flags(line), 0) << line;
        EXPECT_EQ(way.tolerance_mm, 0.0);
    }
    EXPECT_EQ(of_line(made, 3).front().axes, 0b0001);
    EXPECT_EQ(of_line(made, 4).front().axes, 0b1010);
    EXPECT_EQ(of_line(made, 5).front().axes, 0b1000);
    EXPECT_NEAR(of_line(made, 5).front().seconds, 0.1, 1e-9);
    for (const std::uint64_t line : {6U, 7U, 8U}) EXPECT_EQ(flags(line), 0) << line;
}

TEST(SteppedRecords, OfAnArcAreOneForEachTurn) {
    const auto made = stepwise_records("G17 G3 X45 Y45 I-5 J0\nG2 J5 P3\nG3 X40 Y50 J5 P2\n");
    const auto quarter = of_line(made, 3);
    ASSERT_EQ(quarter.size(), 1U);
    EXPECT_EQ(quarter[0].kind, MotionKind::arc);
    EXPECT_EQ(quarter[0].axes, 0b1001);
    EXPECT_EQ(quarter[0].code, static_cast<std::uint8_t>(ArcSense::counterclockwise));
    EXPECT_EQ(quarter[0].centre_mm, (std::array<double, 2>{45.0, 40.0}));
    EXPECT_NEAR(quarter[0].seconds, 2.5 * kPi / 10.0, 1e-9);
    const auto circles = of_line(made, 4);
    ASSERT_EQ(circles.size(), 3U);
    for (const MotionRecord& circle : circles) {
        EXPECT_EQ(circle.code, static_cast<std::uint8_t>(ArcSense::clockwise));
        EXPECT_EQ(circle.target[0], 45.0);
        EXPECT_NEAR(circle.seconds, kPi, 1e-9);
    }
    EXPECT_NE(circles[2].flags & kEndsBlock, 0);
    EXPECT_EQ(circles[1].flags & kEndsBlock, 0);
    const auto more = of_line(made, 5);
    ASSERT_EQ(more.size(), 2U);
    EXPECT_EQ(more[0].target[0], 45.0);
    EXPECT_EQ(more[1].target[0], 40.0);
}

TEST(SteppedRecords, LeaveChordsWhereAnArcIsMoreThanOneHeadsAndYs) {
    const auto made = stepwise_records(
        "G17 G3 X45 Y45 I-5 J0 Z49\nG3 X40 Y40 J-5 C20\nG2 X40.01 Y40.01 I.01 J0\n"
        "G7.1 C38\nG1 Y42\nG7.1 C0\n");
    for (const MotionRecord& record : made.records) {
        EXPECT_NE(record.kind, MotionKind::arc) << record.line;
        EXPECT_EQ(record.flags & kIsStepped, 0) << record.line;
    }
}

TEST(SteppedRecords, OfADryRunMoveYAlone) {
    RunOptions how;
    how.is_dry = true;
    const auto made = stepwise_records("G1 X45 Y45\nG3 X40 Y50 I-5\n", how);
    EXPECT_EQ(of_line(made, 3).front().axes, 0b1000);
    EXPECT_NE(of_line(made, 3).front().flags & kIsStepped, 0);
    for (const MotionRecord& record : of_line(made, 4)) EXPECT_NE(record.kind, MotionKind::arc);
}

// What the core asks of an arc: its ends, in pulses, as far from the centre as each other.
TEST(SteppedRecords, OfAnyArcHaveEndsAlikeFarFromACentreNearItsOwn) {
    std::mt19937 random{20261128};
    const auto between = [&](double least, double most) {
        return std::uniform_real_distribution<double>{least, most}(random);
    };
    const Profile profile = stepwise_profile();
    const SteppedWays sut{profile};
    const double scale = profile.y.pulses_per_mm;
    ASSERT_EQ(scale, profile.r1.pulses_per_mm);
    int stepped = 0;
    for (int round = 0; round < 5'000; ++round) {
        CanonRecord record;
        record.kind = CanonKind::arc;
        record.plane = &kPlaneXy;
        record.placed = record.start_placed = kAllLetters;
        record.centre_first_mm = between(25.0, 35.0);
        record.centre_second_mm = between(40.0, 60.0);
        const double radius_mm = between(0.5, 20.0);
        const double begin_rad = between(-kPi, kPi);
        const double end_rad = between(-kPi, kPi);
        record.start[0] = record.centre_first_mm + radius_mm * std::cos(begin_rad);
        record.start[1] = record.centre_second_mm + radius_mm * std::sin(begin_rad);
        record.end[0] = record.centre_first_mm + radius_mm * std::cos(end_rad);
        record.end[1] = record.centre_second_mm + radius_mm * std::sin(end_rad);
        record.turns = random() % 2 == 0 ? 1 : -1;
        const auto arc = sut.arc(record);
        if (!arc) continue;
        ++stepped;
        const auto from_centre = [&](const Position& at) {
            return std::hypot(static_cast<double>(round_to_pulse(at[0] * scale)) - arc->centre_mm[0] * scale,
                              static_cast<double>(round_to_pulse(at[1] * scale)) - arc->centre_mm[1] * scale);
        };
        EXPECT_LE(std::abs(from_centre(record.start) - from_centre(record.end)), 1.0) << round;
        EXPECT_LE(std::abs(arc->centre_mm[0] - record.centre_first_mm) * scale, 1.5 + 1e-9) << round;
        EXPECT_EQ(arc->is_counterclockwise, record.turns > 0);
    }
    EXPECT_GT(stepped, 4'500);
}

}  // namespace
}  // namespace psicarve::gcode
