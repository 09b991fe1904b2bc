// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/log_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve::session {
namespace {

std::string content_of(const std::string& path) {
    std::ifstream stream{path};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

Message message_at(std::chrono::milliseconds time, Severity severity) {
    return {std::chrono::system_clock::time_point{time}, severity, phrase("Switch %1 is closed", "R2"),
            phrase("Clear it")};
}

TEST(LogLine, SaysWhenHowBadAndWhatToDoInOneLine) {
    EXPECT_EQ(log_line(message_at(std::chrono::milliseconds{1'000'000'000'123}, Severity::alarm)),
              "2001-09-09T01:46:40.123Z alarm   Switch R2 is closed: Clear it\n");
    Message message = message_at(std::chrono::milliseconds{0}, Severity::info);
    message.what = phrase("%1", "two\nlines");
    message.remedy = {};
    EXPECT_EQ(log_line(message), "1970-01-01T00:00:00.000Z info    two lines\n");
    message.axes = "R1 R2";
    EXPECT_EQ(log_line(message), "1970-01-01T00:00:00.000Z info    two lines (R1 R2)\n");
}

TEST(StateFolder, IsTheUsersOwn) {
    EXPECT_EQ(state_folder("/var/state", "/home/a"), "/var/state/psicarve");
    EXPECT_EQ(state_folder(nullptr, "/home/a"), "/home/a/.local/state/psicarve");
    EXPECT_EQ(state_folder("relative", "/home/a"), "/home/a/.local/state/psicarve");
    EXPECT_EQ(state_folder("", nullptr), "");
}

TEST(LogFile, BecomesAnOldOneWhenItIsFullAndTheOldestGoes) {
    const psicarve::test::TemporaryFolder folder;
    const std::string path = folder.path("below/psicarve.log");
    LogFile sut{path, 10};
    for (const char* line : {"first\n", "second\n", "third\n", "fourth\n"}) ASSERT_TRUE(sut.add(line));
    EXPECT_EQ(content_of(path), "fourth\n");
    EXPECT_EQ(content_of(path + ".1"), "third\n");
    EXPECT_EQ(content_of(path + ".2"), "second\n");
    EXPECT_FALSE(std::filesystem::exists(path + ".3"));
    LogFile again{path, 100};
    ASSERT_TRUE(again.add("fifth\n"));
    EXPECT_EQ(content_of(path), "fourth\nfifth\n");
}

TEST(LogKeeper, WritesEveryMessageOnce) {
    const psicarve::test::TemporaryFolder folder;
    MessageLog log;
    {
        LogKeeper sut{folder.path("state")};
        for (int i = 0; i < 50; ++i) {
            log.add(Severity::info, phrase("message %1", std::to_string(i)));
            if (i % 3 == 0) sut.poll(log);
        }
        sut.poll(log);
    }
    const std::string text = content_of(folder.path("state/psicarve-hmi.log"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 50);
    EXPECT_LT(text.find("message 0\n"), text.find("message 49\n"));
}

TEST(LogKeeper, LeavesOutWhatIsFromBeforeUnlessItStillStands) {
    const psicarve::test::TemporaryFolder folder;
    MessageLog log;
    {
        LogKeeper sut{folder.path("state")};
        Message message = message_at(std::chrono::milliseconds{1'000'000'000'123}, Severity::alarm);
        message.is_from_before = true;
        log.add(message);
        message.what = phrase("this one");
        message.is_standing = true;
        log.add(message);
        sut.poll(log);
    }
    EXPECT_EQ(content_of(folder.path("state/psicarve-hmi.log")),
              "2001-09-09T01:46:40.123Z alarm   this one: Clear it\n");
}

TEST(LogKeeper, SaysOnceThatItCannotWrite) {
    const psicarve::test::TemporaryFolder folder;
    std::ofstream{folder.path("in_the_way")} << "a file, no folder";
    MessageLog log;
    LogKeeper sut{folder.path("in_the_way")};
    log.add(Severity::info, phrase("one"));
    for (int i = 0; i < 5000 && log.count() < 2; ++i) {
        sut.poll(log);
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    ASSERT_EQ(log.count(), 2U);
    EXPECT_NE(in_english(log.messages().back().what).find("The log is not kept"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::session
