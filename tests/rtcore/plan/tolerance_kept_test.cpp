// SPDX-License-Identifier: GPL-3.0-or-later
// Paths that are hard to find a curve for: none is carved outside its tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "rtcore/cycle/dual_head_dda.hpp"
#include "rtcore/plan/path_stretch.hpp"
#include "tests/rtcore/plan/corner_rig.hpp"
#include "tests/rtcore/plan/hard_paths.hpp"
#include "tests/rtcore/plan/table_blocks.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::plan {
namespace {

using test::carved;
using test::CarvedProgram;
using test::hard_points;
using test::hard_profile;
using test::hard_ways;
using test::HardMachine;
using test::WayScript;

double pulse_mm_at(const MachineLimits& limits, const Pulses4& at) {
    double pulse_mm = 0.0;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}, kY})
        pulse_mm = std::max(pulse_mm, 1.0 / limits.axes[k].pulses_per_unit);
    for (std::size_t head = 0; head < kHeads; ++head) {
        const double radius_mm =
            static_cast<double>(at[head]) / limits.axes[head].pulses_per_unit + limits.tip_offset_mm[head];
        pulse_mm = std::max(pulse_mm, radius_mm * rad_from_pulses(1, limits.pulses_per_rev));
    }
    return pulse_mm;
}

constexpr double kNoSpeed2 = 1e-15;

/// Of many seeds, all in a long run, those that every run takes.
std::vector<std::uint64_t> seeds_of(std::uint64_t count, std::vector<std::uint64_t> always) {
    if (!psicarve::test::is_long_run()) return always;
    std::vector<std::uint64_t> all(count);
    std::iota(all.begin(), all.end(), std::uint64_t{1});
    return all;
}

class HardPaths : public ::testing::TestWithParam<HardMachine> {};

/// How far off a program's polyline a place is, as a share of the tolerance and a pulse. Points that a long
/// way is given near its ends are half a pulse off it: that counts where the table's pulse is coarse.
double share_off(const MachineLimits& limits, const WayScript& program, const CarvedProgram::Place& place,
                 double tolerance_mm) {
    const double pulse_mm = pulse_mm_at(limits, place.at);
    const double allowed_mm = tolerance_mm + (pulse_mm > tolerance_mm ? 1.5 : 1.0) * pulse_mm;
    const std::vector<Pulses4> way{program.points[place.line - 1], program.points[place.line]};
    double worst_mm = 0.0;
    for (std::size_t head = 0; head < kHeads; ++head) {
        double off_mm = test::off_polyline_mm(limits, way, 1, place.at, head);
        if (off_mm > allowed_mm)
            off_mm = test::off_polyline_mm(limits, program.points, place.line, place.at, head);
        worst_mm = std::max(worst_mm, off_mm);
    }
    return worst_mm / allowed_mm;
}

TEST_P(HardPaths, OfProgramsKeepTheToleranceAtEveryIteration) {
    const MachineLimits limits = machine_limits(hard_profile(GetParam()));
    constexpr std::array kTolerancePulses{1.01, 1.3, 2.0, 5.0, 20.0};
    const int long_ways = psicarve::test::is_long_run() ? 1300 : 400;
    for (const std::uint64_t seed : seeds_of(32, {12, 17})) {
        const double tolerance_mm =
            kTolerancePulses[seed % kTolerancePulses.size()] / limits.axes[0].pulses_per_unit;
        const WayScript program = hard_ways(limits, seed, seed % 4 == 0 ? long_ways : 150, tolerance_mm);
        const CarvedProgram done = carved(limits, program.script, program.points.front());
        for (const CarvedProgram::Place& place : done.places)
            ASSERT_LE(share_off(limits, program, place, tolerance_mm), 1.0)
                << "seed " << seed << " line " << place.line;
        ASSERT_FALSE(done.rests.empty());
        EXPECT_EQ(done.rests.back(), program.script.at()) << "seed " << seed;
    }
}

/// A stretch after the other as the planner makes it of a table's points.
std::vector<PathPiece> pieces_of(const MachineLimits& limits, const std::vector<PathPoint>& points) {
    const auto spans = path_spans(limits, points);
    const auto corners = path_corners(limits, spans);
    StretchPlanner planner(limits);
    std::vector<PathPiece> pieces;
    std::size_t first = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (i + 1 < points.size() && !corners[i - 1].is_stop) continue;
        planner.plan(points, spans, corners, first, i, pieces);
        first = i;
    }
    return pieces;
}

