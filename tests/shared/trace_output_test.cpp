// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/trace/trace_output.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <thread>
#include <utility>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve {
namespace {

class TraceOutputTest : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    static std::string content(const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

private:
    test::TemporaryFolder folder_;
};

TEST_F(TraceOutputTest, GathersAndWritesOutAtTheEnd) {
    const std::string file = path("out");
    std::string expected;
    {
        TraceOutput sut = TraceOutput::open(file).value();
        for (int i = 0; i < 100'000; ++i) {
            const std::string line = "line " + std::to_string(i) + "\n";
            sut.write(line);
            expected += line;
        }
        EXPECT_FALSE(sut.take_error());
    }
    EXPECT_EQ(content(file), expected);
}

TEST_F(TraceOutputTest, RefusesToFollowALink) {
    const std::string victim = path("victim");
    { TraceOutput::open(victim).value().write("precious"); }
    std::filesystem::create_symlink(victim, path("link"));
    const Result<TraceOutput> sut = TraceOutput::open(path("link"));
    ASSERT_FALSE(sut);
    EXPECT_NE(sut.error().message.find("symbolic link"), std::string::npos) << sut.error().message;
    EXPECT_EQ(content(victim), "precious");
}

TEST_F(TraceOutputTest, APipeThatNobodyReadsIsNotWaitedForWithoutEnd) {
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    const Result<TraceOutput> sut = TraceOutput::open(path("pipe"));
    ASSERT_FALSE(sut);
    EXPECT_EQ(sut.error().code, ErrorCode::bad_input);
    EXPECT_NE(sut.error().message.find("pipe: nobody reads this pipe"), std::string::npos)
        << sut.error().message;
}

TEST_F(TraceOutputTest, APipeThatIsReadTakesMoreThanItHolds) {
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    const std::string bytes(3'000'000, 'x');
    std::string got;
    std::thread reader{[&] { got = content(path("pipe")); }};
    {
        Result<TraceOutput> sut = TraceOutput::open(path("pipe"));
        EXPECT_TRUE(sut);
        if (sut) {
            sut->write(bytes);
            sut->flush();
            EXPECT_FALSE(sut->take_error());
        }
    }
    reader.join();
    EXPECT_EQ(got.size(), bytes.size());
}

TEST_F(TraceOutputTest, NamesAFolderThatIsNotThere) {
    const Result<TraceOutput> sut = TraceOutput::open(path("nowhere/out"));
    ASSERT_FALSE(sut);
    EXPECT_NE(sut.error().message.find("nowhere/out"), std::string::npos);
    EXPECT_EQ(sut.error().code, ErrorCode::bad_input);
}

TEST_F(TraceOutputTest, FullDiskIsOneErrorAndNothingElse) {
    TraceOutput sut = TraceOutput::open("/dev/full").value();
    for (int round = 0; round < 5; ++round) {
        sut.write(std::string(4'000, 'x'));
        sut.flush();
    }
    const auto error = sut.take_error();
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::out_of_room);
    EXPECT_NE(error->message.find("/dev/full"), std::string::npos);
    EXPECT_FALSE(sut.take_error()) << "said once";
}

/// Files of this process can grow no further than this while it lives: a disk that is full.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : former_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &former_);
        const rlimit limit{bytes, former_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &former_);
        std::signal(SIGXFSZ, former_handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    using Handler = void (*)(int);
    Handler former_handler_;
    rlimit former_{};
};

TEST_F(TraceOutputTest, FullDiskLeavesNoPartOfAFile) {
    const FileSizeLimit limit{10'000};
    TraceOutput sut = TraceOutput::open(path("out")).value();
    sut.write(std::string(8'000, 'x'));
    sut.flush();
    ASSERT_TRUE(std::filesystem::exists(path("out")));
    sut.write(std::string(4'000, 'x'));
    sut.flush();
    EXPECT_FALSE(std::filesystem::exists(path("out")));
    const auto error = sut.take_error();
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, ErrorCode::out_of_room);
    EXPECT_NE(error->message.find("was removed"), std::string::npos) << error->message;
}

TEST_F(TraceOutputTest, FullDiskLeavesAnotherFileThatHasGotTheName) {
    const FileSizeLimit limit{10'000};
    TraceOutput sut = TraceOutput::open(path("out")).value();
    std::filesystem::rename(path("out"), path("moved"));
    { TraceOutput::open(path("out")).value().write("precious"); }
    sut.write(std::string(12'000, 'x'));
    sut.flush();
    EXPECT_TRUE(sut.take_error());
    EXPECT_EQ(content(path("out")), "precious");
}

TEST_F(TraceOutputTest, GivesWhatHasGatheredToATaker) {
    std::string taken;
    {
        TraceOutput sut{
            [&taken](std::span<const std::uint8_t> bytes) { taken.append(bytes.begin(), bytes.end()); }};
        sut.write("one ");
        EXPECT_EQ(taken, "");
        sut.flush();
        EXPECT_EQ(taken, "one ");
        TraceOutput moved = std::move(sut);
        moved.write("two");
    }
    EXPECT_EQ(taken, "one two");
}

TEST_F(TraceOutputTest, WritesToAPipeThatAParentReads) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    {
        TraceOutput sut = TraceOutput::open("fd:" + std::to_string(ends[1])).value();
        EXPECT_TRUE((fcntl(ends[1], F_GETFD) & FD_CLOEXEC) != 0);
        sut.write("through");
    }
    std::array<char, 16> text{};
    EXPECT_EQ(read(ends[0], text.data(), text.size()), 7);
    EXPECT_EQ(read(ends[0], text.data(), text.size()), 0) << "closed with the writer";
    close(ends[0]);
}

TEST_F(TraceOutputTest, CountsWhatAPipeHasTakenWhileTheRestWaits) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    const auto room = static_cast<std::uint64_t>(fcntl(ends[1], F_GETPIPE_SZ));
    ASSERT_GT(room, 4096U);
    TraceOutput sut = TraceOutput::open("fd:" + std::to_string(ends[1])).value();
    const auto written = sut.written_bytes();
    std::thread writer{[&] {
        sut.write(std::string(2 * room, '#'));
        sut.flush();
    }};
    const auto reaches = [&](std::uint64_t bytes) {
        for (int n = 0; written->load() < bytes && n < 2000; ++n)
            std::this_thread::sleep_for(std::chrono::milliseconds{5});
        return written->load() == bytes;
    };
    EXPECT_TRUE(reaches(room)) << written->load();
    std::array<char, 4096> page{};
    EXPECT_EQ(read(ends[0], page.data(), page.size()), 4096);
    EXPECT_TRUE(reaches(room + 4096)) << written->load();
    for (std::uint64_t left = 2 * room - 4096; left > 0;)
        left -= static_cast<std::uint64_t>(read(ends[0], page.data(), page.size()));
    writer.join();
    EXPECT_EQ(written->load(), 2 * room);
    close(ends[0]);
}

TEST_F(TraceOutputTest, ReaderThatGoesAwayIsAnErrorAndNoSignal) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    std::signal(SIGPIPE, SIG_DFL);  // it would end this test
    TraceOutput sut = TraceOutput::open("fd:" + std::to_string(ends[1])).value();
    close(ends[0]);
    sut.write("to nobody");
    sut.flush();
    ASSERT_TRUE(sut.take_error());
    sigset_t pending;
    sigpending(&pending);
    EXPECT_EQ(sigismember(&pending, SIGPIPE), 0);
}

TEST_F(TraceOutputTest, RefusesDescriptorsThatCannotBeWritten) {
    for (const char* const name : {"fd:", "fd:x", "fd:1x", "fd:-1"}) {
        const Result<TraceOutput> sut = TraceOutput::open(name);
        ASSERT_FALSE(sut) << name;
        EXPECT_EQ(sut.error().code, ErrorCode::bad_usage) << name;
    }
    EXPECT_FALSE(TraceOutput::open("fd:987"));
    const int read_only = open("/dev/null", O_RDONLY | O_CLOEXEC);
    EXPECT_FALSE(TraceOutput::open("fd:" + std::to_string(read_only)));
    close(read_only);
}

}  // namespace
}  // namespace psicarve
