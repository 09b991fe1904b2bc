// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/order_target.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <utility>

namespace psicarve::cycle {
namespace {

using Targets = std::array<std::int64_t, kAxisCount>;

constexpr Targets kStandsAt{2000, 3000, 0, 500};

/// Heads from 100 to 4000, cores at 300, 1 mm a pulse, 900 between them; Y from 0 to 1000.
SoftLimits target_limits() {
    SoftLimits limits;
    limits.least_pulses = {100, 100, -kFurthestPulses, 0};
    limits.most_pulses = {4000, 4000, kFurthestPulses, 1000};
    limits.core_pulses = {300, 300};
    limits.least_sum_mm = 900.0;
    return limits;
}

Request order_of_kind(RequestKind kind, std::initializer_list<std::pair<Axis, std::int64_t>> targets) {
    Request request{};
    request.kind = kind;
    for (const auto& [axis, target] : targets) {
        request.order.axes = static_cast<std::uint8_t>(request.order.axes | 1U << index_of(axis));
        request.order.target_pulses[index_of(axis)] = target;
    }
    return request;
}

OrderTarget target_from(const Request& request, const Targets& from = kStandsAt) {
    return target_of(request, from, target_limits());
}

TEST(OrderTarget, OfAMoveIsAPlaceAndOfAJogADistance) {
    const OrderTarget move = target_from(order_of_kind(RequestKind::move, {{Axis::r1, 1500}, {Axis::y, 10}}));
    EXPECT_EQ(move.verdict.refusal, Refusal::none);
    EXPECT_EQ(move.pulses, (Targets{1500, 3000, 0, 10}));
    const OrderTarget jog = target_from(order_of_kind(RequestKind::jog, {{Axis::r2, -200}}));
    EXPECT_EQ(jog.verdict.refusal, Refusal::none);
    EXPECT_EQ(jog.pulses, (Targets{2000, 2800, 0, 500}));
}

TEST(OrderTarget, LeavesAxesAloneThatAreNotOrdered) {
    Request request = order_of_kind(RequestKind::move, {{Axis::r1, 1500}});
    request.order.target_pulses[index_of(Axis::y)] = 77;
    EXPECT_EQ(target_from(request).pulses, (Targets{1500, 3000, 0, 500}));
}

TEST(OrderTarget, OfAContinuousJogIsTheEndOfTheTravel) {
    EXPECT_EQ(target_from(order_of_kind(RequestKind::jog_on, {{Axis::y, 1}})).pulses,
              (Targets{2000, 3000, 0, 1000}));
    EXPECT_EQ(target_from(order_of_kind(RequestKind::jog_on, {{Axis::r1, -1}})).pulses,
              (Targets{300, 3000, 0, 500}));
}

TEST(OrderTarget, OfBothHeadsIsEquallyFarForEach) {
    const OrderTarget out = target_from(order_of_kind(RequestKind::jog_on, {{Axis::r1, 1}, {Axis::r2, 1}}));
    EXPECT_EQ(out.verdict.refusal, Refusal::none);
    EXPECT_EQ(out.pulses, (Targets{3000, 4000, 0, 500}));
}

TEST(OrderTarget, IsRefusedWithItsAxisWhereNoWayIsLeft) {
    const OrderTarget alone =
        target_from(order_of_kind(RequestKind::jog_on, {{Axis::y, 1}}), Targets{2000, 3000, 0, 1000});
    EXPECT_EQ(alone.verdict.refusal, Refusal::at_the_end);
    EXPECT_EQ(alone.verdict.axis, index_of(Axis::y));
    const OrderTarget heads = target_from(order_of_kind(RequestKind::jog_on, {{Axis::r1, 1}, {Axis::r2, 1}}),
                                          Targets{2000, 4000, 0, 0});
    EXPECT_EQ(heads.verdict.refusal, Refusal::at_the_end);
    EXPECT_EQ(heads.verdict.axis, index_of(Axis::r1));
}

TEST(OrderTarget, IsRefusedBehindEachSoftLimit) {
    const OrderTarget travel = target_from(order_of_kind(RequestKind::move, {{Axis::y, 1001}}));
    EXPECT_EQ(travel.verdict.refusal, Refusal::outside_travel);
    EXPECT_EQ(travel.verdict.axis, index_of(Axis::y));
    const OrderTarget core = target_from(order_of_kind(RequestKind::move, {{Axis::r2, 299}}));
    EXPECT_EQ(core.verdict.refusal, Refusal::inside_core_radius);
    EXPECT_EQ(core.verdict.axis, index_of(Axis::r2));
    const OrderTarget heads =
        target_from(order_of_kind(RequestKind::move, {{Axis::r1, 400}, {Axis::r2, 450}}));
    EXPECT_EQ(heads.verdict.refusal, Refusal::heads_too_close);
}

TEST(OrderTarget, OfAnArcMustBeAsFarFromTheCentreAsItsBegin) {
    Request request = order_of_kind(RequestKind::move, {{Axis::r1, 2200}, {Axis::y, 700}});
    request.order.shape = OrderShape::arc;
    request.order.centre_pulses = {2000, 700};
    EXPECT_EQ(target_from(request).verdict.refusal, Refusal::none);
    request.order.target_pulses[0] = 2250;
    EXPECT_EQ(target_from(request).verdict.refusal, Refusal::not_an_arc);
}

// Both its ends are good, and between them it reaches out.
TEST(OrderTarget, OfAnArcIsRefusedWhereTheArcLeavesTheTravel) {
    Request request = order_of_kind(RequestKind::move, {{Axis::r1, 2200}, {Axis::y, 900}});
    request.order.shape = OrderShape::clockwise;
    request.order.centre_pulses = {2100, 900};
    const Targets from{2000, 3000, 0, 900};
    EXPECT_EQ(target_from(request, from).verdict.refusal, Refusal::none);
    request.order.centre_pulses[1] = request.order.target_pulses[3] = 950;
    const OrderTarget out = target_from(request, Targets{2000, 3000, 0, 950});
    EXPECT_EQ(out.verdict.refusal, Refusal::outside_travel);
    EXPECT_EQ(out.verdict.axis, index_of(Axis::y));
    request.order.shape = OrderShape::arc;
    EXPECT_EQ(target_from(request, Targets{2000, 3000, 0, 950}).verdict.refusal, Refusal::none)
        << "the other way round it stays below";
}

}  // namespace
}  // namespace psicarve::cycle
