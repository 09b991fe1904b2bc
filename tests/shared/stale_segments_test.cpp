// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/shared/stale_segments.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "tests/shared/segment_fixture.hpp"

namespace psicarve {
namespace {

TEST(StaleSegments, AreRemovedOfDeadProcessesAlone) {
    const pid_t dead = ::fork();
    if (dead == 0) ::_exit(0);
    int end = 0;
    ASSERT_EQ(::waitpid(dead, &end, 0), dead);
    const test::SegmentName own;
    SegmentOptions left = own.options();
    left.name = "/psicarve-test-" + std::to_string(dead) + "-1";
    ASSERT_TRUE(Segment::create_or_attach(own.options()).has_value());
    ASSERT_TRUE(Segment::create_or_attach(left).has_value());
    test::remove_stale_segments();
    EXPECT_TRUE(Segment::attach(own.get()).has_value());
    EXPECT_FALSE(Segment::attach(left.name).has_value());
    (void)Segment::remove(left.name).has_value();
}

}  // namespace
}  // namespace psicarve
