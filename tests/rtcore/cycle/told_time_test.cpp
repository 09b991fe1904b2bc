// SPDX-License-Identifier: GPL-3.0-or-later
// What the planner says that a table takes, against what the tick takes for it.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "rtcore/plan/carving.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"
#include "tests/shared/passes_fixture.hpp"

namespace psicarve::cycle {
namespace {

Profile with_play(Profile profile, double share = 1.0) {
    profile.r1.backlash_mm = 0.05 * share;
    profile.r2.backlash_mm = 0.03 * share;
    profile.psi.backlash_deg = 0.12 * share;
    profile.y.backlash_mm = 0.08 * share;
    return profile;
}

Profile on_two_timers() {
    Profile profile = quick_profile();
    profile.tick.period_us = 100.0;
    profile.tick.schedule = Schedule::two_timer;
    profile.port.step_high_ns = 100'000;
    return profile;
}

/// Every point turns a head round: as many stops as a table can have.
JobTable jagged_job(std::uint32_t points) {
    JobTable table = random_job(1, points, 3);
    for (std::size_t i = 0; i < table.r_left_pulses.size(); ++i) {
        const std::int32_t out = i % 2 == 0 ? 0 : 30;
        table.r_left_pulses[i] = 4000 + out;
        table.r_right_pulses[i] = 4200 - out;
    }
    return table;
}

struct Told {
    double carved_s = 0.0;
    double planned_s = 0.0;
    double tick_s = 0.0;  ///< of the interpolation
};

Told carve_and_plan(const Profile& profile, const JobTable& table) {
    const plan::MachineLimits limits = plan::machine_limits(profile);
    MachineRig rig(profile);
    EXPECT_TRUE(rig.prepare(table));
    rig.ask(RequestKind::start_interpolation);
    EXPECT_TRUE(rig.run_until(MachineState::ready));
    const Sample end = rig.cycle->sample();
    Told told;
    told.carved_s = static_cast<double>(end.carve_last_tick - end.carve_first_tick) * 1e-9 *
                    static_cast<double>(limits.tick.period_ns);
    const auto blob = job_blob_from_table(table);
    const auto job = std::make_shared<const JobView>(JobView::check(blob).value());
    const auto program = plan::carving_of(limits, job);
    MotionBlock block{};
    while (program->next(block)) {
    }
    told.planned_s = program->planned().seconds;
    told.tick_s = limits.tick_seconds();
    return told;
}

TEST(ToldTime, OfLookAheadIsThatOfThePinsToATickWithBacklashToo) {
    for (const Joining joining : {Joining::continuous, Joining::zigzag, Joining::spiral}) {
        for (const double share : {0.0, 0.3, 1.0}) {
            const Told told =
                carve_and_plan(with_play(quick_profile(), share), random_job(4, 60, 5, joining));
            EXPECT_NEAR(told.carved_s, told.planned_s, 2.0 * told.tick_s)
                << static_cast<int>(joining) << ' ' << share;
        }
    }
}

TEST(ToldTime, CountsTheTicksAroundEveryStop) {
    const Told told = carve_and_plan(quick_profile(), jagged_job(400));
    EXPECT_NEAR(told.carved_s, told.planned_s, 2.0 * told.tick_s);
}

TEST(ToldTime, WithTwoTimersCountsTheWaitForTheLastPulse) {
    for (const double share : {0.0, 1.0}) {
        const Told told = carve_and_plan(with_play(on_two_timers(), share), jagged_job(200));
        EXPECT_NEAR(told.carved_s, told.planned_s, 0.002 * told.planned_s) << share;
    }
}

TEST(ToldTime, OfTheAnglePlannerIsThatOfThePinsToAFewTicks) {
    for (const double share : {0.0, 1.0}) {
        Profile profile = with_play(quick_profile(), share);
        profile.job.planner = Planner::angle;
        for (const Joining joining : {Joining::continuous, Joining::spiral}) {
            const Told told = carve_and_plan(profile, random_job(4, 60, 5, joining));
            EXPECT_NEAR(told.carved_s, told.planned_s, 4.0 * told.tick_s) << share;
        }
    }
}

TEST(ToldTime, CountsTheWaysBetweenPasses) {
    for (const Joining joining : {Joining::continuous, Joining::spiral}) {
        for (const double share : {0.0, 1.0}) {
            const JobTable table = with_roughing(random_job(3, 60, 5, joining), 2, 40);
            const Told told = carve_and_plan(with_play(quick_profile(), share), table);
            EXPECT_NEAR(told.carved_s, told.planned_s, 2.0 * told.tick_s)
                << static_cast<int>(joining) << ' ' << share;
        }
    }
}

}  // namespace
}  // namespace psicarve::cycle
