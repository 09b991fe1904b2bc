// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/process/state_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve::supervisor {
namespace {

namespace fs = std::filesystem;

struct FolderFacts {
    mode_t mode = 0;
    uid_t user = 0;
};

FolderFacts facts_of(const std::string& path) {
    struct stat facts {};
    EXPECT_EQ(stat(path.c_str(), &facts), 0) << path;
    return {facts.st_mode & 07777U, facts.st_uid};
}

class Umask {
public:
    explicit Umask(mode_t mask) : before_(umask(mask)) {}
    ~Umask() { umask(before_); }
    Umask(const Umask&) = delete;
    Umask& operator=(const Umask&) = delete;

private:
    mode_t before_;
};

TEST(StateFolder, IsForEverybodyToLookInto) {
    const psicarve::test::TemporaryFolder folder;
    const Umask strict{0077};
    ASSERT_TRUE(make_state_folder(folder.path("a/b/")));
    EXPECT_EQ(facts_of(folder.path("a/b")).mode, 0755U);
    // One that is there stays as it is.
    fs::create_directory(folder.path("c"));
    ASSERT_TRUE(make_state_folder(folder.path("c")));
    EXPECT_EQ(facts_of(folder.path("c")).mode, 0700U);
}

TEST(StateFolder, ChangesNothingWhereAnotherMayPutSomethingInItsPlace) {
    const psicarve::test::TemporaryFolder folder;
    fs::create_directory(folder.path("open"));
    ASSERT_EQ(chmod(folder.path("open").c_str(), 0777), 0);
    const Umask strict{0077};
    ASSERT_TRUE(make_state_folder(folder.path("open/state")));
    EXPECT_EQ(facts_of(folder.path("open/state")).mode, 0700U) << "as the umask has it";
    make_state_folder_for(folder.path("open/other"), 65534, 65534);
    EXPECT_FALSE(fs::exists(folder.path("open/other")));
}

TEST(StateFolder, OfAnotherUserIsMadeByRootAndNoLinkIsFollowed) {
    if (geteuid() != 0) GTEST_SKIP() << "only root makes it for others";
    const psicarve::test::TemporaryFolder folder;
    make_state_folder_for(folder.path("state"), 65534, 65534);
    EXPECT_EQ(facts_of(folder.path("state")).user, 65534U);
    EXPECT_EQ(facts_of(folder.path("state")).mode, 0755U);
    fs::create_directory(folder.path("roots"));
    ASSERT_EQ(chmod(folder.path("roots").c_str(), 0700), 0);
    fs::create_directory_symlink(folder.path("roots"), folder.path("link"));
    make_state_folder_for(folder.path("link"), 65534, 65534);
    EXPECT_EQ(facts_of(folder.path("roots")).user, 0U);
    EXPECT_EQ(facts_of(folder.path("roots")).mode, 0700U);
    // In a folder of the user's it is the user who makes it.
    ASSERT_EQ(chown(folder.path("roots").c_str(), 65534, 65534), 0);
    make_state_folder_for(folder.path("roots/state"), 65534, 65534);
    EXPECT_FALSE(fs::exists(folder.path("roots/state")));
}

}  // namespace
}  // namespace psicarve::supervisor
