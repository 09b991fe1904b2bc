// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/carve_queue.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/operator_break.hpp"

namespace psicarve::cli {
namespace {

/// Carves three jobs. The second is broken off when all of it is carved.
Result<int> carve_three(std::vector<std::string>& carved, const std::string& broken) {
    return carve_in_turn({"a.job", "b.job", "c.job"}, true, [&](const std::string& path) -> Result<int> {
        const OperatorBreak operator_break;
        carved.push_back(path);
        if (path == broken) raise(SIGINT);
        return kExitDone;
    });
}

TEST(CarveQueue, EndsAfterTheWorkpieceInWhichTheOperatorBroke) {
    std::vector<std::string> carved;
    const auto outcome = carve_three(carved, "b.job");
    EXPECT_EQ(carved, (std::vector<std::string>{"a.job", "b.job"}));
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().code, ErrorCode::cancelled);
    EXPECT_NE(outcome.error().message.find("c.job"), std::string::npos) << outcome.error().message;
}

TEST(CarveQueue, IsDoneWhenTheLastWasBrokenTooLate) {
    std::vector<std::string> carved;
    const auto outcome = carve_three(carved, "c.job");
    ASSERT_TRUE(outcome);
    EXPECT_EQ(*outcome, kExitDone);
    EXPECT_EQ(carved.size(), 3U);
}

TEST(CarveQueue, OwesNothingToABreakBeforeIt) {
    std::vector<std::string> carved;
    (void)carve_three(carved, "a.job");
    carved.clear();
    EXPECT_TRUE(carve_three(carved, ""));
    EXPECT_EQ(carved.size(), 3U);
}

}  // namespace
}  // namespace psicarve::cli
