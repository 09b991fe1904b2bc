// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

class Status : public Machine {};

TEST_F(Status, TheTableStandsWithinATurnAndItsTurnsAreCounted) {
    start_core();
    ASSERT_EQ(run({"home"}).exit_code, 0);
    ASSERT_EQ(run({"jog", "psi", "765"}).exit_code, 0);
    const auto status = run({"status", "--json"}).json();
    const std::int64_t pulses = status["position_pulses"]["psi"].get<std::int64_t>();
    ASSERT_GT(pulses, 6400);
    EXPECT_EQ(status["position"]["psi_turns"], pulses / 6400);
    EXPECT_DOUBLE_EQ(status["position"]["psi_deg"].get<double>(),
                     static_cast<double>(pulses % 6400) * 360.0 / 6400.0);
    EXPECT_DOUBLE_EQ(status["position"]["y_mm"].get<double>(),
                     status["position_pulses"]["y"].get<double>() / 400.0);
    EXPECT_NE(run({"status"}).out.find(" deg and 2 turns ("), std::string::npos) << run({"status"}).out;
    ASSERT_EQ(run({"jog", "psi", "-1500"}).exit_code, 0);
    const auto below = run({"status", "--json"}).json();
    EXPECT_EQ(below["position"]["psi_turns"], -3);
    EXPECT_GE(below["position"]["psi_deg"].get<double>(), 0.0);
    EXPECT_LT(below["position"]["psi_deg"].get<double>(), 360.0);
    write("other.toml", "[axis.psi]\npulses_per_rev = 3200\n");
    EXPECT_EQ(run({"status", "--json", "--profile", file("other.toml")}).json()["position"], nullptr)
        << "degrees of another machine";
}

}  // namespace
}  // namespace psicarve::test
