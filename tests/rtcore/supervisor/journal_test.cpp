// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/journal/journal.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "rtcore/journal/journal_writer.hpp"
#include "shared/computer/process_identity.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace {
bool does_sync_fail = false;
}

/// In the place of the C library's: a disk whose error comes late.
extern "C" int fdatasync(int file) {
    if (!does_sync_fail) return static_cast<int>(::syscall(SYS_fdatasync, file));
    errno = EIO;
    return -1;
}

namespace psicarve::supervisor {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

JournalRecord core_record(const std::string& what) {
    JournalRecord record;
    record.time_ms = 1'764'204'185'123;
    record.what = what;
    return record;
}

bool is_once(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos && text.find(words) == text.rfind(words);
}

class JournalWriterTest : public ::testing::Test {
protected:
    void write(JournalWriter& sut, const std::string& what) {
        sut.note_given();
        sut.write(core_record(what));
    }
    std::vector<JournalRecord> records() const {
        auto read = read_journal(files_);
        return read ? std::move(*read) : std::vector<JournalRecord>{};
    }
    std::vector<std::string> whats() const {
        std::vector<std::string> words;
        for (const JournalRecord& record : records()) words.push_back(record.what);
        return words;
    }
    static JournalRecord core_of(const std::string& what, std::uint64_t run, const std::string& boot_id) {
        JournalRecord record = core_record(what);
        record.run = run;
        if (!boot_id.empty()) record.facts.add("boot", boot_id);
        return record;
    }
    void keep(const JournalRecord& record) const {
        fs::create_directories(place_.folder);
        std::ofstream{files_.newer, std::ios::app} << journal_line(record);
    }
    std::string before_of_last_start() const {
        std::string before;
        for (const JournalRecord& record : records())
            if (record.what == "start") before = record.facts.text("before");
        return before;
    }

    test::TemporaryFolder folder_;
    JournalPlace place_{folder_.path("state"), "/shop", true};
    JournalFiles files_{StateNames{folder_.path("state"), "/shop", true}};
};
using Words = std::vector<std::string>;

TEST_F(JournalWriterTest, NumbersGoOnOverRestarts) {
    for (int run = 0; run < 3; ++run) {
        JournalWriter sut{place_};
        write(sut, "start");
        write(sut, "end");
    }
    const auto all = records();
    ASSERT_EQ(all.size(), 6U);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].sequence, i + 1);
        EXPECT_EQ(all[i].run, i / 2 + 1);
    }
}

TEST_F(JournalWriterTest, AStartTellsHowTheRunBeforeEnded) {
    {
        JournalWriter sut{place_};
        write(sut, "start");
        EXPECT_EQ(before_of_last_start(), "none");
    }
    {
        JournalWriter sut{place_};
        write(sut, "start");
        EXPECT_EQ(before_of_last_start(), "killed");
        write(sut, "end");
    }
    JournalWriter sut{place_};
    write(sut, "start");
    EXPECT_EQ(before_of_last_start(), "in order");
}

TEST_F(JournalWriterTest, AnotherBootIsAComputerThatWasStartedAgain) {
    keep(core_of("start", 4, "another"));
    JournalWriter sut{place_};
    write(sut, "start");
    EXPECT_EQ(before_of_last_start(), "no end, started again");
    EXPECT_EQ(records().back().run, 5U);
}

TEST_F(JournalWriterTest, TheEndOfAnotherRunEndsNone) {
    keep(core_of("start", 4, current_boot_id()));
    keep(core_of("start", 5, current_boot_id()));
    keep(core_of("end", 4, ""));
    JournalWriter sut{place_};
    write(sut, "start");
    EXPECT_EQ(before_of_last_start(), "killed");
    EXPECT_EQ(records().back().run, 6U);
}

TEST_F(JournalWriterTest, ARunWhoseStartIsGoneIsOneAllTheSame) {
    keep(core_of("start", 4, current_boot_id()));
    keep(core_of("end", 4, ""));
    keep(core_of("missed ticks", 7, ""));
    {
        JournalWriter sut{place_};
        write(sut, "start");
        EXPECT_EQ(before_of_last_start(), "no end");
        EXPECT_EQ(records().back().run, 8U);
        write(sut, "end");
    }
    fs::remove(files_.newer);
    keep(core_of("end", 8, ""));
    JournalWriter sut{place_};
    write(sut, "start");
    EXPECT_EQ(before_of_last_start(), "in order");
    EXPECT_EQ(records().back().run, 9U);
}

TEST_F(JournalWriterTest, WhatCannotBeReadIsNotTheFirstOne) {
    fs::create_directories(place_.folder);
    const std::string other = folder_.path("other");
    std::ofstream{other} << journal_line(core_of("start", 4, ""));
    fs::create_symlink(other, files_.older);
    JournalWriter sut{place_};
    write(sut, "start");
    EXPECT_EQ(before_of_last_start(), "unknown");
    EXPECT_EQ(records().back().run, 1U);
}

