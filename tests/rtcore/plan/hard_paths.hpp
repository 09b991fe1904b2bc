// SPDX-License-Identifier: GPL-3.0-or-later
// Machines and paths for which a curve within the tolerance is hard to find, or there is none.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "rtcore/plan/path.hpp"
#include "shared/profile/profile.hpp"
#include "tests/rtcore/plan/corner_rig.hpp"
#include "tests/rtcore/plan/table_blocks.hpp"

namespace psicarve::plan::test {

struct HardMachine {
    const char* name;
    double pulses_per_mm;
    std::int64_t pulses_per_rev;
    double backlash_mm;
    double backlash_deg;
    double accel_share;
};

inline constexpr HardMachine kHardMachines[] = {
    {"built_in", 400, 6400, 0.0, 0.0, 1.0},     {"fine", 2000, 128'000, 0.0, 0.0, 1.0},
    {"coarse_table", 2000, 800, 0.0, 0.0, 1.0}, {"backlash", 2000, 128'000, 0.02, 0.1, 1.0},
    {"slow", 1000, 32'000, 0.0, 0.0, 0.02},     {"table_backlash", 400, 6400, 0.0, 0.1, 1.0},
};

inline Profile hard_profile(const HardMachine& machine) {
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

inline std::int64_t up_to(std::mt19937_64& random, std::int64_t most) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most + 1)) - most;
}

/// Ways whose lengths differ a thousandfold, some of a pulse, some back where they came from.
inline WayScript hard_ways(const MachineLimits& limits, std::uint64_t seed, int count, double tolerance_mm) {
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

inline std::vector<PathPoint> hard_points(const MachineLimits& limits, std::uint64_t seed, int count) {
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

/// A layer of such points.
inline JobTable hard_table(const MachineLimits& limits, std::uint64_t seed) {
    std::mt19937_64 random{seed};
    JobTable table = random_table(random, Joining::continuous, 1, 1);
    table.point_count = 300;
    table.psi_sweep_pulses = static_cast<std::int32_t>(299 * (seed % 4 + 1));
    for (auto* radii : {&table.r_left_pulses, &table.r_right_pulses}) radii->clear();
    for (const PathPoint& point : hard_points(limits, seed, 300)) {
        table.r_left_pulses.push_back(static_cast<std::int32_t>(point.pulses[0]));
        table.r_right_pulses.push_back(static_cast<std::int32_t>(point.pulses[1]));
    }
    return table;
}

/// Corners at which such a layer rests anyway.
inline std::size_t stops_of(const MachineLimits& limits, const JobView& job) {
    std::vector<PathPoint> points;
    for (std::uint32_t i = 0; i < job.point_count(); ++i)
        points.push_back({point_of(job, 0, i), 0, i, false});
    const auto corners = path_corners(limits, path_spans(limits, points));
    return static_cast<std::size_t>(
        std::ranges::count_if(corners, [](const PathCorner& corner) { return corner.is_stop; }));
}

}  // namespace psicarve::plan::test
