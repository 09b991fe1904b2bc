// SPDX-License-Identifier: GPL-3.0-or-later
#include <random>

#include "tests/thoroughness.hpp"
#include "tests/two_process/cli_machine_rig.hpp"
#include "tests/two_process/quick_planning.hpp"

namespace psicarve::test {
namespace {

// The core has stopped, and its trace is read to the end: whenever that is, the second one costs nothing.
TEST_F(Machine, ASecondBreakAtAnyInstantLeavesTheReportAndTheWholeTrace) {
    const QuickPlanning quick{file("quick.toml")};
    std::mt19937 random{20261126};
    std::uniform_int_distribution<int> pause_ms{0, 300};
    const std::string job_path = long_job();
    const int rounds = is_thorough() ? 10 : 4;
    for (int round = 0; round < rounds; ++round) {
        RunningProgram carve{
            "psicarve", {"carve", job_path, "--segment", segment_, "--json", "--trace", file("pins.trace")}};
        ASSERT_TRUE(makes_it_carve(carve));
        carve.send(SIGINT);
        std::this_thread::sleep_for(std::chrono::milliseconds{pause_ms(random)});
        if (!carve.has_ended()) carve.send(SIGINT);
        ASSERT_EQ(carve.wait(), 4) << carve.error();
        EXPECT_TRUE(carve.error().find("stopped by the operator") != std::string::npos ||
                    carve.error().find("emergency stop by the operator") != std::string::npos)
            << carve.error();
        EXPECT_TRUE(nlohmann::json::accept(carve.out())) << carve.out();
        EXPECT_FALSE(core_pid().has_value());
        const Outcome verified = psicarve({"verify", job_path, file("pins.trace")});
        EXPECT_EQ(verified.exit_code, 6) << "whole, and not all of the job: " << verified.error;
        EXPECT_EQ(verified.error.find("cut off"), std::string::npos) << verified.error;
    }
}

}  // namespace
}  // namespace psicarve::test
