// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/process/privileges.hpp"

#include <fcntl.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <string>

namespace psicarve::rtcore {
namespace {

constexpr const char* kOrdinaryUser = "nobody";
constexpr const char* kAnotherUser = "daemon";

/// In a process of its own that belongs to an ordinary user, whichever user runs the test: 0 where it holds.
int as_ordinary_user(const std::function<bool(const UserAccount& own)>& holds) {
    const bool is_root = ::geteuid() == 0;
    const passwd* const entry = is_root ? ::getpwnam(kOrdinaryUser) : ::getpwuid(::geteuid());
    if (entry == nullptr) return -2;
    const UserAccount own{entry->pw_name, entry->pw_uid, entry->pw_gid};
    const pid_t child = ::fork();
    if (child == 0) {
        if (is_root && (::setgroups(0, nullptr) != 0 || ::setgid(own.group) != 0 || ::setuid(own.user) != 0))
            ::_exit(1);
        ::_exit(holds(own) ? 0 : 2);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return status;
}

TEST(BecomeUser, IsForRootAlone) {
    EXPECT_EQ(as_ordinary_user([](const UserAccount&) {
                  const auto refused = become_user(*account_of(kAnotherUser));
                  return !refused && refused.error().code == ErrorCode::bad_usage &&
                         refused.error().message.find("only root") != std::string::npos;
              }),
              0);
}

TEST(BecomeUser, ChangesNothingForThatUserItself) {
    EXPECT_EQ(as_ordinary_user([](const UserAccount& own) {
                  const bool was_dumpable = ::prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) != 0;
                  return become_user(own).has_value() &&
                         (::prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) != 0) == was_dumpable;
              }),
              0);
}

TEST(BecomeUser, LeavesNothingInEffectBeforeItIsRaised) {
    if (::geteuid() != 0) GTEST_SKIP() << "needs root";
    const std::string roots = ::testing::TempDir() + "psicarve-roots-" + std::to_string(::getpid());
    const int file = ::open(roots.c_str(), O_CREAT | O_WRONLY, 0600);
    ASSERT_GE(file, 0);
    ::close(file);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto account = account_of(kOrdinaryUser);
        if (!account || !will_be_in_group(*account, account->group) || will_be_in_group(*account, 0))
            ::_exit(8);
        if (!become_user(*account)) ::_exit(1);
        if (::prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) != 0) ::_exit(2);
        if (::open(roots.c_str(), O_RDONLY) >= 0) ::_exit(3);
        if (is_in_group(0) || !is_in_group(account->group)) ::_exit(4);
        raise_privileges();
        if (::open(roots.c_str(), O_RDONLY) < 0) ::_exit(5);
        static_cast<void>(drop_privileges({}));
        if (::open(roots.c_str(), O_RDONLY) >= 0 || ::setuid(0) == 0) ::_exit(6);
        ::_exit(::prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) == 0 ? 0 : 7);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    ::unlink(roots.c_str());
    EXPECT_EQ(status, 0);
}

TEST(BecomeUser, RefusesRootAndUnknownUsers) {
    EXPECT_EQ(account_of("root").error().message,
              "--user root: the core is to go on as another user than root");
    EXPECT_EQ(account_of("no-such-user").error().message, "--user no-such-user: there is no such user");
}

}  // namespace
}  // namespace psicarve::rtcore
