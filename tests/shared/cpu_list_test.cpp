// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/cpu_list.hpp"

#include <gtest/gtest.h>

namespace psicarve {
namespace {

using Cpus = std::vector<int>;

TEST(CpuList, ReadsWhatTheKernelWrites) {
    EXPECT_EQ(cpus_from_list("\n"), Cpus{});
    EXPECT_EQ(cpus_from_list("3\n"), (Cpus{3}));
    EXPECT_EQ(cpus_from_list("0-2,5\n"), (Cpus{0, 1, 2, 5}));
    EXPECT_EQ(cpus_from_list("5,0-2,1"), (Cpus{0, 1, 2, 5}));
}

TEST(CpuList, RefusesEverythingElse) {
    for (const char* text : {"a", "1-", "-1", "3-1", "1,x", "0-99999999", "1 2", "nohz,1"}) {
        EXPECT_EQ(cpus_from_list(text), std::nullopt) << text;
    }
}

}  // namespace
}  // namespace psicarve
