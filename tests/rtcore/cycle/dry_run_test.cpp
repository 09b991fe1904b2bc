// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "rtcore/cycle/layer_range.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

constexpr std::uint32_t kLayers = 4;
constexpr std::uint32_t kPoints = 60;
constexpr std::uint32_t kHeads = 0b0011;
constexpr std::uint32_t kTableAndY = 0b1100;

struct Step {
    std::uint64_t tick;
    std::uint32_t axes;  ///< psi and y alone
};

/// What table and Y did from the start of interpolation to the last point.
std::vector<Step> carve(MachineRig& rig, LayerRange layers, std::uint32_t& heads_stepped) {
    EXPECT_EQ(rig.ask(RequestKind::start, 0, packed(layers)), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::waiting));
    rig.port->writes.clear();
    const std::uint64_t begin = rig.cycle->next_tick();
    EXPECT_EQ(rig.ask(RequestKind::start_interpolation), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::finishing));
    std::vector<Step> steps;
    SignalWord levels = 0;
    for (const PortWrite& write : rig.port->writes) {
        const std::uint32_t axes = write.levels & ~levels & kStepMask;
        levels = write.levels;
        heads_stepped += (axes & kHeads) != 0 ? 1 : 0;
        if ((axes & kTableAndY) != 0) steps.push_back({write.tick - begin, axes & kTableAndY});
    }
    return steps;
}

struct Way {
    Joining joining;
    psicarve::Planner planner;
};

class DryRun : public ::testing::TestWithParam<Way> {
protected:
    static Profile profile() {
        Profile result = quick_profile();
        result.job.planner = GetParam().planner;
        return result;
    }
};

TEST_P(DryRun, MovesTableAndYAsTheJobWouldAndNothingElse) {
    const JobTable job = random_job(kLayers, kPoints, 21, GetParam().joining);
    MachineRig sut(profile());
    ASSERT_TRUE(sut.home());
    sut.load(job);
    std::uint32_t heads_stepped = 0;
    const std::vector<Step> real = carve(sut, {0, 0, false}, heads_stepped);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_GT(heads_stepped, 0U);
    EXPECT_EQ(sut.cycle->sample().is_dry, 0U);
    const std::uint64_t starts = sut.machine->report().spindle_starts;

    heads_stepped = 0;
    const std::vector<Step> dry = carve(sut, {0, 0, true}, heads_stepped);
    EXPECT_EQ(heads_stepped, 0U);
    EXPECT_EQ(sut.cycle->sample().is_dry, 1U);
    EXPECT_EQ(sut.cycle->sample().points_done, std::uint64_t{kLayers} * kPoints);
    EXPECT_EQ(sut.machine->report().spindle_starts, starts);
    // Clear of the blank, which is as large as the job's largest radius.
    std::int32_t largest = 0;
    for (const auto* table : {&job.r_left_pulses, &job.r_right_pulses})
        largest = std::max(largest, *std::max_element(table->begin(), table->end()));
    for (const std::size_t head : {0U, 1U}) {
        const AxisMotion motion = axis_motion(sut.profile, static_cast<Axis>(head));
        const auto wanted =
            largest + static_cast<std::int64_t>(sut.profile.job.clearance_mm * motion.pulses_per_unit);
        EXPECT_EQ(sut.positions()[head], std::min(wanted, motion.travel_max_pulses)) << head;
    }
    ASSERT_EQ(dry.size(), real.size());
    for (std::size_t i = 0; i < dry.size(); ++i) {
        ASSERT_EQ(dry[i].axes, real[i].axes) << i;
        // A head that turns round may keep a pulse of the table waiting for its direction pin.
        ASSERT_NEAR(static_cast<double>(dry[i].tick), static_cast<double>(real[i].tick), 20.0) << i;
    }
    EXPECT_EQ(sut.positions()[2], points_of(job).back()[2]);
    EXPECT_EQ(sut.positions()[3], points_of(job).back()[3]);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    for (std::size_t k = 0; k < kAxisCount; ++k) EXPECT_EQ(sut.machine->report().axes[k].stalls, 0U);
}

TEST_P(DryRun, LeavesNothingBehindForTheRealRun) {
    const JobTable job = random_job(kLayers, kPoints, 22, GetParam().joining);
    MachineRig sut(profile());
    ASSERT_TRUE(sut.home());
    sut.load(job);
    std::uint32_t heads_stepped = 0;
    (void)carve(sut, {1, 2, true}, heads_stepped);
    EXPECT_EQ(heads_stepped, 0U);
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    (void)carve(sut, {1, 1, false}, heads_stepped);
    EXPECT_GT(heads_stepped, 0U);
    EXPECT_EQ(sut.positions(), points_of(job)[2 * kPoints - 1]);
}

TEST_P(DryRun, HoldAndStopWorkAndTheSpindleStaysOff) {
    MachineRig sut(profile());
    ASSERT_TRUE(sut.home());
    sut.load(random_job(kLayers, kPoints, 23, GetParam().joining));
    ASSERT_EQ(sut.ask(RequestKind::start, 0, packed(LayerRange{0, 0, true})), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::waiting));
    ASSERT_EQ(sut.ask(RequestKind::start_interpolation), Refusal::none);
    sut.run(2000);
    ASSERT_EQ(sut.ask(RequestKind::hold), Refusal::none);
    ASSERT_TRUE(sut.run_until(MachineState::held));
    ASSERT_EQ(sut.ask(RequestKind::resume), Refusal::none);
    sut.run(2000);
    EXPECT_EQ(sut.cycle->sample().signals & bit_of(Signal::spindle), 0U);
    sut.stop();
    ASSERT_TRUE(sut.run_until(MachineState::ready));
    EXPECT_EQ(sut.machine->report().spindle_starts, 0U);
}

INSTANTIATE_TEST_SUITE_P(All, DryRun,
                         ::testing::Values(Way{Joining::continuous, psicarve::Planner::angle},
                                           Way{Joining::zigzag, psicarve::Planner::lookahead},
                                           Way{Joining::continuous, psicarve::Planner::lookahead},
                                           Way{Joining::spiral, psicarve::Planner::lookahead}),
                         [](const auto& named) {
                             return std::string{name_of(named.param.joining)} +
                                    (named.param.planner == psicarve::Planner::angle ? "_by_angle"
                                                                                     : "_ahead");
                         });

}  // namespace
}  // namespace psicarve::cycle
