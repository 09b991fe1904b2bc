// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/file/distinct_files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve {
namespace {

class DistinctFiles : public ::testing::Test {
protected:
    DistinctFiles() {
        std::ofstream(path("a")) << "a";
        std::ofstream(path("b")) << "b";
        std::filesystem::create_directory(path("sub"));
        std::filesystem::create_symlink("a", path("link"));
        std::filesystem::create_hard_link(path("a"), path("hard"));
        std::filesystem::create_symlink("new", path("dangling"));
        std::filesystem::create_directory_symlink(".", path("here"));
    }
    std::string path(const std::string& name) const { return folder_.path(name); }
    bool same(const std::string& one, const std::string& other) const {
        return is_same_file(path(one), path(other));
    }
    test::TemporaryFolder folder_;
};

TEST_F(DistinctFiles, KnowsOneFileByAllItsNames) {
    for (const char* name : {"a", "./a", "sub/../a", "link", "hard", "here/a", "here/here/link"})
        EXPECT_TRUE(same("a", name)) << name;
    EXPECT_FALSE(same("a", "b"));
}

TEST_F(DistinctFiles, KnowsAFileThatIsNotThereYet) {
    for (const char* name : {"new", "./new", "sub/../new", "here/new", "dangling"})
        EXPECT_TRUE(same("new", name)) << name;
    EXPECT_FALSE(same("new", "newer"));
    EXPECT_FALSE(same("new", "a"));
    EXPECT_FALSE(same("new", "sub/new"));
    EXPECT_FALSE(same("nowhere/new", "nowhere/new")) << "cannot be written";
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder_.path(""));
    EXPECT_TRUE(is_same_file("new", "./new"));
    EXPECT_TRUE(is_same_file("new", path("new")));
    std::filesystem::current_path(before);
}

TEST_F(DistinctFiles, IsNothingWhereNothingCanBeLost) {
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    EXPECT_FALSE(same("pipe", "pipe"));
    EXPECT_FALSE(same("sub", "sub"));
    EXPECT_FALSE(is_same_file("/dev/null", "/dev/null"));
    EXPECT_FALSE(is_same_file("-", "-"));
    EXPECT_FALSE(is_same_file("", ""));
}

TEST_F(DistinctFiles, RefusesWhatIsWrittenAndReadOrWrittenTwiceAndNamesBoth) {
    const NamedFile read{"MODEL", path("a"), false};
    const NamedFile written{"--trace", path("link"), true};
    const NamedFile elsewhere{"--picture", path("b"), true};
    const NamedFile twice{"--piece", path("hard"), true};
    EXPECT_TRUE(check_distinct(std::array{read, read, elsewhere}));
    for (const auto& files : {std::array{read, elsewhere, written}, std::array{written, read, elsewhere}}) {
        const auto refused = check_distinct(files);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::bad_usage);
        EXPECT_EQ(refused.error().message, "--trace " + path("link") + " and MODEL " + path("a") +
                                               " are one file, and what is read there would be lost: choose "
                                               "another name");
    }
    const auto both = check_distinct(std::array{written, twice});
    ASSERT_FALSE(both);
    EXPECT_NE(both.error().message.find("--trace"), std::string::npos);
    EXPECT_NE(both.error().message.find("and --piece " + path("hard") + " are one file, and only one"),
              std::string::npos);
}

}  // namespace
}  // namespace psicarve
