// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/status_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace psicarve::report {
namespace {

CoreStatus with_time(MachineState state, double seconds_left, bool is_forecast) {
    CoreStatus status{};
    status.state = state;
    status.seconds_left = seconds_left;
    status.is_left_forecast = is_forecast ? 1 : 0;
    return status;
}

TEST(StatusJson, SaysWhetherTheTimeLeftIsPlannedToItsEnd) {
    const auto about = status_json(with_time(MachineState::carving, 90.0, true));
    EXPECT_EQ(about["seconds_left"], 90.0);
    EXPECT_EQ(about["seconds_left_is_estimate"], true);
    EXPECT_TRUE(about["planned_seconds"].is_null());
    const auto planned = status_json(with_time(MachineState::carving, 90.0, false));
    EXPECT_EQ(planned["seconds_left_is_estimate"], false);
    const auto at_rest = status_json(with_time(MachineState::ready, 90.0, false));
    EXPECT_TRUE(at_rest["seconds_left"].is_null());
    EXPECT_EQ(at_rest["seconds_left_is_estimate"], false);
    EXPECT_EQ(at_rest["planned_seconds"], 90.0);
}

}  // namespace
}  // namespace psicarve::report
