// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/journal_history.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "shared/record/journal_file.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::session {
namespace {

constexpr std::int64_t kHistoryBegin_ms = 1'764'204'185'123;

class History : public ::testing::Test {
protected:
    JournalFiles files(bool is_simulator = true) const {
        return JournalFiles{StateNames{folder_.path("."), "/history", is_simulator}};
    }
    void add(std::uint64_t run, JournalKind kind, const std::string& what, const JournalFacts& facts = {}) {
        JournalRecord record;
        record.sequence = ++sequence_;
        record.run = run;
        record.time_ms = kHistoryBegin_ms + static_cast<std::int64_t>(sequence_) * 1000;
        record.tick = 100 * sequence_;
        record.kind = kind;
        record.what = what;
        record.facts = facts;
        std::ofstream{files().newer, std::ios::app} << journal_line(record);
    }
    static std::chrono::system_clock::time_point second(int since_begin) {
        return std::chrono::system_clock::time_point{
            std::chrono::milliseconds{kHistoryBegin_ms + since_begin * 1000}};
    }
    void read(JournalHistory& sut) {
        while (!sut.is_read()) {
            sut.poll(log_);
            std::this_thread::sleep_for(std::chrono::milliseconds{1});
        }
        sut.poll(log_);
    }
    JournalHistory made(int opened_s = 1'000'000, std::size_t most = JournalHistory::kMost) {
        return JournalHistory{"/history", folder_.path("."), second(opened_s), most};
    }

    test::TemporaryFolder folder_;
    MessageLog log_;
    std::uint64_t sequence_ = 0;
};

TEST_F(History, IsThatOfEarlierRunsEachWithTheProcessOfItsCore) {
    add(1, JournalKind::core, "start", JournalFacts{}.add("pid", 11));
    add(1, JournalKind::alarm, "emergency stop");
    add(2, JournalKind::core, "start", JournalFacts{}.add("pid", 22));
    add(2, JournalKind::alarm, "emergency stop");
    JournalHistory sut = made();
    read(sut);
    ASSERT_EQ(sut.messages().size(), 4U);
    EXPECT_EQ(sut.messages()[1].place->core_pid, 11U);
    EXPECT_EQ(sut.messages()[3].place->core_pid, 22U);
    EXPECT_EQ(sut.messages()[3].place->tick, 400U);
    EXPECT_EQ(sut.messages()[3].time, second(4));
    EXPECT_TRUE(log_.messages().empty());
}

TEST_F(History, EndsWhereTheWindowItselfBeganToLook) {
    for (int i = 0; i < 5; ++i) add(1, JournalKind::core, "end");
    JournalHistory sut = made(4);
    read(sut);
    EXPECT_EQ(sut.messages().size(), 3U);
}

TEST_F(History, IsTheNewestAlone) {
    add(1, JournalKind::core, "start", JournalFacts{}.add("pid", 11));
    for (int i = 0; i < 20; ++i) add(1, JournalKind::alarm, "emergency stop");
    JournalHistory sut = made(1'000'000, 6);
    read(sut);
    ASSERT_EQ(sut.messages().size(), 6U);
    EXPECT_EQ(sut.messages().back().time, second(21));
    EXPECT_EQ(sut.messages().front().place->core_pid, 11U) << "whose start is left out";
}

TEST_F(History, ThatIsNotThereIsNoTrouble) {
    JournalHistory sut = made();
    read(sut);
    EXPECT_TRUE(sut.messages().empty());
    EXPECT_TRUE(log_.messages().empty());
}

TEST_F(History, ThatCannotBeReadSaysSoOnce) {
    std::filesystem::create_directory(files().newer);
    JournalHistory sut = made();
    read(sut);
    for (int i = 0; i < 3; ++i) sut.poll(log_);
    ASSERT_EQ(log_.messages().size(), 1U);
    EXPECT_EQ(log_.messages()[0].severity, Severity::warning);
    EXPECT_NE(in_english(log_.messages()[0].what).find("history is not shown in full"), std::string::npos);
}

TEST_F(History, LeavesDamagedRecordsOutAndCountsThem) {
    add(1, JournalKind::core, "end");
    std::ofstream{files().newer, std::ios::app} << "neither this\nnor that\n";
    add(1, JournalKind::core, "end");
    JournalHistory sut = made();
    read(sut);
    EXPECT_EQ(sut.messages().size(), 2U);
    ASSERT_EQ(log_.messages().size(), 1U);
    EXPECT_NE(in_english(log_.messages()[0].what).find(": 2"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::session
