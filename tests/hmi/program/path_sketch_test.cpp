// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/path_sketch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "shared/profile/profile.hpp"

namespace psicarve::program {
namespace {

using gcode::CanonKind;
using gcode::CanonRecord;

class Sketched : public ::testing::Test {
protected:
    /// Letters of a profile that has them as the machine does: X, Z heads, Y, C.
    PathSketch sut{gcode::AxisLetters{Profile{}.gcode}};
    gcode::Position at_{};
    std::uint64_t line_ = 0;

    CanonRecord move(CanonKind kind, double x, double y, double c) {
        CanonRecord record;
        record.kind = kind;
        record.line = ++line_;
        record.start = at_;
        record.start_placed = gcode::kAllLetters;
        record.placed = gcode::kAllLetters;
        at_[0] = x;
        at_[1] = y;
        at_[5] = c;
        record.end = at_;
        return record;
    }
    const SketchPoint& last() { return sut.points().back(); }
};

double gap_mm(const SketchPoint& a, const SketchPoint& b) {
    double most = 0.0;
    for (const Axis axis : kAllAxes) {
        const double along = std::abs(a.place[index_of(axis)] - b.place[index_of(axis)]);
        most = std::max(most, axis == Axis::psi ? 0.5 * along : along);
    }
    return most;
}

TEST_F(Sketched, KeepsAShortProgramAsItIs) {
    sut.take(move(CanonKind::rapid, 20.0, 0.0, 0.0));
    sut.take(move(CanonKind::feed, 10.0, 0.0, 90.0));
    sut.take(move(CanonKind::feed, 10.0, 30.0, 720.0));
    ASSERT_EQ(sut.points().size(), 4U);
    EXPECT_TRUE(sut.points()[1].is_rapid);
    EXPECT_FALSE(sut.points()[2].is_rapid);
    EXPECT_EQ(sut.points()[1].place[index_of(Axis::r1)], 20.0);
    EXPECT_EQ(last().place[index_of(Axis::psi)], 720.0);
    EXPECT_EQ(last().place[index_of(Axis::y)], 30.0);
    EXPECT_EQ(sut.tolerance_mm(), 0.0);
    EXPECT_EQ(piece_of_line(sut.points(), 2), 2U);
    EXPECT_EQ(piece_of_line(sut.points(), 4), 0U);
}

TEST_F(Sketched, StaysWithinItsBoundAndItsToleranceHoweverLongTheProgramIs) {
    std::mt19937 random{11};
    std::uniform_real_distribution<double> step{-0.2, 0.2};
    std::vector<SketchPoint> all;
    for (int i = 0; i < 400'000; ++i) {
        const CanonRecord record = move(i % 50 == 0 ? CanonKind::rapid : CanonKind::feed,
                                        at_[0] + step(random), at_[1] + step(random), at_[5] + step(random));
        sut.take(record);
        ASSERT_LE(sut.points().size(), PathSketch::kMostPoints);
        if (i % 1000 == 0) {
            SketchPoint seen;
            seen.place[index_of(Axis::r1)] = at_[0];
            seen.place[index_of(Axis::y)] = at_[1];
            seen.place[index_of(Axis::psi)] = at_[5];
            seen.place[index_of(Axis::r2)] = 0.0;
            seen.first_line = line_;
            all.push_back(seen);
        }
    }
    EXPECT_GE(sut.points().size(), PathSketch::kMostPoints / 8) << "what there is room for is kept";
    EXPECT_EQ(last().place[index_of(Axis::r1)], at_[0]) << "the end is exact";
    EXPECT_EQ(last().last_line, line_);
    for (const SketchPoint& seen : all) {
        double nearest = 1e9;
        for (const SketchPoint& kept : sut.points()) nearest = std::min(nearest, gap_mm(seen, kept));
        EXPECT_LE(nearest, 2.0 * sut.tolerance_mm());
        EXPECT_NE(piece_of_line(sut.points(), seen.first_line), 0U) << "line " << seen.first_line;
    }
}

TEST_F(Sketched, DrawsWhatIsCutAlthoughItIsTooShortToBeKept) {
    sut.take(move(CanonKind::rapid, 50.0, 0.0, 0.0));
    sut.take(move(CanonKind::feed, 50.0, 0.0, 0.0));  // on the spot
    sut.take(move(CanonKind::rapid, 50.0, 60.0, 0.0));
    EXPECT_TRUE(last().is_rapid);
    EXPECT_EQ(last().place[index_of(Axis::y)], 60.0);
}

TEST_F(Sketched, DrawsAnArcThroughItsPointsAndAnEndlessOneInAFewThousand) {
    sut.take(move(CanonKind::rapid, 30.0, 0.0, 0.0));
    CanonRecord arc = move(CanonKind::arc, 30.0, 20.0, 0.0);
    arc.plane = &gcode::kPlaneXy;
    arc.centre_first_mm = 30.0;
    arc.centre_second_mm = 10.0;
    arc.turns = 1;
    sut.take(arc);
    double most = 0.0;
    for (const SketchPoint& point : sut.points()) most = std::max(most, point.place[index_of(Axis::r1)]);
    EXPECT_NEAR(most, 40.0, 0.1);
    const std::size_t before = sut.points().size();
    CanonRecord helix = move(CanonKind::arc, 30.0, 20.0, 900.0);
    helix.plane = &gcode::kPlaneXy;
    helix.centre_first_mm = 30.0;
    helix.centre_second_mm = 10.0;
    helix.turns = 1'000'000;
    sut.take(helix);
    EXPECT_LE(sut.points().size(), before + 8192);
}

TEST_F(Sketched, DrawsNoWayToWhereItBeginsAnewBehindAWrongBlock) {
    sut.take(move(CanonKind::rapid, 20.0, 0.0, 0.0));
    at_[1] = 9.0;
    sut.take(move(CanonKind::feed, 25.0, 9.0, 0.0));
    ASSERT_EQ(sut.points().size(), 4U);
    EXPECT_EQ(sut.points()[2].place[index_of(Axis::y)], 9.0);
    EXPECT_EQ(sut.points()[2].placed, 0U);
    EXPECT_EQ(last().placed, 0xFU);
}

TEST_F(Sketched, KnowsWhichPlacesTheProgramHasSet) {
    CanonRecord record = move(CanonKind::rapid, 5.0, 0.0, 0.0);
    record.placed = gcode::mask_of(0);
    record.start_placed = 0;
    sut.take(record);
    EXPECT_EQ(last().placed, 0U) << "where it comes from nobody knows";
    record = move(CanonKind::feed, 6.0, 0.0, 0.0);
    record.placed = gcode::mask_of(0);
    record.start_placed = gcode::mask_of(0);
    sut.take(record);
    EXPECT_EQ(last().placed, 1U << index_of(Axis::r1));
}

}  // namespace
}  // namespace psicarve::program
