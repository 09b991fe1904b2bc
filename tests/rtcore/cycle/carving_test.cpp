// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

/// The points that the written pins passed, in order, starting at `start`.
std::size_t points_visited(const std::vector<PortWrite>& writes, const Positions& start,
                           const std::vector<Positions>& points) {
    PinCounter pins(start);
    std::size_t next = 0;
    while (next < points.size() && points[next] == pins.positions()) ++next;
    for (const PortWrite& write : writes) {
        pins.take(write.levels);
        while (next < points.size() && points[next] == pins.positions()) ++next;
    }
    return next;
}

void expect_carves_every_point(Joining joining, std::uint64_t seed,
                               psicarve::Planner planner = psicarve::Planner::angle) {
    Profile profile = quick_profile();
    profile.job.planner = planner;
    MachineRig sut(profile);
    const JobTable job = random_job(4, 120, seed, joining);
    ASSERT_TRUE(sut.prepare(job));
    const std::vector<Positions> points = points_of(job);
    ASSERT_EQ(sut.positions(), points.front());
    sut.port->writes.clear();
    ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::finishing));
    EXPECT_EQ(sut.positions(), points.back());
    EXPECT_EQ(points_visited(sut.port->writes, points.front(), points), points.size());
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    const Sample sample = sut.cycle->sample();
    EXPECT_EQ(sample.points_done, points.size());
    EXPECT_GT(sample.carve_first_tick, 0U);
    EXPECT_GT(sample.carve_last_tick, sample.carve_first_tick);
    for (std::size_t k = 0; k < kAxisCount; ++k) {
        EXPECT_EQ(sut.machine->position_pulses(kAllAxes[k]), sut.positions()[k]) << "axis " << k;
    }
}

TEST(Carving, EveryPointIsVisitedExactlyAndInOrderWhenLayersJoinContinuously) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) expect_carves_every_point(Joining::continuous, seed);
}

TEST(Carving, EveryPointIsVisitedExactlyAndInOrderWhenLayersZigzag) {
    for (const std::uint64_t seed : {4U, 5U, 6U}) expect_carves_every_point(Joining::zigzag, seed);
}

TEST(Carving, EveryPointIsVisitedExactlyAndInOrderAlongASpiral) {
    for (const std::uint64_t seed : {7U, 8U, 9U}) {
        expect_carves_every_point(Joining::spiral, seed);
        expect_carves_every_point(Joining::spiral, seed, psicarve::Planner::lookahead);
    }
}

}  // namespace
}  // namespace psicarve::cycle
