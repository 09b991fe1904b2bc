// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <string>
#include <utility>

#include "rtcore/guard/dying.hpp"
#include "rtcore/guard/guard_link.hpp"
#include "rtcore/guard/guard_page.hpp"

namespace psicarve::guard {
namespace {

std::string status_with(const std::string& state, const std::string& own, const std::string& shared) {
    return "Name:\tcore\nState:\t" + state + "\nPid:\t7\nSigPnd:\t" + own + "\nShdPnd:\t" + shared +
           "\nSigBlk:\tffffffffffffffff\n";
}

TEST(Dying, IsWhoHasAKillComing) {
    EXPECT_FALSE(says_dying(status_with("S (sleeping)", "0000000000000000", "0000000000000000")));
    EXPECT_TRUE(says_dying(status_with("D (disk sleep)", "0000000000000100", "0000000000000000")));
    EXPECT_TRUE(says_dying(status_with("T (stopped)", "0000000000000000", "0000000000000100")));
    EXPECT_FALSE(says_dying(status_with("T (stopped)", "0000000000000000", "0000000000004000"))) << "SIGTERM";
    EXPECT_TRUE(says_dying(status_with("Z (zombie)", "0000000000000000", "0000000000000000")));
    EXPECT_FALSE(says_dying(""));
}

TEST(Dying, AZombieIsAndWeAreNot) {
    EXPECT_FALSE(DyingWatch{getpid()}.is_dying());
    const pid_t child = fork();
    if (child == 0) {
        pause();
        _exit(0);
    }
    const DyingWatch sut{child};
    EXPECT_FALSE(sut.is_dying());
    kill(child, SIGKILL);
    siginfo_t ended{};
    ASSERT_EQ(waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT), 0);
    EXPECT_TRUE(sut.is_dying());
    waitpid(child, nullptr, 0);
    EXPECT_FALSE(sut.is_dying()) << "nor is whoever has its number next";
}

// As where /proc is mounted with hidepid: a core that only pauses must not be taken for one that was killed.
TEST(Dying, IsNobodyWhoCannotBeSeen) {
    EXPECT_FALSE(DyingWatch{0}.is_dying());
}

TEST(Silence, IsTooLongAfterTwoSecondsButNotWhileNobodyAsked) {
    using std::chrono::milliseconds;
    Silence sut;
    Silence::Time now{std::chrono::hours{1}};
    std::uint64_t count = 0;
    for (int look = 0; look < 1000; ++look) {
        ++count;
        for (int ask = 0; ask < 4; ++ask) EXPECT_FALSE(sut.is_too_long(count, now += milliseconds{5}));
    }
    EXPECT_FALSE(sut.is_too_long(count, now += std::chrono::hours{1})) << "the computer slept";
    int asked = 0;
    while (asked < 1000 && !sut.is_too_long(count, now += milliseconds{5})) ++asked;
    EXPECT_GT(asked, 300);
    EXPECT_LT(asked, 500);
    EXPECT_FALSE(sut.is_too_long(++count, now += milliseconds{5})) << "it goes on";
}

TEST(GuardLink, KnowsWhenTheGuardIsGoneAndThatItActed) {
    std::array<int, 2> from_guard{};
    std::array<int, 2> to_guard{};
    ASSERT_EQ(pipe2(from_guard.data(), O_CLOEXEC), 0);
    ASSERT_EQ(pipe2(to_guard.data(), O_CLOEXEC), 0);
    auto page = GuardPage::make();
    ASSERT_TRUE(page);
    const pid_t guard = fork();
    if (guard == 0) {
        // As a guard does that waits for two ticks, acts, and dies.
        while (!page->is_ticking() || page->ticks() < 2) usleep(1000);
        page->note_act();
        char byte = 0;
        const ssize_t got = read(to_guard[0], &byte, 1);
        _exit(got == 1 ? 0 : 1);
    }
    close(from_guard[1]);
    close(to_guard[0]);
    const int order = dup(to_guard[1]);
    {
        GuardLink sut{from_guard[0], to_guard[1], std::move(*page)};
        EXPECT_FALSE(sut.guard_has_acted());
        sut.set_ticking(true);
        sut.note_tick();
        sut.note_tick();
        while (!sut.guard_has_acted()) usleep(1000);
        EXPECT_FALSE(sut.guard_has_acted()) << "told once";
        EXPECT_FALSE(sut.is_guard_lost(Silence::Time{}));
        ASSERT_EQ(write(order, "x", 1), 1);
        int status = 0;
        waitpid(guard, &status, 0);
        EXPECT_EQ(status, 0);
        EXPECT_TRUE(sut.is_guard_lost(Silence::Time{}));
    }
    close(order);
}

}  // namespace
}  // namespace psicarve::guard