/// What spec 3's rule 1 says of a place between two points, in one head's plane.
double share_off_chord(const MachineLimits& limits, const Pulses4& from, const Pulses4& to, const Pulses4& at,
                       std::size_t head) {
    const double radius_mm = greatest_radii_mm(limits, from, to)[head];
    const double psi_mm = std::max(radius_mm, 0.0) * rad_from_pulses(1, limits.pulses_per_rev);
    const double pulse_mm = 1.0 / limits.axes[head].pulses_per_unit;
    const double x_mm = static_cast<double>(to[kPsi] - from[kPsi]) * psi_mm;
    const double y_mm = static_cast<double>(to[head] - from[head]) * pulse_mm;
    const double length_mm = std::hypot(x_mm, y_mm);
    const double ux = length_mm > 0.0 ? x_mm / length_mm : 1.0;
    const double uy = length_mm > 0.0 ? y_mm / length_mm : 0.0;
    const double passed_psi_mm = static_cast<double>(at[kPsi] - from[kPsi]) * psi_mm;
    const double passed_mm = static_cast<double>(at[head] - from[head]) * pulse_mm;
    const double across_mm = std::abs(ux * passed_mm - uy * passed_psi_mm);
    const double along_mm = ux * passed_psi_mm + uy * passed_mm;
    const double outside_mm = std::max({0.0, -along_mm, along_mm - length_mm});
    const double pulse_along_mm = std::max(std::abs(ux * psi_mm), std::abs(uy * pulse_mm)) + 1e-9;
    const double off_mm = outside_mm <= pulse_along_mm ? across_mm : std::hypot(across_mm, outside_mm);
    return off_mm /
           (limits.path_tolerance_mm + std::max(std::abs(ux * pulse_mm), std::abs(uy * psi_mm)) + 2e-9);
}

/// The worst of all iterations of a piece that begins `at`.
double worst_share(const MachineLimits& limits, const PathPiece& piece, const Pulses4& from,
                   const Pulses4& to, Pulses4& at) {
    cycle::DualHeadDda dda;
    const bool is_part = piece.line_pulses != Pulses4{};
    const Pulses4& line = is_part ? piece.line_pulses : piece.delta_pulses;
    const auto shorter = [](auto a, auto b) { return std::abs(a) < std::abs(b); };
    const auto longest =
        static_cast<std::size_t>(std::max_element(line.begin(), line.end(), shorter) - line.begin());
    dda.start_within(line, piece.line_done, std::abs(piece.delta_pulses[longest]));
    double worst = 0.0;
    while (dda.iterations_left() > 0) {
        const std::uint32_t axes = dda.iterate();
        for (std::size_t k = 0; k < kAxisCount; ++k)
            if ((axes >> k & 1U) != 0) at[k] += line[k] < 0 ? -1 : 1;
        for (std::size_t head = 0; head < kHeads; ++head)
            worst = std::max(worst, share_off_chord(limits, from, to, at, head));
    }
    return worst;
}

TEST_P(HardPaths, OfTablesKeepTheToleranceAtEveryIteration) {
    Profile profile = hard_profile(GetParam());
    constexpr std::array kTolerancePulses{0.3, 1.01, 2.0, 5.0, 20.0};
    for (const std::uint64_t seed : seeds_of(40, {1, 5})) {
        profile.job.path_tolerance_mm =
            kTolerancePulses[seed % kTolerancePulses.size()] / profile.r1.pulses_per_mm;
        const MachineLimits limits = machine_limits(profile);
        const std::vector<PathPoint> points = hard_points(limits, seed, 300);
        Pulses4 at = points[0].pulses;
        std::size_t span = 0;
        for (const PathPiece& piece : pieces_of(limits, points)) {
            const Pulses4 &from = points[span].pulses, &to = points[span + 1].pulses;
            ASSERT_LE(worst_share(limits, piece, from, to, at), 1.0) << "seed " << seed << " span " << span;
            if (piece.point == PathPiece::kNoPoint) {
                EXPECT_FALSE(piece.rests);
                continue;
            }
            ASSERT_EQ(at, to);
            ++span;
        }
        EXPECT_EQ(span + 1, points.size());
    }
}

INSTANTIATE_TEST_SUITE_P(On, HardPaths, ::testing::ValuesIn(test::kHardMachines),
                         [](const auto& one) { return std::string{one.param.name}; });

// A job's blocks know of the rests: each group ends in a point of the table, slow enough to rest there.
TEST(HardTable, RestWithinAStretchWhereNoCurveKeepsTheTolerance) {
    Profile profile = hard_profile(test::kHardMachines[1]);
    profile.job.path_tolerance_mm = 0.001;
    const MachineLimits limits = machine_limits(profile);
    std::size_t rests = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const auto job = test::job_of(test::hard_table(limits, seed));
        LookaheadProgram program(limits, job, {});
        std::size_t groups = 0;
        std::uint32_t left = 0;
        Timings before{};
        cycle::MotionBlock block;
        while (program.next(block)) {
            if (block.kind != cycle::BlockKind::path) continue;
            ASSERT_EQ(block.group_blocks > 0, left == 0);
            const double stop_speed = block.path.start_stop_speed;
            const double most_stop2 = 1.1 * stop_speed * stop_speed;
            for (std::size_t t = 0; t < kTimingCount; ++t) {
                if (left > 0) {
                    EXPECT_NEAR(block.path.start_speed2[t], before[t], 1e-9 * before[t] + kNoSpeed2);
                } else {
                    EXPECT_LE(block.path.start_speed2[t], most_stop2);
                }
                before[t] = block.path.end_speed2[t];
            }
            if (left == 0) left = block.group_blocks;
            if (--left > 0) continue;
            ++groups;
            EXPECT_GT(block.reaches_points, 0);
            for (const double end2 : block.path.end_speed2) EXPECT_LE(end2, most_stop2);
        }
        rests += groups - test::stops_of(limits, *job) - 1;
    }
    EXPECT_GT(rests, 0U);
}

}  // namespace
}  // namespace psicarve::plan
