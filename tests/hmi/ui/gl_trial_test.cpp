// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/gl_trial.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve::ui {
namespace {

TEST(GlTrial, RemembersAProgramThatDidNotGetThrough) {
    const psicarve::test::TemporaryFolder folder;
    const GlTrial sut{folder.path("state")};
    EXPECT_FALSE(sut.has_crashed_before());
    sut.begin();
    EXPECT_FALSE(sut.has_crashed_before());  // it is us, and we live
    const pid_t crashed = ::fork();
    if (crashed == 0) {
        sut.begin();
        ::_exit(0);
    }
    int end = 0;
    ASSERT_EQ(::waitpid(crashed, &end, 0), crashed);
    EXPECT_TRUE(sut.has_crashed_before());
    sut.end();
    EXPECT_FALSE(sut.has_crashed_before());
    GlTrial{""}.begin();  // nowhere to remember
    EXPECT_FALSE(GlTrial{""}.has_crashed_before());
}

}  // namespace
}  // namespace psicarve::ui
