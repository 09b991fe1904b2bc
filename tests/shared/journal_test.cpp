// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/record/journal.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "shared/record/journal_file.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve {
namespace {

JournalRecord alarm_record(std::uint64_t sequence) {
    JournalRecord record;
    record.sequence = sequence;
    record.run = 3;
    record.time_ms = 1'764'204'185'123;
    record.tick = 120;
    record.kind = JournalKind::alarm;
    record.what = "limit";
    record.facts.add("axis", "r1").add("seen", -12).add("reason", "a \"quoted\" \\ word\nand é\x01");
    return record;
}

std::string without_end(std::string line) {
    line.pop_back();
    return line;
}

TEST(JournalLine, SaysAllOfARecord) {
    const JournalRecord before = alarm_record(7);
    const std::string line = journal_line(before);
    EXPECT_EQ(line.find('\n'), line.size() - 1);
    const auto sut = parse_journal_line(without_end(line));
    ASSERT_TRUE(sut.has_value());
    EXPECT_EQ(sut->sequence, 7U);
    EXPECT_EQ(sut->run, 3U);
    EXPECT_EQ(sut->time_ms, before.time_ms);
    EXPECT_EQ(sut->tick, 120U);
    EXPECT_EQ(sut->kind, JournalKind::alarm);
    EXPECT_EQ(sut->what, "limit");
    EXPECT_EQ(sut->facts.all(), before.facts.all());
}

TEST(JournalLine, TakesEveryNumberAndEveryByte) {
    JournalRecord record;
    record.facts.add("least", std::numeric_limits<std::int64_t>::min())
        .add("most", std::numeric_limits<std::int64_t>::max())
        .add("empty", "");
    std::string bytes;
    for (int byte = 0; byte < 128; ++byte) bytes += static_cast<char>(byte);
    record.facts.add("bytes", bytes);
    const auto sut = parse_journal_line(without_end(journal_line(record)));
    ASSERT_TRUE(sut.has_value());
    EXPECT_EQ(sut->facts.all(), record.facts.all());
}

TEST(JournalLine, IsBoundedWhateverIsTold) {
    JournalRecord record;
    for (int i = 0; i < 100; ++i) record.facts.add("fact" + std::to_string(i), std::string(5000, '\x01'));
    record.what = std::string(5000, '"');
    const std::string line = journal_line(record);
    EXPECT_LE(line.size(), kMostJournalLineBytes);
    EXPECT_TRUE(parse_journal_line(without_end(line)).has_value());
}

TEST(JournalLine, CutsATextBetweenLetters) {
    JournalRecord record;
    record.facts.add(
        "source", "a" + [] {
            std::string text;
            for (int i = 0; i < 200; ++i) text += "é";
            return text;
        }());
    const std::string cut = record.facts.text("source");
    EXPECT_EQ(cut.size(), 200U);
    EXPECT_TRUE(cut.ends_with("é...")) << cut;
    // A second time nothing is cut off.
    EXPECT_EQ(JournalFacts{}.add("source", cut).text("source"), cut);
}

TEST(JournalLine, IsNoRecordOnceAnyBitIsAnother) {
    const std::string line = without_end(journal_line(alarm_record(7)));
    for (std::size_t byte = 0; byte < line.size(); ++byte) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = line;
            damaged[byte] = static_cast<char>(static_cast<unsigned char>(damaged[byte]) ^ (1U << bit));
            EXPECT_FALSE(parse_journal_line(damaged).has_value()) << byte << ", " << bit;
        }
    }
}

class JournalFilesTest : public ::testing::Test {
protected:
    void write(const std::string& path, const std::string& text, bool appends = false) const {
        std::ofstream{path, appends ? std::ios::app : std::ios::trunc} << text;
    }
    static std::vector<std::uint64_t> sequences(const Result<std::vector<JournalRecord>>& records) {
        std::vector<std::uint64_t> numbers;
        if (!records) return {999};
        for (const JournalRecord& record : *records) numbers.push_back(record.sequence);
        return numbers;
    }
    static std::string line(std::uint64_t sequence) { return journal_line(alarm_record(sequence)); }

    test::TemporaryFolder folder_;
    JournalFiles files_{StateNames{folder_.path(""), "/shop", false}};
};
using Numbers = std::vector<std::uint64_t>;

