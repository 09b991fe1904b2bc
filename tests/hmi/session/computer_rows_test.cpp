// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/computer_rows.hpp"

#include <gtest/gtest.h>

#include "shared/computer/realtime_step.hpp"

namespace psicarve::session {
namespace {

using V = ComputerRow::Verdict;

TEST(ComputerRows, TellEachStepOfTheTicksTreatmentAndWhatToDoWhereItWasRefused) {
    CoreStatus status{};
    status.realtime_asked = bit_of(RealtimeStep::lock_memory) | bit_of(RealtimeStep::scheduling);
    status.realtime_done = bit_of(RealtimeStep::scheduling);
    status.tick_priority = 80;
    const auto rows = realtime_rows(status);
    ASSERT_EQ(rows.size(), kAllRealtimeSteps.size());
    const auto row_of = [&](RealtimeStep step) { return rows[static_cast<std::size_t>(step)]; };
    const ComputerRow memory = row_of(RealtimeStep::lock_memory);
    EXPECT_EQ(memory.verdict, V::warning);
    EXPECT_EQ(in_english(memory.name), "memory locked");
    EXPECT_EQ(in_english(memory.seen), "refused");
    EXPECT_NE(in_english(memory.remedy).find("memlock unlimited"), std::string::npos);
    EXPECT_EQ(row_of(RealtimeStep::scheduling).verdict, V::good);
    EXPECT_EQ(in_english(row_of(RealtimeStep::scheduling).seen), "SCHED_FIFO, priority 80");
    EXPECT_EQ(in_english(row_of(RealtimeStep::tick_cpu).seen), "not asked for");
    EXPECT_TRUE(row_of(RealtimeStep::tick_cpu).remedy.is_empty());
}

TEST(ComputerRows, AreNoneOnTheVirtualClock) {
    CoreStatus status{};
    status.is_virtual_clock = 1;
    EXPECT_TRUE(realtime_rows(status).empty());
}

TEST(ComputerRows, SayWhatWasFoundAndWhyItMatters) {
    const auto rows = finding_rows(
        {doctor::fine("swap", "none"),
         {"clock", doctor::Verdict::problem, "hpet", "reading it takes long", "see the kernel"}});
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(in_english(rows[0].seen), "none");
    EXPECT_EQ(rows[0].verdict, V::good);
    EXPECT_TRUE(rows[0].remedy.is_empty());
    EXPECT_EQ(rows[1].verdict, V::problem);
    EXPECT_EQ(in_english(rows[1].seen), "hpet");
    EXPECT_EQ(in_english(rows[1].remedy), "reading it takes long: see the kernel");
}

}  // namespace
}  // namespace psicarve::session
