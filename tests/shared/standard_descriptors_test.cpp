// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/standard_descriptors.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>

#include "tests/two_process/child_process.hpp"

namespace psicarve {
namespace {

using test::ChildProcess;

TEST(StandardDescriptors, ThatAreClosedAreTakenAndOthersStayAsTheyAre) {
    ChildProcess child{[](const ChildProcess::Signal&) {
        const int before = fcntl(STDERR_FILENO, F_GETFL);
        close(STDIN_FILENO);
        close(STDOUT_FILENO);
        keep_standard_descriptors_taken();
        ASSERT_GT(open("/dev/zero", O_RDONLY | O_CLOEXEC), STDERR_FILENO);
        char byte = 1;
        EXPECT_EQ(read(STDIN_FILENO, &byte, 1), 0);
        EXPECT_EQ(write(STDOUT_FILENO, &byte, 1), 1);
        EXPECT_EQ(fcntl(STDERR_FILENO, F_GETFL), before);
    }};
    EXPECT_TRUE(child.ends_well());
}

TEST(StandardDescriptors, OfAPipeEndWhereNobodyElseCanWriteToIt) {
    ChildProcess child{[](const ChildProcess::Signal&) {
        std::array<int, 2> input{};
        std::array<int, 2> other{};
        ASSERT_EQ(pipe(input.data()), 0);
        ASSERT_EQ(pipe(other.data()), 0);
        ASSERT_EQ(dup2(input[0], STDIN_FILENO), STDIN_FILENO);
        ASSERT_GT(dup(input[1]), 0);
        ASSERT_EQ(write(input[1], "a", 1), 1);
        close_writing_ends_of_standard_input();
        char byte = 0;
        EXPECT_EQ(read(STDIN_FILENO, &byte, 1), 1);
        ASSERT_EQ(fcntl(input[1], F_GETFD), -1);
        EXPECT_EQ(read(STDIN_FILENO, &byte, 1), 0);
        EXPECT_EQ(write(other[1], "a", 1), 1);
        EXPECT_NE(fcntl(input[0], F_GETFD), -1);
    }};
    EXPECT_TRUE(child.ends_well());
}

}  // namespace
}  // namespace psicarve
