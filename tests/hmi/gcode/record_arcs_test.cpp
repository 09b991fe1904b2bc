// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps over arcs and helices: their chords from canonical motion, their records from a program.
#include <cmath>
#include <random>
#include <utility>

#include "hmi/gcode/arc_chords.hpp"
#include "shared/base/units.hpp"
#include "tests/hmi/gcode/made_records.hpp"

namespace psicarve::gcode {
namespace {

class Draw {
public:
    explicit Draw(unsigned seed) : random_(seed) {}
    double between(double least, double most) {
        return std::uniform_real_distribution<double>{least, most}(random_);
    }
    /// Evenly by orders of magnitude.
    double magnitude(double least, double most) { return std::exp(between(std::log(least), std::log(most))); }
    int whole(int least, int most) { return std::uniform_int_distribution<int>{least, most}(random_); }

private:
    std::mt19937 random_;
};

/// A true arc with its other axes moving along.
struct TrueArc {
    CanonRecord record;
    double radius_mm = 0.0;
    double start_rad = 0.0;
    double sweep_rad = 0.0;
};

TrueArc drawn_arc(Draw& draw) {
    static constexpr const Plane* kPlanes[] = {&kPlaneXy, &kPlaneZx, &kPlaneYz};
    TrueArc arc;
    CanonRecord& record = arc.record;
    record.kind = CanonKind::arc;
    record.plane = kPlanes[draw.whole(0, 2)];
    arc.radius_mm = draw.magnitude(0.01, 500.0);
    arc.start_rad = draw.between(-kPi, kPi);
    const bool is_whole = draw.whole(0, 4) == 0;
    const int turns = draw.whole(1, 3);
    const double way = draw.whole(0, 1) == 0 ? 1.0 : -1.0;
    const double last_rad = is_whole ? 2.0 * kPi : draw.between(0.01, 2.0 * kPi - 0.01);
    arc.sweep_rad = way * (last_rad + 2.0 * kPi * (turns - 1));
    record.turns = way > 0.0 ? turns : -turns;
    for (std::size_t axis = 0; axis < kLetterCount; ++axis) {
        record.start[axis] = draw.between(-100.0, 100.0);
        record.end[axis] = draw.between(-100.0, 100.0);
    }
    record.centre_first_mm = draw.between(-50.0, 50.0);
    record.centre_second_mm = draw.between(-50.0, 50.0);
    const auto place = [&](Position& at, double angle_rad) {
        at[record.plane->first] = record.centre_first_mm + arc.radius_mm * std::cos(angle_rad);
        at[record.plane->second] = record.centre_second_mm + arc.radius_mm * std::sin(angle_rad);
    };
    place(record.start, arc.start_rad);
    place(record.end, arc.start_rad + arc.sweep_rad);
    if (is_whole) {
        record.end[record.plane->first] = record.start[record.plane->first];
        record.end[record.plane->second] = record.start[record.plane->second];
    }
    return arc;
}

/// Where the true arc is when it has gone this share of its way.
Position true_place(const TrueArc& arc, double share) {
    const CanonRecord& record = arc.record;
    Position at{};
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        at[axis] = record.start[axis] + share * (record.end[axis] - record.start[axis]);
    const double angle_rad = arc.start_rad + share * arc.sweep_rad;
    at[record.plane->first] = record.centre_first_mm + arc.radius_mm * std::cos(angle_rad);
    at[record.plane->second] = record.centre_second_mm + arc.radius_mm * std::sin(angle_rad);
    return at;
}

double apart(const Position& a, const Position& b) {
    double most = 0.0;
    for (std::size_t axis = 0; axis < kLetterCount; ++axis)
        most = std::max(most, std::abs(a[axis] - b[axis]));
    return most;
}

TEST(ArcChords, AreNoFurtherOffTheArcThanTheyMay) {
    constexpr double kRounding = 1e-9;
    Draw draw{1717};
    for (int round = 0; round < 2000; ++round) {
        const TrueArc arc = drawn_arc(draw);
        const double chord_mm = draw.magnitude(1e-5, 0.5);
        const ArcChords sut{arc.record, chord_mm};
        ASSERT_GE(sut.count(), 1U);
        Position from = arc.record.start;
        const auto count = static_cast<double>(sut.count());
        for (std::uint64_t chord = 1; chord <= sut.count(); ++chord) {
            const Position to = sut.end_of(chord);
            ASSERT_LE(apart(to, true_place(arc, static_cast<double>(chord) / count)), kRounding) << round;
            // Halfway a chord is furthest off; the other axes are where they are to be.
            Position middle{};
            for (std::size_t axis = 0; axis < kLetterCount; ++axis)
                middle[axis] = (from[axis] + to[axis]) / 2;
            const Position ideal = true_place(arc, (static_cast<double>(chord) - 0.5) / count);
            const double off_mm =
                std::hypot(middle[arc.record.plane->first] - ideal[arc.record.plane->first],
                           middle[arc.record.plane->second] - ideal[arc.record.plane->second]);
            ASSERT_LE(off_mm, chord_mm + kRounding) << round;
            middle[arc.record.plane->first] = ideal[arc.record.plane->first];
            middle[arc.record.plane->second] = ideal[arc.record.plane->second];
            ASSERT_LE(apart(middle, ideal), kRounding) << round;
            from = to;
        }
        EXPECT_EQ(from, arc.record.end) << round;
    }
}

TEST(ArcChords, AreAsFewAsTheToleranceLets) {
    Draw draw{1718};
    for (int round = 0; round < 500; ++round) {
        const TrueArc arc = drawn_arc(draw);
        const double chord_mm = draw.magnitude(1e-5, 0.01 * arc.radius_mm);
        const ArcChords sut{arc.record, chord_mm};
        if (sut.count() == 1) continue;
        // With one chord fewer they would be too far off.
        const double each_rad = std::abs(arc.sweep_rad) / static_cast<double>(sut.count() - 1);
        EXPECT_GE(arc.radius_mm * (1.0 - std::cos(each_rad / 2.0)), chord_mm * (1.0 - 1e-6)) << round;
    }
}

TEST(ArcChords, KeepEightCornersOfTheSmallestCircle) {
    TrueArc arc;
    arc.record.plane = &kPlaneXy;
    arc.record.turns = 2;
    arc.record.start[0] = arc.record.end[0] = 0.001;
    EXPECT_EQ((ArcChords{arc.record, 10.0}.count()), 16U);
}

TEST(ArcChords, AreCountableForAnyTolerance) {
    TrueArc arc;
    arc.record.plane = &kPlaneXy;
    arc.record.turns = 1000000;
    arc.record.start[0] = arc.record.end[0] = 1e9;
    const std::uint64_t count = ArcChords(arc.record, 1e-300).count();
    EXPECT_GT(count, 1'000'000'000U);
    EXPECT_LT(count, std::uint64_t{1} << 50U);
}

TEST(ArcChords, GoEvenlyFromOneRadiusToTheOther) {
    CanonRecord record;
    record.plane = &kPlaneXy;
    record.turns = -1;
    record.start[0] = 10.0;
    record.end[1] = 10.4;  // clockwise, three quarters of a turn
    const ArcChords sut{record, 0.001};
    for (std::uint64_t chord = 1; chord <= sut.count(); ++chord) {
        const Position at = sut.end_of(chord);
        EXPECT_NEAR(std::hypot(at[0], at[1]),
                    10.0 + 0.4 * static_cast<double>(chord) / static_cast<double>(sut.count()), 1e-9);
    }
    EXPECT_EQ(sut.end_of(sut.count()), record.end);
}

std::string number_text(double value) {
    char text[48];
    std::snprintf(text, sizeof text, "%.9f", value);
    return text;
}

struct MeasuredArc {
    double most_off_mm = 0.0;  ///< of middles of chords, plus what their corners may be cut by
    double seconds = 0.0;
    std::size_t count = 0;
};

MeasuredArc measured(const std::vector<MotionRecord>& chords, double r1_mm, double y_mm, double centre_r1_mm,
                     double centre_y_mm, double radius_mm) {
    MeasuredArc found;
    for (const MotionRecord& chord : chords) {
        const double end_r1_mm = chord.target[index_of(Axis::r1)];
        const double end_y_mm = chord.target[kY];
        const double middle_mm =
            std::hypot((r1_mm + end_r1_mm) / 2 - centre_r1_mm, (y_mm + end_y_mm) / 2 - centre_y_mm);
        const double corner_mm = std::hypot(end_r1_mm - centre_r1_mm, end_y_mm - centre_y_mm);
        const double off_mm = std::max(std::abs(middle_mm - radius_mm), std::abs(corner_mm - radius_mm));
        found.most_off_mm = std::max(found.most_off_mm, off_mm + chord.tolerance_mm);
        found.seconds += chord.seconds;
        ++found.count;
        r1_mm = end_r1_mm;
        y_mm = end_y_mm;
    }
    return found;
}

TEST(RecordsOfArcs, KeepTheToleranceAndTheFeedWhateverTheMode) {
    Draw draw{1719};
    for (int round = 0; round < 400; ++round) {
        const double radius_mm = draw.between(0.05, 25.0);
        const double start_rad = draw.between(-kPi, kPi);
        const bool is_clockwise = draw.whole(0, 1) == 1;
        const int turns = draw.whole(1, 3);
        const double last_rad = draw.between(0.05, 6.2);
        const double sweep_rad = last_rad + 2.0 * kPi * (turns - 1);
        const double end_rad = start_rad + (is_clockwise ? -sweep_rad : sweep_rad);
        const double helix_mm = draw.whole(0, 1) == 0 ? 0.0 : draw.between(-20.0, 20.0);
        const double feed_mm_min = draw.magnitude(1.0, 2000.0);
        const double tolerance_mm = draw.magnitude(0.001, 0.3);
        const int mode = draw.whole(0, 2);
        const bool is_inverse = draw.whole(0, 2) == 0;
        const double centre_r1_mm = 30.0;
        const double centre_y_mm = 70.0;
        const double r1_mm = centre_r1_mm + radius_mm * std::cos(start_rad);
        const double y_mm = centre_y_mm + radius_mm * std::sin(start_rad);
        const double end_r1_mm = centre_r1_mm + radius_mm * std::cos(end_rad);
        const double end_y_mm = centre_y_mm + radius_mm * std::sin(end_rad);
        Profile profile;
        if (mode != 0) profile.job.path_tolerance_mm = tolerance_mm;
        const std::string mode_text =
            mode == 0 ? "G64 P" + number_text(tolerance_mm) : (mode == 1 ? "G64" : "G61");
        const double length_mm = std::hypot(radius_mm * sweep_rad, helix_mm);
        const double f = is_inverse ? feed_mm_min / length_mm : feed_mm_min;
        const std::string text = mode_text + "\nG90.1 G0 Z30 X" + number_text(r1_mm) + " Y" +
                                 number_text(y_mm) + (is_inverse ? "\nG93" : "\nG94") +
                                 (is_clockwise ? " G2" : " G3") + " X" + number_text(end_r1_mm) + " Y" +
                                 number_text(end_y_mm) + " Z" + number_text(30.0 + helix_mm) + " I30 J70 P" +
                                 std::to_string(turns) + " F" + number_text(f) + "\nG0 Y10\nM2\n";
        const MadeRecords made = made_records(text, {}, profile);
        ASSERT_EQ(made.failure, "") << text;
        std::vector<MotionRecord> chords = made.ways();
        ASSERT_GE(chords.size(), 3U) << text;
        chords.erase(chords.begin());
        chords.pop_back();
        if (mode == 2) {
            // The rest behind the arc.
            EXPECT_EQ(chords.back().tolerance_mm, 0.0);
            EXPECT_EQ(chords.back().seconds, 0.0);
            chords.pop_back();
            EXPECT_GT(chords.back().tolerance_mm, 0.0);
        }
        const MeasuredArc found = measured(chords, r1_mm, y_mm, centre_r1_mm, centre_y_mm, radius_mm);
        EXPECT_LE(found.most_off_mm, tolerance_mm + 1e-8) << text;
        const double wanted_s = length_mm / feed_mm_min * 60.0;
        EXPECT_NEAR(found.seconds, wanted_s, 1e-6 * wanted_s + 1e-6 / feed_mm_min) << text;
        for (const MotionRecord& chord : chords) {
            EXPECT_NEAR(chord.seconds, found.seconds / static_cast<double>(found.count), 1e-9 * wanted_s);
            EXPECT_EQ(chord.flags & kIsRapid, 0);
            // The other head goes along evenly.
            const auto number = static_cast<double>(chord.sequence - chords.front().sequence + 1);
            EXPECT_NEAR(chord.target[1], 30.0 + helix_mm * number / static_cast<double>(found.count), 1e-7);
        }
        EXPECT_EQ(chords.back().target[0], std::strtod(number_text(end_r1_mm).c_str(), nullptr)) << text;
        EXPECT_EQ(chords.back().target[kY], std::strtod(number_text(end_y_mm).c_str(), nullptr)) << text;
    }
}

TEST(RecordsOfArcs, TurnAsTheSystemIsTurned) {
    // A quarter from (10, 0) to (0, 10) about the system's zero at (30, 70), turned by 90 degrees.
    const auto ways = made_records("G10 L2 P1 X30 Y70 R90\nG0 X10 Y0\nG3 X0 Y10 I-10 F60\nM2\n").ways();
    ASSERT_GT(ways.size(), 3U);
    EXPECT_NEAR(ways.front().target[0], 30.0, 1e-9);
    EXPECT_NEAR(ways.front().target[kY], 80.0, 1e-9);
    for (const MotionRecord& way : ways) {
        EXPECT_NEAR(std::hypot(way.target[0] - 30.0, way.target[kY] - 70.0), 10.0, 1e-9);
        EXPECT_LE(way.target[0], 30.0 + 1e-9);
    }
    EXPECT_NEAR(ways.back().target[0], 20.0, 1e-9);
    EXPECT_NEAR(ways.back().target[kY], 70.0, 1e-9);
}

TEST(RecordsOfArcs, GoRoundOnceWhereBothEndsLieInOneDirectionHoweverThatIsRounded) {
    // The end is 0.004 mm further out than the begin; offsets leave their directions apart by rounding.
    Draw draw{1720};
    for (int round = 0; round < 200; ++round) {
        const std::string text = "G10 L2 P1 X" + number_text(draw.between(20, 30)) + " Y" +
                                 number_text(draw.between(40, 90)) +
                                 "\nG90.1\nG0 X3 Y4\nG3 X3.0024 Y4.0032 I0 J0 F60\nM2\n";
        double sum_s = 0.0;
        for (const MotionRecord& way : made_records(text).ways()) sum_s += way.seconds;
        EXPECT_NEAR(sum_s, 10.0 * kPi, 0.01) << text;
        EXPECT_GT(made_records(text).ways().size(), 100U) << text;
    }
}

}  // namespace
}  // namespace psicarve::gcode
