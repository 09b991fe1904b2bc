// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

struct Carving {
    std::vector<std::uint32_t> order;
    std::uint64_t approach_ticks;
    std::uint64_t carve_ticks;
    std::uint64_t finish_ticks;
};

JobTable smooth_job() {
    JobTable job = random_job(3, 40, 5);
    for (std::int32_t& radius : job.r_left_pulses) radius = 4000;
    for (std::int32_t& radius : job.r_right_pulses) radius = 3600;
    return job;
}

Carving carve(std::uint64_t percent) {
    MachineRig rig(quick_profile());
    Carving carving{};
    EXPECT_TRUE(rig.home());
    rig.load(smooth_job());
    EXPECT_EQ(rig.ask(RequestKind::override, 0, percent), Refusal::none);
    std::uint64_t begin = rig.cycle->next_tick();
    EXPECT_EQ(rig.ask(RequestKind::start), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::waiting));
    carving.approach_ticks = rig.cycle->next_tick() - begin;
    rig.port->writes.clear();
    begin = rig.cycle->next_tick();
    EXPECT_EQ(rig.ask(RequestKind::start_interpolation), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::finishing));
    carving.carve_ticks = rig.cycle->next_tick() - begin;
    carving.order = order_of(rig.port->writes);
    begin = rig.cycle->next_tick();
    EXPECT_TRUE(rig.run_until(MachineState::ready));
    carving.finish_ticks = rig.cycle->next_tick() - begin;
    return carving;
}

TEST(Override, SlowsTheCarvingAndNothingElse) {
    const Carving planned = carve(100);
    for (const std::uint64_t percent : {10U, 25U, 50U}) {
        const Carving slowed = carve(percent);
        const double ratio =
            static_cast<double>(slowed.carve_ticks) / static_cast<double>(planned.carve_ticks);
        EXPECT_GT(ratio, 0.8 * 100.0 / static_cast<double>(percent));
        EXPECT_LT(ratio, 1.01 * 100.0 / static_cast<double>(percent));
        EXPECT_EQ(slowed.approach_ticks, planned.approach_ticks);
        EXPECT_EQ(slowed.finish_ticks, planned.finish_ticks);
        EXPECT_EQ(slowed.order, planned.order);
    }
}

TEST(Override, OfMoreThanPlannedLeavesAnglePlannedLinesAsTheyAre) {
    EXPECT_EQ(carve(200).carve_ticks, carve(100).carve_ticks);
}

TEST(Override, AtAnyTimeLeavesTheMergedOrderOfIterationsAsItWas) {
    const std::vector<std::uint32_t> planned = carve(100).order;
    std::mt19937_64 random(17);
    for (int round = 0; round < 6; ++round) {
        MachineRig sut(quick_profile());
        ASSERT_TRUE(sut.prepare(smooth_job()));
        sut.port->writes.clear();
        ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
        while (sut.cycle->state() == MachineState::carving) {
            sut.ask(RequestKind::override, 0, 10 + random() % 191);
            const std::uint64_t until = sut.cycle->next_tick() + random() % 2000;
            sut.run_while([&] {
                return sut.cycle->state() == MachineState::carving && sut.cycle->next_tick() < until;
            });
        }
        ASSERT_EQ(sut.cycle->state(), MachineState::finishing);
        EXPECT_EQ(order_of(sut.port->writes), planned);
    }
}

TEST(Override, IsRefusedBeyondItsBoundsAndStaysAsItWas) {
    MachineRig sut(quick_profile());
    EXPECT_EQ(sut.ask(RequestKind::override, 0, 70), Refusal::none);
    for (const std::uint64_t percent :
         {std::uint64_t{0}, std::uint64_t{9}, std::uint64_t{201}, ~std::uint64_t{0}}) {
        EXPECT_EQ(sut.ask(RequestKind::override, 0, percent), Refusal::bad_override);
    }
    EXPECT_EQ(sut.cycle->sample().override_percent, 70U);
}

TEST(Override, StaysFromJobToJobUntilAnotherOneIsLoaded) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.prepare(random_job(1, 20, 5)));
    EXPECT_EQ(sut.cycle->sample().override_percent, 100U);
    EXPECT_EQ(sut.ask(RequestKind::override, 0, 130), Refusal::none);
    EXPECT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.ask(RequestKind::start), Refusal::none);
    EXPECT_EQ(sut.cycle->sample().override_percent, 130U);
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    sut.load(random_job(1, 20, 6));
    EXPECT_EQ(sut.cycle->sample().override_percent, 100U);
}

}  // namespace
}  // namespace psicarve::cycle
