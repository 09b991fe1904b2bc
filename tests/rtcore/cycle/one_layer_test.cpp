// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "rtcore/cycle/layer_range.hpp"
#include "tests/rtcore/cycle/machine_rig.hpp"

namespace psicarve::cycle {
namespace {

constexpr std::uint32_t kLayers = 5;
constexpr std::uint32_t kPoints = 60;

using Order = std::vector<std::uint32_t>;

/// Which axes stepped together, from each layer's first point to its last, as the pins went by the points.
std::vector<Order> orders_of_layers(const std::vector<PortWrite>& writes,
                                    const std::vector<Positions>& points, std::uint32_t first_layer) {
    std::vector<Order> orders(kLayers);
    std::size_t next = std::size_t{first_layer} * kPoints;
    PinCounter pins(points[next]);
    const auto pass_points = [&] {
        while (next < points.size() && points[next] == pins.positions()) ++next;
    };
    pass_points();
    for (const PortWrite& write : writes) {
        const std::size_t layer = next / kPoints;
        const bool is_between_layers = next % kPoints == 0;
        if (const std::uint32_t axes = pins.take(write.levels); axes != 0) {
            if (next < points.size() && !is_between_layers) orders[layer].push_back(axes);
        }
        pass_points();
    }
    return orders;
}

/// What the pins did while these layers were carved, and where the heads stood then.
std::pair<std::vector<PortWrite>, Positions> carve(MachineRig& rig, LayerRange layers) {
    EXPECT_EQ(rig.ask(RequestKind::start, 0, packed(layers)), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::waiting));
    rig.port->writes.clear();
    EXPECT_EQ(rig.ask(RequestKind::start_interpolation), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::finishing));
    std::pair<std::vector<PortWrite>, Positions> result{rig.port->writes, rig.positions()};
    EXPECT_TRUE(rig.run_until(MachineState::ready));
    return result;
}

struct Way {
    Joining joining;
    psicarve::Planner planner;
};

class OneLayer : public ::testing::TestWithParam<Way> {
protected:
    OneLayer()
        : job(random_job(kLayers, kPoints, 11, GetParam().joining)), points(points_of(job)), sut(profile()) {
        EXPECT_TRUE(sut.home());
        sut.load(job);
    }
    static Profile profile() {
        Profile result = quick_profile();
        result.job.planner = GetParam().planner;
        return result;
    }

    JobTable job;
    std::vector<Positions> points;
    MachineRig sut;
};

TEST_P(OneLayer, HasThePulsesThatItHasInTheWholeRun) {
    const std::vector<Order> whole = orders_of_layers(carve(sut, {0, 0}).first, points, 0);
    for (std::uint32_t layer = 0; layer < kLayers; ++layer) {
        const auto [writes, end] = carve(sut, {layer, 1});
        EXPECT_EQ(end, points[(layer + 1) * kPoints - 1]) << "layer " << layer;
        const std::vector<Order> alone = orders_of_layers(writes, points, layer);
        EXPECT_FALSE(alone[layer].empty());
        EXPECT_EQ(alone[layer], whole[layer]) << "layer " << layer;
        for (std::uint32_t other = 0; other < kLayers; ++other) {
            EXPECT_TRUE(other == layer || alone[other].empty()) << "layer " << layer << " and " << other;
        }
        EXPECT_GT(sut.cycle->sample().carve_last_tick, sut.cycle->sample().carve_first_tick);
        EXPECT_EQ(sut.cycle->sample().signals & bit_of(Signal::spindle), 0U);
    }
    for (std::size_t k = 0; k < kAxisCount; ++k) EXPECT_EQ(sut.machine->report().axes[k].stalls, 0U);
}

TEST_P(OneLayer, GoesOnToTheSamePulsesAsTheWholeRun) {
    const std::vector<Order> whole = orders_of_layers(carve(sut, {0, 0}).first, points, 0);
    (void)carve(sut, {0, 2});
    const auto [writes, end] = carve(sut, {2, 0});
    EXPECT_EQ(end, points.back());
    const std::vector<Order> rest = orders_of_layers(writes, points, 2);
    for (std::uint32_t layer = 2; layer < kLayers; ++layer) EXPECT_EQ(rest[layer], whole[layer]) << layer;
    EXPECT_EQ(sut.cycle->sample().points_done, points.size());
}

