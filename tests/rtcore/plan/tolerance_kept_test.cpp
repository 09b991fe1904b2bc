// SPDX-License-Identifier: GPL-3.0-or-later
// Paths that are hard to find a curve for: none is carved outside its tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "rtcore/cycle/dual_head_dda.hpp"
#include "rtcore/plan/path_stretch.hpp"
#include "tests/rtcore/plan/corner_rig.hpp"
#include "tests/rtcore/plan/table_blocks.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::plan {
namespace {

using test::carved;
using test::CarvedProgram;
using test::WayScript;

struct HardMachine {
    const char* name;
    double pulses_per_mm;
    std::int64_t pulses_per_rev;
    double backlash_mm;
    double backlash_deg;
    double accel_share;
};

constexpr HardMachine kHardMachines[] = {
    {"built_in", 400, 6400, 0.0, 0.0, 1.0},     {"fine", 2000, 128'000, 0.0, 0.0, 1.0},
    {"coarse_table", 2000, 800, 0.0, 0.0, 1.0}, {"backlash", 2000, 128'000, 0.02, 0.1, 1.0},
    {"slow", 1000, 32'000, 0.0, 0.0, 0.02},     {"table_backlash", 400, 6400, 0.0, 0.1, 1.0},
};

Profile profile_of(const HardMachine& machine) {
    Profile profile;
    profile.tick.period_us = 10;
    for (LinearAxisProfile* axis : {&profile.r1, &profile.r2, &profile.y}) {
        axis->pulses_per_mm = machine.pulses_per_mm;
        axis->accel_mm_s2 *= machine.accel_share;
    }
    profile.psi.accel_deg_s2 *= machine.accel_share;
    profile.r1.backlash_mm = machine.backlash_mm;
    profile.psi.backlash_deg = machine.backlash_deg;
    profile.psi.pulses_per_rev = machine.pulses_per_rev;
    return profile;
}

std::int64_t up_to(std::mt19937_64& random, std::int64_t most) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most + 1)) - most;
}

/// Ways whose lengths differ a thousandfold, some of a pulse, some back where they came from.
WayScript hard_ways(const MachineLimits& limits, std::uint64_t seed, int count, double tolerance_mm) {
    std::mt19937_64 random{seed};
    Pulses4 start{};
    start[kPsi] = 100;
    const double radius_mm = seed % 3 == 0 ? 0.3 : 15.0;
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}, kY})
        start[k] = round_to_pulse(15.0 * limits.axes[k].pulses_per_unit);
    WayScript program{start};
    const auto axes = static_cast<unsigned>(1 + random() % 15);
    std::int64_t most = 1;
    Pulses4 way{};
    for (int i = 0; i < count; ++i) {
        if (random() % 6 == 0) {
            constexpr std::array<std::int64_t, 6> kMost{1, 2, 5, 30, 300, 2000};
            most = kMost[random() % kMost.size()];
        }
        const std::size_t alone = random() % 5;
        const Pulses4 before = way;
        for (std::size_t k = 0; k < kAxisCount; ++k) {
            way[k] = 0;
            if ((axes >> k & 1U) == 0 || (alone < kAxisCount && alone != k)) continue;
            const double scale = k == kPsi ? 1.0 / (radius_mm * rad_from_pulses(1, limits.pulses_per_rev)) /
                                                 limits.axes[0].pulses_per_unit
                                           : 1.0;
            way[k] = round_to_pulse(static_cast<double>(up_to(random, most)) * std::max(scale, 0.2));
            const double off_mm = static_cast<double>(program.script.at()[k] + way[k] - start[k]) /
                                  limits.axes[k].pulses_per_unit;
            if (k != kPsi && std::abs(off_mm) > 4.0) way[k] = -way[k];
        }
        if (random() % 12 == 0)
            for (std::size_t k = 0; k < kAxisCount; ++k) way[k] = -before[k];
        if (way != Pulses4{}) program.way(way, tolerance_mm);
    }
    program.script.end();
    return program;
}

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
    const MachineLimits limits = machine_limits(profile_of(GetParam()));
    constexpr std::array kTolerancePulses{1.01, 1.3, 2.0, 5.0, 20.0};
    const std::uint64_t seeds = psicarve::test::is_thorough() ? 32 : 4;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const double tolerance_mm =
            kTolerancePulses[seed % kTolerancePulses.size()] / limits.axes[0].pulses_per_unit;
        const WayScript program = hard_ways(limits, seed, seed % 4 == 0 ? 1300 : 150, tolerance_mm);
        const CarvedProgram done = carved(limits, program.script, program.points.front());
        for (const CarvedProgram::Place& place : done.places)
            ASSERT_LE(share_off(limits, program, place, tolerance_mm), 1.0)
                << "seed " << seed << " line " << place.line;
        ASSERT_FALSE(done.rests.empty());
        EXPECT_EQ(done.rests.back(), program.script.at()) << "seed " << seed;
    }
}

