// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/file/atomic_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "shared/file/partial_file.hpp"
#include "tests/shared/child_signals.hpp"
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

// As /dev/stdout is one: by /proc/self/fd/1 to the file of a redirection.
TEST_F(AtomicFile, LinkToAnOpenDescriptorIsRefusedAndStays) {
    const OpenFile open_file{::open(file_.c_str(), O_RDWR | O_CLOEXEC)};
    const std::string descriptor = "/proc/self/fd/" + std::to_string(open_file.get());
    std::filesystem::create_symlink(descriptor, folder_.path("direct"));
    std::filesystem::create_symlink("direct", folder_.path("stdout"));
    std::filesystem::create_symlink("/proc/self/fd", folder_.path("fd"));
    std::filesystem::create_symlink("/proc/self/fd/987654", folder_.path("closed"));
    const std::string by_folder = folder_.path("fd/") + std::to_string(open_file.get());
    for (const std::string& path :
         {descriptor, folder_.path("direct"), folder_.path("stdout"), by_folder, folder_.path("closed")}) {
        const std::string said =
            path + ": is an open descriptor, not a file's name: use - for standard output";
        EXPECT_THAT(check_writable(path).error().message, HasSubstr(said));
        EXPECT_THAT(write_file_atomically(path, bytes_of('n', 10)).error().message, HasSubstr(said));
        EXPECT_TRUE(std::filesystem::is_symlink(std::filesystem::symlink_status(path)) ||
                    path == folder_.path("closed"));
    }
    EXPECT_TRUE(std::filesystem::is_symlink(folder_.path("closed")));
    EXPECT_EQ(content(), old_);
}

TEST_F(AtomicFile, LinkThatLeadsNowhereOrInACircleIsReplacedOrRefused) {
    std::filesystem::create_symlink("nowhere", folder_.path("link"));
    ASSERT_TRUE(write_file_atomically(folder_.path("link"), old_).has_value());
    EXPECT_FALSE(std::filesystem::is_symlink(folder_.path("link")));

    std::filesystem::create_symlink("circle", folder_.path("circle"));
    EXPECT_FALSE(write_file_atomically(folder_.path("circle"), old_).has_value());
}

void put_rows(std::FILE* out) {
    for (int i = 0; i < 5000; ++i) std::fputc('r', out);
}

TEST_F(AtomicFile, StreamReplacesTheOldOneKeepsItsModeAndTouchesNothingElse) {
    ASSERT_EQ(::chmod(file_.c_str(), 0604), 0);
    std::ofstream(folder_.path("file.part")) << "mine";

    ASSERT_TRUE(write_stream_atomically(file_, put_rows).has_value());

    EXPECT_EQ(content(), bytes_of('r', 5000));
    EXPECT_EQ(mode_of(file_), 0604U);
    EXPECT_EQ(read_whole_file(folder_.path("file.part")).value().size(), 4U);
    EXPECT_EQ(folder_.file_count(), 2U);
}

TEST_F(AtomicFile, StreamRefusesWhatARenameWouldDestroy) {
    ASSERT_EQ(::mkfifo(folder_.path("pipe").c_str(), 0600), 0);
    EXPECT_THAT(write_stream_atomically(folder_.path("pipe"), put_rows).error().message,
                HasSubstr("is no regular file"));
    EXPECT_TRUE(std::filesystem::is_fifo(folder_.path("pipe")));
    EXPECT_THAT(write_stream_atomically(folder_.path(""), put_rows).error().message,
                HasSubstr("is a folder"));
}

TEST_F(AtomicFile, FullDiskLeavesTheOldOneIntact) {
    rlimit former{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &former), 0);
    rlimit small = former;
    small.rlim_cur = 4096;
    const auto former_handler = ::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);

    const auto written = write_file_atomically(file_, bytes_of('n', 100'000));
    const auto streamed = write_stream_atomically(file_, put_rows);

    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &former), 0);
    ::signal(SIGXFSZ, former_handler);
    ASSERT_FALSE(written.has_value());
    EXPECT_EQ(written.error().code, ErrorCode::out_of_room);
    EXPECT_THAT(written.error().message, HasSubstr(file_));
    ASSERT_FALSE(streamed.has_value());
    EXPECT_EQ(streamed.error().code, ErrorCode::out_of_room);
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
            test::be_a_usual_child();
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

