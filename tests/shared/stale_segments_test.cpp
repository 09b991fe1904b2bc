// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/shared/stale_segments.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "tests/shared/segment_fixture.hpp"

namespace psicarve {
namespace {

std::uint64_t own_namespace() {
    struct stat facts {};
    EXPECT_EQ(::stat("/proc/self/ns/pid", &facts), 0);
    return facts.st_ino;
}
std::string name_of_process(std::uint64_t pid_namespace, pid_t pid) {
    return std::string{test::kTestSegmentPrefix} + std::to_string(pid_namespace) + "-" + std::to_string(pid);
}

TEST(StaleSegments, AreRemovedOfDeadProcessesAlone) {
    const pid_t dead = ::fork();
    if (dead == 0) ::_exit(0);
    int end = 0;
    ASSERT_EQ(::waitpid(dead, &end, 0), dead);
    const test::SegmentName own;
    SegmentOptions left = own.options();
    left.name = "/" + name_of_process(own_namespace(), dead) + "-1";
    // In a container that shares our /dev/shm a process may well have that pid.
    SegmentOptions foreign = own.options();
    foreign.name = "/" + name_of_process(own_namespace() + 1, dead) + "-1";
    for (const SegmentOptions& options : {own.options(), left, foreign}) {
        ASSERT_TRUE(Segment::create_or_attach(options).has_value()) << options.name;
    }
    test::remove_stale_segments();
    EXPECT_TRUE(Segment::attach(own.get()).has_value());
    EXPECT_FALSE(Segment::attach(left.name).has_value());
    EXPECT_TRUE(Segment::attach(foreign.name).has_value());
    (void)Segment::remove(left.name).has_value();
    (void)Segment::remove(foreign.name).has_value();
}

TEST(StaleSegments, OnlyAWholeNameTellsOfADeadProcess) {
    const std::string prefix{test::kTestSegmentPrefix};
    const std::string space = std::to_string(own_namespace());
    constexpr const char* kNobody = "4194305";  // above the kernel's largest pid
    EXPECT_TRUE(is_named_after_dead_process(prefix + space + "-" + kNobody, prefix));
    EXPECT_TRUE(is_named_after_dead_process(prefix + space + "-" + kNobody + "-7", prefix));
    EXPECT_FALSE(is_named_after_dead_process(named_after_this_process(prefix), prefix));
    for (const std::string& name :
         {std::string{}, prefix, prefix + space, prefix + kNobody, prefix + space + "-",
          prefix + space + "-0", prefix + space + "--5", prefix + space + "-" + kNobody + "x",
          "x" + prefix + space + "-" + kNobody}) {
        EXPECT_FALSE(is_named_after_dead_process(name, prefix)) << name;
    }
}

}  // namespace
}  // namespace psicarve