TEST_F(JournalWriterTest, AnothersFileTakesNoHistoryAway) {
    keep(core_of("start", 4, ""));
    fs::rename(files_.newer, files_.older);
    const std::string other = folder_.path("other");
    std::ofstream{other} << "another's\n";
    fs::create_hard_link(other, files_.newer);
    const auto older_bytes = fs::file_size(files_.older);
    JournalWriter sut{place_};
    ::testing::internal::CaptureStderr();
    write(sut, "start");
    write(sut, "end");
    const std::string said = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(whats(), (Words{"start"}));
    EXPECT_EQ(fs::file_size(files_.older), older_bytes);
    EXPECT_EQ(fs::file_size(other), 10U);
    EXPECT_TRUE(is_once(said, "take one of them away")) << said;
    fs::remove(files_.newer);
    write(sut, "end");
    EXPECT_EQ(whats(), (Words{"start", "not written", "end"}));
}

TEST_F(JournalWriterTest, AFolderUnderTheNameIsToldOnceAndLeftAlone) {
    fs::create_directories(files_.newer);
    JournalWriter sut{place_};
    ::testing::internal::CaptureStderr();
    write(sut, "start");
    write(sut, "end");
    const std::string said = ::testing::internal::GetCapturedStderr();
    EXPECT_TRUE(fs::is_directory(files_.newer));
    EXPECT_TRUE(is_once(said, "is not written down")) << said;
}

TEST_F(JournalWriterTest, WhatIsWrittenButNotSyncedIsNotLost) {
    JournalWriter sut{place_};
    does_sync_fail = true;
    ::testing::internal::CaptureStderr();
    write(sut, "start");
    write(sut, "missed ticks");
    const std::string said = ::testing::internal::GetCapturedStderr();
    does_sync_fail = false;
    write(sut, "end");
    EXPECT_EQ(whats(), (Words{"start", "missed ticks", "end"}));
    EXPECT_TRUE(is_once(said, "may be lost at a power cut")) << said;
}

TEST_F(JournalWriterTest, ATornEndHidesNothing) {
    {
        JournalWriter sut{place_};
        write(sut, "start");
        write(sut, "missed ticks");
    }
    fs::resize_file(files_.newer, fs::file_size(files_.newer) - 3);
    JournalWriter sut{place_};
    write(sut, "start");
    EXPECT_EQ(whats(), (Words{"start", "start"}));
    EXPECT_EQ(before_of_last_start(), "killed");
}

TEST_F(JournalWriterTest, TwoFilesOfSoMuchAtMostAreKept) {
    constexpr std::uint64_t kMost = 2000;
    JournalWriter sut{place_, kMost};
    for (int i = 0; i < 200; ++i) write(sut, "missed ticks");
    EXPECT_LE(fs::file_size(files_.newer), kMost);
    EXPECT_LE(fs::file_size(files_.older), kMost);
    EXPECT_EQ(std::distance(fs::directory_iterator{place_.folder}, {}), 2);
    const auto all = records();
    ASSERT_GT(all.size(), 10U);
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].sequence, 200 - all.size() + 1 + i);
}

TEST_F(JournalWriterTest, EverybodyMayReadIt) {
    const mode_t before = ::umask(0077);
    JournalWriter sut{place_};
    write(sut, "start");
    ::umask(before);
    struct stat facts {};
    ASSERT_EQ(::stat(files_.newer.c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777U, 0644U);
    ASSERT_EQ(::stat(place_.folder.c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777U, 0755U);
}

TEST_F(JournalWriterTest, WritesThroughNoLinkAndIntoNoPipe) {
    fs::create_directories(place_.folder);
    const std::string other = folder_.path("other");
    std::ofstream{other} << "mine\n";
    fs::create_symlink(other, files_.newer);
    {
        JournalWriter sut{place_};
        write(sut, "start");
    }
    EXPECT_EQ(fs::file_size(other), 5U);
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(files_.newer)));
    // A second name of it is another's, too.
    fs::remove(files_.newer);
    fs::create_hard_link(other, files_.newer);
    JournalWriter linked{place_};
    write(linked, "start");
    EXPECT_EQ(fs::file_size(other), 5U);
    fs::remove(files_.newer);
    fs::remove(files_.older);
    ASSERT_EQ(::mkfifo(files_.newer.c_str(), 0600), 0);
    JournalWriter piped{place_};
    write(piped, "start");
    EXPECT_TRUE(fs::is_regular_file(files_.newer));
}

TEST_F(JournalWriterTest, AFullDiskIsCountedAndToldOfOnceThereIsRoom) {
    JournalWriter sut{place_};
    write(sut, "start");
    signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    // At every byte of a record.
    const std::uint64_t size = fs::file_size(files_.newer);
    std::int64_t lost = 0;
    for (std::uint64_t room = 0; room < 60; room += 7) {
        const rlimit narrow{size + room, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &narrow);
        write(sut, "missed ticks");
        ++lost;
        EXPECT_EQ(fs::file_size(files_.newer), size) << room;
    }
    setrlimit(RLIMIT_FSIZE, &before);
    sut.note_lost(false);
    write(sut, "end");
    EXPECT_EQ(whats(), (Words{"start", "not written", "end"}));
    EXPECT_EQ(records()[1].facts.number("count"), lost + 1);
    write(sut, "end");
    EXPECT_EQ(whats(), (Words{"start", "not written", "end", "end"}));
}