/// The names in the folder, without that of the file itself.
std::vector<std::string> left_in(const test::TemporaryFolder& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path(""))) {
        if (entry.path().filename() != "file") names.push_back(entry.path().filename());
    }
    return names;
}

TEST_F(AtomicFile, WriterThatASignalEndsWhileItWritesLeavesNothing) {
    const Bytes large = bytes_of('n', 3'000'000);
    std::mt19937 random{20261126};
    std::uniform_int_distribution<useconds_t> delay_us{0, 30'000};
    for (int round = 0; round < 20; ++round) {
        const int number = round % 2 == 0 ? SIGINT : SIGTERM;
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            test::be_a_usual_child();
            remove_partials_when_killed();
            for (;;) (void)write_file_atomically(file_, large).has_value();
        }
        ::usleep(delay_us(random));
        ::kill(child, number);
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFSIGNALED(status));
        EXPECT_EQ(WTERMSIG(status), number) << "whoever waits sees what ended it";
        ASSERT_THAT(left_in(folder_), testing::IsEmpty()) << round;
    }
}

TEST_F(AtomicFile, IsNotSeenInItsFolderBeforeItIsWhole) {
    auto part = PartialFile::create(folder_of(file_), 0600);
    ASSERT_TRUE(part);
    EXPECT_THAT(left_in(folder_), testing::IsEmpty());
    ASSERT_EQ(::write(part->file().get(), "n", 1), 1);
    ASSERT_EQ(part->take_name(file_), 0);
    EXPECT_EQ(content(), bytes_of('n', 1));
    EXPECT_THAT(left_in(folder_), testing::IsEmpty());
}

// This is for file systems that know no file without a name.
TEST_F(AtomicFile, ASignalTakesAHiddenNameAway) {
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        test::be_a_usual_child();
        remove_partials_when_killed();
        const auto part = PartialFile::create_hidden(folder_of(file_), 0600);
        (void)!::write(ready[1], "r", 1);
        for (;;) ::pause();
    }
    char word = 0;
    ASSERT_EQ(::read(ready[0], &word, 1), 1);
    EXPECT_EQ(left_in(folder_).size(), 1U);
    ::kill(child, SIGINT);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(WTERMSIG(status), SIGINT);
    EXPECT_THAT(left_in(folder_), testing::IsEmpty());
    ::close(ready[0]);
    ::close(ready[1]);
}

// Another process that cleans the folder would have the lock, and remove the name before the file gets its
// own.
TEST_F(AtomicFile, AHiddenFileIsLockedUntilItHasItsName) {
    auto part = PartialFile::create_hidden(folder_of(file_), 0600);
    ASSERT_TRUE(part);
    ASSERT_EQ(part->take_name(file_), 0);
    const OpenFile other{::open(file_.c_str(), O_RDONLY | O_CLOEXEC)};
    EXPECT_EQ(::flock(other.get(), LOCK_EX | LOCK_NB), -1);
    EXPECT_EQ(errno, EWOULDBLOCK);
}

TEST_F(AtomicFile, WhatADeadProcessLeftIsSweptAndNothingElse) {
    const std::string folder = folder_of(file_);
    std::string left;
    std::string held;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        const auto part = PartialFile::create_hidden(folder, 0600);
        ::kill(::getpid(), SIGKILL);
    }
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    ASSERT_EQ(left_in(folder_).size(), 1U);
    left = left_in(folder_).front();
    const auto living = PartialFile::create_hidden(folder, 0600);
    ASSERT_TRUE(living);
    for (const std::string& name : left_in(folder_))
        if (name != left) held = name;
    const std::vector<std::string> others{".psicarve-1-2.tmp", ".psicarve-x.part", "mine.part"};
    for (const std::string& name : others) std::ofstream(folder_.path(name)) << "kept";
    std::filesystem::create_symlink("mine.part", folder_.path(".psicarve-1-3.part"));

    ASSERT_TRUE(write_file_atomically(file_, old_));

    std::vector<std::string> wanted = others;
    wanted.push_back(held);
    wanted.emplace_back(".psicarve-1-3.part");
    EXPECT_THAT(left_in(folder_), testing::UnorderedElementsAreArray(wanted));
}

}  // namespace
}  // namespace psicarve
