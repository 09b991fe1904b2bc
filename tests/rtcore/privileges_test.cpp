// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/privileges.hpp"

#include <grp.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <string>

namespace psicarve::rtcore {
namespace {

constexpr const char* kOrdinaryUser = "nobody";
constexpr const char* kAnotherUser = "daemon";

/// In a process of its own that is an ordinary user's, whoever runs the test: 0 where it holds.
int as_ordinary_user(const std::function<bool(const std::string& own_name)>& holds) {
    const bool is_root = ::geteuid() == 0;
    const passwd own = *::getpwuid(::geteuid());
    const std::string own_name = is_root ? kOrdinaryUser : own.pw_name;
    const passwd ordinary = *::getpwnam(own_name.c_str());
    const pid_t child = ::fork();
    if (child == 0) {
        if (is_root && (::setgroups(0, nullptr) != 0 || ::setgid(ordinary.pw_gid) != 0 ||
                        ::setuid(ordinary.pw_uid) != 0))
            ::_exit(1);
        ::_exit(holds(own_name) ? 0 : 2);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return status;
}

std::string refusal_of(const std::string& user) {
    const auto changed = become_user(user);
    return changed ? "" : changed.error().message;
}

TEST(BecomeUser, IsForRootAlone) {
    EXPECT_EQ(as_ordinary_user([](const std::string&) {
                  return refusal_of(kAnotherUser).find("only root") != std::string::npos;
              }),
              0);
}

TEST(BecomeUser, ChangesNothingForThatUserItself) {
    EXPECT_EQ(as_ordinary_user([](const std::string& own_name) { return refusal_of(own_name).empty(); }), 0);
}

TEST(BecomeUser, RefusesRootAndUnknownUsers) {
    EXPECT_EQ(refusal_of("root"), "--user root: the core is to go on as another user than root");
    EXPECT_EQ(refusal_of("no-such-user"), "--user no-such-user: there is no such user");
}

}  // namespace
}  // namespace psicarve::rtcore