TEST_F(JournalWriterTest, GoesOnWhereItsFilesWereTakenAway) {
    JournalWriter sut{place_};
    write(sut, "start");
    fs::remove_all(place_.folder);
    write(sut, "end");
    ASSERT_EQ(whats(), (Words{"end"}));
    EXPECT_EQ(records()[0].sequence, 2U);
}

TEST(JournalAllowance, LetsSoManyThroughAtOnceAndCountsTheOthers) {
    JournalAllowance sut;
    const JournalAllowance::Time begin{seconds{1000}};
    int taken = 0;
    for (int i = 0; i < 10'000; ++i) taken += sut.take(begin) ? 1 : 0;
    EXPECT_EQ(taken, static_cast<int>(JournalAllowance::kMostAtOnce));
    EXPECT_EQ(sut.take_left_out(begin), 10'000U - JournalAllowance::kMostAtOnce);
    EXPECT_EQ(sut.take_left_out(begin), 0U);
}

TEST(JournalAllowance, AFloodOfADayIsAFewMegabytes) {
    JournalAllowance sut;
    const JournalAllowance::Time begin{seconds{1000}};
    std::uint64_t written = 0;
    std::uint64_t told = 0;
    std::uint64_t left_out = 0;
    std::uint64_t asked = 0;
    for (int second = 0; second < 86'400; ++second) {
        const auto now = begin + seconds{second};
        for (int i = 0; i < 20; ++i, ++asked) written += sut.take(now) ? 1 : 0;
        const std::uint64_t told_of = sut.take_left_out(now);
        told += told_of > 0 ? 1 : 0;
        left_out += told_of;
    }
    EXPECT_EQ(written, JournalAllowance::kMostAtOnce + 86'399 / 10);
    EXPECT_LE(told, 86'400U / 60);
    EXPECT_EQ(written + left_out + sut.take_rest(), asked);
    // Two files hold it, and what was before it.
    EXPECT_LT((written + told) * 300, kMostJournalBytes);
}

class JournalTest : public JournalWriterTest {
protected:
    JournalStart start() const { return {place_, 0x1234, "sim", true}; }
};

TEST_F(JournalTest, IsNoneWithoutAFolder) {
    Journal sut{{{"", "/shop", true}, 0, "sim", true}};
    sut.note_round({});
    sut.note_end({});
    EXPECT_FALSE(fs::exists(place_.folder));
}

TEST_F(JournalTest, MissedTicksAreToldOnceAMinuteAndAtTheEnd) {
    {
        Journal sut{start()};
        cycle::Sample sample{};
        for (int round = 0; round < 1000; ++round) {
            ++sample.missed_ticks;
            sut.note_round(sample);
        }
        sut.note_end(sample);
    }
    ASSERT_EQ(whats(), (Words{"start", "missed ticks", "missed ticks", "end"}));
    EXPECT_EQ(records()[1].facts.number("count"), 1);
    EXPECT_EQ(records()[2].facts.number("count"), 999);
    EXPECT_EQ(records()[2].facts.number("total"), 1000);
}

TEST_F(JournalTest, TheEndIsWrittenOnceItIsNoted) {
    Journal sut{start()};
    ReceivedCommand received{};
    received.command.kind = CommandKind::home;
    for (int i = 0; i < 400; ++i) sut.note_answer(received, AnswerKind::refused, {}, 5);
    sut.note_end({});
    const auto all = records();
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all.back().what, "end");
    // Nothing comes behind it.
    sut.note_end({});
    sut.note_round({});
    EXPECT_EQ(records().size(), all.size());
}

TEST_F(JournalTest, AFloodOfCommandsIsCountedInOneRecord) {
    {
        Journal sut{start()};
        ReceivedCommand received{};
        received.command.kind = CommandKind::home;
        received.sender_pid = static_cast<std::uint32_t>(::getpid());
        for (int i = 0; i < 3000; ++i) sut.note_answer(received, AnswerKind::refused, {}, 5);
        sut.note_end({});
    }
    const auto all = records();
    ASSERT_EQ(all.size(), JournalAllowance::kMostAtOnce + 3);
    EXPECT_EQ(all[1].what, "home");
    EXPECT_EQ(all[1].facts.number("uid"), std::int64_t{::geteuid()});
    EXPECT_EQ(all[all.size() - 2].what, "left out");
    EXPECT_EQ(all[all.size() - 2].kind, JournalKind::command);
    EXPECT_EQ(all[all.size() - 2].facts.number("count"), 3000 - JournalAllowance::kMostAtOnce);
}

}  // namespace
}  // namespace psicarve::supervisor