enum class End { emergency_stop, limit };

/// Carves until it is stopped at a random tick, then homes anew. The layer that was not finished.
std::uint32_t carve_until(MachineRig& rig, End end, std::mt19937_64& random) {
    EXPECT_EQ(rig.ask(RequestKind::start), Refusal::none);
    EXPECT_TRUE(rig.run_until(MachineState::waiting));
    EXPECT_EQ(rig.ask(RequestKind::start_interpolation), Refusal::none);
    rig.run(2000 + random() % 8000);
    EXPECT_EQ(rig.cycle->state(), MachineState::carving);
    if (end == End::emergency_stop) {
        rig.emergency_stop();
    } else {
        rig.machine->hold_input(Signal::r2_limit, true);
    }
    EXPECT_TRUE(rig.run_until(MachineState::alarm));
    const auto layer = static_cast<std::uint32_t>(rig.cycle->sample().points_done / kPoints);
    rig.machine->release_input(Signal::r2_limit);
    rig.run(1000);
    EXPECT_EQ(rig.ask(RequestKind::reset_alarm), Refusal::none);
    EXPECT_NE(rig.ask(RequestKind::start, 0, packed(LayerRange{layer, 0})), Refusal::none) << "not homed";
    EXPECT_TRUE(rig.home());
    return layer;
}

TEST_P(OneLayer, CutShortByAnAlarmIsCarvedAnewWithTheSamePulsesAndTheRest) {
    const std::vector<Order> whole = orders_of_layers(carve(sut, {0, 0}).first, points, 0);
    std::mt19937_64 random(5);
    for (const End end : {End::emergency_stop, End::limit, End::emergency_stop, End::limit}) {
        const std::uint32_t first = carve_until(sut, end, random);
        ASSERT_LT(first, kLayers);
        const auto [writes, last] = carve(sut, {first, 0});
        EXPECT_EQ(last, points.back());
        const std::vector<Order> rest = orders_of_layers(writes, points, first);
        for (std::uint32_t layer = first; layer < kLayers; ++layer)
            EXPECT_EQ(rest[layer], whole[layer]) << layer << " from " << first;
    }
}

INSTANTIATE_TEST_SUITE_P(All, OneLayer,
                         ::testing::Values(Way{Joining::continuous, psicarve::Planner::angle},
                                           Way{Joining::zigzag, psicarve::Planner::angle},
                                           Way{Joining::spiral, psicarve::Planner::angle},
                                           Way{Joining::continuous, psicarve::Planner::lookahead},
                                           Way{Joining::zigzag, psicarve::Planner::lookahead},
                                           Way{Joining::spiral, psicarve::Planner::lookahead}),
                         [](const auto& named) {
                             return std::string{name_of(named.param.joining)} +
                                    (named.param.planner == psicarve::Planner::angle ? "_by_angle"
                                                                                     : "_ahead");
                         });

TEST(LayerRange, RefusesLayersThatTheJobHasNot) {
    MachineRig sut(quick_profile());
    ASSERT_TRUE(sut.home());
    sut.load(random_job(kLayers, kPoints, 12));
    for (const LayerRange& range :
         {LayerRange{kLayers, 0}, LayerRange{kLayers, 1}, LayerRange{kLayers - 1, 2},
          LayerRange{0, kLayers + 1}, LayerRange{~0U, ~0U}}) {
        EXPECT_EQ(sut.ask(RequestKind::start, 0, packed(range)), Refusal::no_such_layer)
            << range.first << " " << range.count;
    }
    EXPECT_EQ(sut.ask(RequestKind::start, 0, packed(LayerRange{kLayers - 1, 1})), Refusal::none);
}

}  // namespace
}  // namespace psicarve::cycle