std::vector<PathPoint> hard_points(const MachineLimits& limits, std::uint64_t seed, int count) {
    std::mt19937_64 random{seed};
    std::vector<PathPoint> points;
    const auto mm = [&](double at) { return round_to_pulse(at * limits.axes[0].pulses_per_unit); };
    Pulses4 at{mm(15.0), mm(15.0), 0, mm(10.0)};
    if (seed % 3 == 0) at[0] = at[1] = mm(1.0);
    std::int64_t most = 1;
    std::int64_t turn = 1;
    for (int i = 0; i < count; ++i) {
        points.push_back({at, 0, static_cast<std::uint32_t>(i), false});
        if (random() % 8 == 0) {
            constexpr std::array<std::int64_t, 7> kMost{0, 1, 3, 10, 100, 1000, 6000};
            most = kMost[random() % kMost.size()];
            constexpr std::array<std::int64_t, 5> kTurn{1, 2, 7, 40, 300};
            turn = kTurn[random() % kTurn.size()];
        }
        at[kPsi] += turn;
        for (std::size_t k = 0; k < kHeads; ++k) {
            std::int64_t way = random() % 3 == 0 ? 0 : up_to(random, most);
            if (at[k] + way < mm(0.6) || at[k] + way > mm(25.0)) way = -way;
            at[k] += way;
        }
    }
    return points;
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
    Profile profile = profile_of(GetParam());
    constexpr std::array kTolerancePulses{0.3, 1.01, 2.0, 5.0, 20.0};
    const std::uint64_t seeds = psicarve::test::is_thorough() ? 40 : 8;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
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

INSTANTIATE_TEST_SUITE_P(On, HardPaths, ::testing::ValuesIn(kHardMachines),
                         [](const auto& one) { return std::string{one.param.name}; });

// A job's blocks know of the rests: each group ends in a point of the table, slow enough to rest there.
TEST(HardTable, RestWithinAStretchWhereNoCurveKeepsTheTolerance) {
    Profile profile = profile_of(kHardMachines[1]);
    profile.job.path_tolerance_mm = 0.001;
    const MachineLimits limits = machine_limits(profile);
    std::size_t rests = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        std::mt19937_64 random{seed};
        JobTable table = test::random_table(random, Joining::continuous, 1, 1);
        table.point_count = 300;
        table.psi_sweep_pulses = static_cast<std::int32_t>(299 * (seed % 4 + 1));
        for (auto* radii : {&table.r_left_pulses, &table.r_right_pulses}) radii->clear();
        for (const PathPoint& point : hard_points(limits, seed, 300)) {
            table.r_left_pulses.push_back(static_cast<std::int32_t>(point.pulses[0]));
            table.r_right_pulses.push_back(static_cast<std::int32_t>(point.pulses[1]));
        }
        const auto job = test::job_of(table);
        LookaheadProgram program(limits, job, {});
        std::vector<PathPoint> points;
        for (std::uint32_t i = 0; i < table.point_count; ++i)
            points.push_back({test::point_of(*job, 0, i), 0, i, false});
        const auto corners = path_corners(limits, path_spans(limits, points));
        const auto is_stop = [](const PathCorner& corner) { return corner.is_stop; };
        const auto stops = std::count_if(corners.begin(), corners.end(), is_stop);
        std::size_t groups = 0;
        std::uint32_t left = 0;
        cycle::MotionBlock block;
        while (program.next(block)) {
            if (block.kind != cycle::BlockKind::path) continue;
            ASSERT_EQ(block.group_blocks > 0, left == 0);
            if (left == 0) left = block.group_blocks;
            if (--left > 0) continue;
            ++groups;
            EXPECT_GT(block.reaches_points, 0);
            const double stop_speed = block.path.start_stop_speed;
            EXPECT_LE(block.path.end_speed2[0], 1.1 * stop_speed * stop_speed);
        }
        rests += groups - static_cast<std::size_t>(stops) - 1;
    }
    EXPECT_GT(rests, 0U);
}

}  // namespace
}  // namespace psicarve::plan
