// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/run_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hmi/cli/exit_code.hpp"

namespace psicarve::cli {
namespace {

RunReport verified_run() {
    RunReport report;
    report.has_started = true;
    report.last.is_simulator = 1;
    report.verification.emplace();
    report.verification->ok = true;
    return report;
}

TEST(RunReport, OfRightPinsIsVerified) {
    const RunReport sut = verified_run();
    EXPECT_EQ(nlohmann::json::parse(run_json(sut))["verified"], true);
    EXPECT_NE(run_text(sut).find("verified   yes"), std::string::npos);
    EXPECT_FALSE(verdict_of(sut));
}

TEST(RunReport, OfRightPinsThatTheMachineDidNotFollowIsNot) {
    RunReport sut = verified_run();
    sut.lost_steps = "r1 stalls 3";
    const auto json = nlohmann::json::parse(run_json(sut));
    EXPECT_EQ(json["verified"], false);
    EXPECT_EQ(json["verification"]["verified"], true);  // the pins alone
    EXPECT_NE(run_text(sut).find("verified   NO"), std::string::npos);
    EXPECT_NE(run_text(sut).find("STEPS LOST: r1 stalls 3"), std::string::npos);
    ASSERT_TRUE(verdict_of(sut));
    EXPECT_EQ(run_exit_code(sut, *verdict_of(sut)), kExitDifference);
}

TEST(RunReport, ThatWasNotVerifiedIsNeither) {
    RunReport sut = verified_run();
    sut.verification.reset();
    sut.lost_steps = "r1 stalls 3";
    EXPECT_TRUE(nlohmann::json::parse(run_json(sut))["verified"].is_null());
}

}  // namespace
}  // namespace psicarve::cli
