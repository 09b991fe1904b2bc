// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/request_effect.hpp"

#include <gtest/gtest.h>

#include <set>

namespace psicarve::cycle {
namespace {

bool sets_going_as(RequestKind kind, std::uint64_t value) {
    Request request{};
    request.kind = kind;
    request.value = value;
    return sets_going(request);
}

// What ends a motion, switches off or only tells is never too late.
TEST(RequestEffect, IsMotionOrPowerOfAllRequestsButThese) {
    const std::set<RequestKind> harmless{
        RequestKind::hold,    RequestKind::job_loaded, RequestKind::override,  RequestKind::fail,
        RequestKind::end_jog, RequestKind::record,     RequestKind::drives_off};
    for (int k = 0; k <= static_cast<int>(RequestKind::drives_off); ++k) {
        const auto kind = static_cast<RequestKind>(k);
        if (kind == RequestKind::spindle || kind == RequestKind::test_pin) continue;
        EXPECT_EQ(sets_going_as(kind, 0), !harmless.contains(kind)) << k;
    }
}

TEST(RequestEffect, OfSpindleAndPinsDependsOnWhetherTheyAreSwitchedOn) {
    EXPECT_TRUE(sets_going_as(RequestKind::spindle, 1));
    EXPECT_FALSE(sets_going_as(RequestKind::spindle, 0));
    PinOrder order;
    order.pulses = 3;
    EXPECT_FALSE(sets_going_as(RequestKind::test_pin, packed(order)));
    order.is_on = true;
    EXPECT_TRUE(sets_going_as(RequestKind::test_pin, packed(order)));
}

}  // namespace
}  // namespace psicarve::cycle
