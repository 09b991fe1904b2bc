// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "hmi/cli/program_watch.hpp"

namespace psicarve::cli {
namespace {

TEST(ToldHold, IsNewOnceForEachRecordAtWhichItHolds) {
    ToldHold sut;
    EXPECT_FALSE(sut.is_new(ProgramHold::none, 1));
    EXPECT_TRUE(sut.is_new(ProgramHold::optional, 5));
    EXPECT_FALSE(sut.is_new(ProgramHold::optional, 5));
    EXPECT_TRUE(sut.is_new(ProgramHold::optional, 7)) << "it was resumed between two looks";
    EXPECT_TRUE(sut.is_new(ProgramHold::program, 7));
    EXPECT_FALSE(sut.is_new(ProgramHold::none, 7));
    EXPECT_FALSE(sut.is_new(ProgramHold::none, 8));
    EXPECT_TRUE(sut.is_new(ProgramHold::program, 7));
}

}  // namespace
}  // namespace psicarve::cli