TEST_F(JournalFilesTest, AreOfOneSegmentAndOneKindOfMachine) {
    std::vector<std::string> names;
    for (const char* segment : {"/a", "/a.simulated", "/a.older", "/a.journal", "/a.simulated-journal"}) {
        for (const bool is_simulated : {false, true}) {
            const JournalFiles files{StateNames{"/f", segment, is_simulated}};
            names.push_back(files.newer);
            names.push_back(files.older);
            names.push_back(StateNames{"/f", segment, is_simulated}.checkpoint());
        }
    }
    std::ranges::sort(names);
    EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

TEST_F(JournalFilesTest, TornAtEveryByteOfTheLastRecordTheOthersAreRead) {
    const std::string first = line(1) + line(2);
    const std::string last = line(3);
    for (std::size_t kept = 0; kept < last.size(); ++kept) {
        write(files_.newer, first + last.substr(0, kept));
        JournalTail sut{files_};
        ASSERT_EQ(sequences(sut.read_more()), (Numbers{1, 2})) << kept;
        // A core that goes on begins a new line.
        write(files_.newer, "\n" + line(4), true);
        EXPECT_EQ(sequences(sut.read_more()), (kept + 1 == last.size() ? Numbers{3, 4} : Numbers{4})) << kept;
        EXPECT_EQ(sut.damaged_count(), kept == 0 || kept + 1 == last.size() ? 0U : 1U) << kept;
        EXPECT_EQ(sequences(read_journal(files_)).size(), kept + 1 == last.size() ? 4U : 3U);
    }
}

TEST_F(JournalFilesTest, DamagedAtEveryByteOfTheMiddleTheOthersAreRead) {
    const std::string middle = line(2);
    for (std::size_t byte = 0; byte < middle.size(); ++byte) {
        for (const char wrong : {'\0', '\n', '"', '\xff'}) {
            std::string damaged = middle;
            if (damaged[byte] == wrong) continue;
            damaged[byte] = wrong;
            // Without its line feed the record behind it is of the same line.
            const bool takes_next = byte + 1 == middle.size();
            write(files_.newer, line(1) + damaged + line(3) + line(4));
            EXPECT_EQ(sequences(read_journal(files_)), (takes_next ? Numbers{1, 4} : Numbers{1, 3, 4}))
                << byte;
        }
    }
}

TEST_F(JournalFilesTest, MegabytesOfGarbageHideNothingBehindThem) {
    write(files_.newer, line(1) + std::string(3'000'000, '\0') + "\n" + line(2));
    EXPECT_EQ(sequences(read_journal(files_)), (Numbers{1, 2}));
}

TEST_F(JournalFilesTest, TheOlderOneIsReadFirst) {
    write(files_.older, line(1));
    write(files_.newer, line(2));
    EXPECT_EQ(sequences(read_journal(files_)), (Numbers{1, 2}));
    std::filesystem::remove(files_.newer);
    EXPECT_EQ(sequences(read_journal(files_)), (Numbers{1}));
}

TEST_F(JournalFilesTest, ATailGoesOnOverAnExchangeOfFiles) {
    JournalTail sut{files_};
    EXPECT_EQ(sequences(sut.read_more()), Numbers{});
    EXPECT_FALSE(sut.has_found_file());
    write(files_.newer, line(1));
    EXPECT_EQ(sequences(sut.read_more()), (Numbers{1}));
    for (std::uint64_t round = 1; round < 5; ++round) {
        write(files_.newer, line(10 * round), true);
        std::filesystem::rename(files_.newer, files_.older);
        write(files_.newer, line(10 * round + 1));
        EXPECT_EQ(sequences(sut.read_more()), (Numbers{10 * round, 10 * round + 1}));
        EXPECT_EQ(sequences(sut.read_more()), Numbers{});
    }
}

TEST_F(JournalFilesTest, ATailMissesNoneOfTwoExchanges) {
    JournalTail sut{files_};
    write(files_.newer, line(1));
    EXPECT_EQ(sequences(sut.read_more()), (Numbers{1}));
    for (std::uint64_t sequence = 2; sequence < 4; ++sequence) {
        std::filesystem::rename(files_.newer, files_.older);
        write(files_.newer, line(sequence));
    }
    EXPECT_EQ(sequences(sut.read_more()), (Numbers{2, 3}));
}

TEST_F(JournalFilesTest, ATailReadsNothingTwiceWhereTheNewerOneIsTakenAway) {
    write(files_.older, line(1));
    write(files_.newer, line(2));
    JournalTail sut{files_};
    EXPECT_EQ(sequences(sut.read_more()), (Numbers{1, 2}));
    std::filesystem::remove(files_.newer);
    EXPECT_EQ(sequences(sut.read_more()), Numbers{});
    write(files_.newer, line(3));
    EXPECT_EQ(sequences(sut.read_more()), (Numbers{3}));
}

TEST_F(JournalFilesTest, WhatIsNoFileIsRefusedAndNeverWaitedFor) {
    ASSERT_EQ(::mkfifo(files_.newer.c_str(), 0600), 0);
    EXPECT_FALSE(read_journal(files_).has_value());
}

TEST_F(JournalFilesTest, AFileThatCannotBeReadHidesNothingOfTheOther) {
    std::filesystem::create_directory(files_.older);
    write(files_.newer, line(1));
    JournalTail sut{files_};
    EXPECT_EQ(sequences(sut.read_more()), (Numbers{1}));
    write(files_.newer, line(2), true);
    EXPECT_EQ(sequences(sut.read_more()), (Numbers{2}));
    ASSERT_EQ(sut.errors().size(), 1U);
    EXPECT_NE(sut.errors()[0].message.find(files_.older), std::string::npos) << sut.errors()[0].message;
    // The other way round, and through no link.
    std::filesystem::remove(files_.older);
    std::filesystem::rename(files_.newer, files_.older);
    std::filesystem::create_symlink(files_.older, files_.newer);
    JournalTail linked{files_};
    EXPECT_EQ(sequences(linked.read_more()), (Numbers{1, 2}));
    EXPECT_EQ(linked.errors().size(), 1U);
}

}  // namespace
}  // namespace psicarve
