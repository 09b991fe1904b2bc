// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::byte>;

Bytes bytes_of(char fill, std::size_t count) {
    return Bytes(count, static_cast<std::byte>(fill));
}

unsigned mode_of(const std::string& path) {
    struct stat facts {};
    EXPECT_EQ(::stat(path.c_str(), &facts), 0);
    return facts.st_mode & 0777U;
}

class AtomicFile : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(write_file_atomically(file_, old_).has_value()); }
    Bytes content() const { return read_whole_file(file_).value(); }
    test::TemporaryFolder folder_;
    std::string file_ = folder_.path("file");
    Bytes old_ = bytes_of('o', 1000);
};

TEST_F(AtomicFile, ReplacesTheOldOneAndLeavesNothingElse) {
    ASSERT_TRUE(write_file_atomically(file_, bytes_of('n', 5000)).has_value());

    EXPECT_EQ(content(), bytes_of('n', 5000));
    EXPECT_EQ(folder_.file_count(), 1U);
}

TEST_F(AtomicFile, NewFileGetsWhatTheUmaskLeavesAndAnOldOneKeepsItsMode) {
    const mode_t former = ::umask(027);
    ASSERT_TRUE(write_file_atomically(folder_.path("new"), old_).has_value());
    ::umask(former);
    EXPECT_EQ(mode_of(folder_.path("new")), 0640U);

    ASSERT_EQ(::chmod(file_.c_str(), 0604), 0);
    ASSERT_TRUE(write_file_atomically(file_, old_).has_value());
    EXPECT_EQ(mode_of(file_), 0604U);
}

TEST_F(AtomicFile, SymbolicLinkIsReplacedNotFollowed) {
    std::filesystem::create_symlink(file_, folder_.path("link"));

    ASSERT_TRUE(write_file_atomically(folder_.path("link"), bytes_of('n', 10)).has_value());

    EXPECT_EQ(content(), old_);
    EXPECT_FALSE(std::filesystem::is_symlink(folder_.path("link")));
}

TEST_F(AtomicFile, FolderDeviceAndMissingFolderAreRefusedByName) {
    EXPECT_THAT(write_file_atomically(folder_.path(""), old_).error().message, HasSubstr("is a folder"));
    EXPECT_THAT(write_file_atomically("/dev/null", old_).error().message,
                HasSubstr("/dev/null: is no regular file"));
    EXPECT_THAT(write_file_atomically(folder_.path("a/b"), old_).error().message, HasSubstr("a/b: "));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(AtomicFile, FullDiskLeavesTheOldOneIntact) {
    rlimit former{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &former), 0);
    rlimit small = former;
    small.rlim_cur = 4096;
    const auto former_handler = ::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);

    const auto written = write_file_atomically(file_, bytes_of('n', 100'000));

    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &former), 0);
    ::signal(SIGXFSZ, former_handler);
    ASSERT_FALSE(written.has_value());
    EXPECT_EQ(written.error().code, ErrorCode::out_of_room);
    EXPECT_THAT(written.error().message, HasSubstr(file_));
    EXPECT_EQ(content(), old_);
    EXPECT_EQ(folder_.file_count(), 1U);
}

TEST_F(AtomicFile, WriterKilledAtAnyInstantLeavesTheOldOneOrTheNewOneWhole) {
    const Bytes fresh = bytes_of('n', 300'000);
    std::mt19937 random{20240611};
    std::uniform_int_distribution<useconds_t> delay_us{0, 3000};
    for (int round = 0; round < 60; ++round) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (;;) (void)write_file_atomically(file_, fresh).has_value();
        }
        ::usleep(delay_us(random));
        ::kill(child, SIGKILL);
        ASSERT_EQ(::waitpid(child, nullptr, 0), child);
        const Bytes found = content();
        ASSERT_TRUE(found == old_ || found == fresh) << round;
        ASSERT_TRUE(write_file_atomically(file_, old_).has_value());
    }
}

}  // namespace
}  // namespace psicarve
