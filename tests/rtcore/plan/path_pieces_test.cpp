// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/path_pieces.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "shared/profile/profile.hpp"

namespace psicarve::plan {
namespace {

/// One span of 200 pulses of psi, made of two straight cells of 100 each; in between R1 is `off_pulses` from
/// the chord. What it is cut into, for the speeds (du/dt)^2 at its begin, its middle and its end.
std::vector<PathPiece> pieces_of(double tolerance_mm, double off_pulses, const Timings& begin2,
                                 const Timings& middle2, const Timings& end2) {
    Profile profile;
    profile.job.path_tolerance_mm = tolerance_mm;
    const MachineLimits limits = machine_limits(profile);
    const std::vector<PathPoint> points{{{6000, 6000, 0, 0}, 0, 0, false},
                                        {{6000, 6000, 200, 0}, 0, 1, false}};
    PathCell out{};
    out.length = 1.0;
    out.slope_begin[0] = out.slope_end[0] = off_pulses;
    out.slope_begin[kPsi] = out.slope_end[kPsi] = 100.0;
    PathCell back = out;
    back.slope_begin[0] = back.slope_end[0] = -off_pulses;
    const Lanes begin{6000.0, 6000.0, 0.0, 0.0};
    const Lanes middle{6000.0 + off_pulses, 6000.0, 100.0, 0.0};
    std::vector<PathPiece> pieces;
    PieceMaker sut(limits, points, 0, begin, pieces);
    sut.begin_cell(out, begin, begin2, middle2);
    sut.add(0.0, 1.0, PathPiece::kNoPoint);
    sut.begin_cell(back, middle, middle2, end2);
    sut.add(0.0, 1.0, 1);
    return pieces;
}

constexpr Timings kEven{1.0, 1.0};

TEST(PieceMaker, AWayWithinAQuarterOfAPulseOfItsChordIsOneSegment) {
    EXPECT_EQ(pieces_of(0.01, 0.2, kEven, kEven, kEven).size(), 1U);
    EXPECT_EQ(pieces_of(0.01, 0.3, kEven, kEven, kEven).size(), 2U);
}

// The chord's pulses are up to half a pulse from the curve by themselves.
TEST(PieceMaker, AWayCutOnItsChordIsKeptWithinATenthOfAPulse) {
    EXPECT_EQ(pieces_of(1e-4, 0.08, kEven, kEven, kEven).size(), 1U);
    EXPECT_EQ(pieces_of(1e-4, 0.2, kEven, kEven, kEven).size(), 2U);
}

TEST(PieceMaker, ASegmentTakesNoLessTimeThanTheCurveAtTwiceTheFeed) {
    // At 100 % the speed is even. At 200 % it dips in the middle: an eighth of a per cent of the time there.
    const std::vector<PathPiece> slowed = pieces_of(0.01, 0.0, {1.0, 4.0}, {1.0, 3.98}, {1.0, 4.0});
    EXPECT_EQ(slowed.size(), 2U);
    const std::vector<PathPiece> even = pieces_of(0.01, 0.0, {1.0, 4.0}, {1.0, 4.0}, {1.0, 4.0});
    EXPECT_EQ(even.size(), 1U);
}

TEST(PieceMaker, PassesThePointAndKeepsTheTime) {
    for (const double off_pulses : {0.0, 0.3}) {
        const std::vector<PathPiece> pieces = pieces_of(0.01, off_pulses, kEven, kEven, kEven);
        Pulses4 sum{};
        double length = 0.0;
        for (const PathPiece& piece : pieces) {
            for (std::size_t k = 0; k < kAxisCount; ++k) sum[k] += piece.delta_pulses[k];
            length += piece.length;
        }
        EXPECT_EQ(sum, (Pulses4{0, 0, 200, 0}));
        EXPECT_DOUBLE_EQ(length, 2.0);
        EXPECT_EQ(pieces.back().point, 1U);
    }
}

}  // namespace
}  // namespace psicarve::plan
